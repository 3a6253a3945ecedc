"""Collecting garbage while stacks are set aside.

By itself, Python 3.14 does that in steps which begin at the frames of all stacks. Of two stacks one
lies where the other was, so such a step follows what is not there: it never ends, or breaks all. A
collection that is asked for, of what is young or of everything, does not look at frames.
"""

from __future__ import annotations

import gc

# So many new objects (beside those that went) are looked through at once.
YOUNG = 5000
# All of them are, when so many more have stayed than there were; less is not worth it.
GROWTH = 0.25
FEW = 50_000

_stacks = 0
_ours = False
_old = FEW
_stayed = 0


def begin() -> None:
    """One more stack begins; called before it does."""
    global _stacks, _ours
    _stacks += 1
    if _stacks > 1 and gc.isenabled():
        _ours = True
        gc.disable()


def end() -> None:
    """A stack ends. What is left may be set aside, so nothing is collected yet."""
    global _stacks
    _stacks -= 1


def look() -> None:
    """Collect what has become much; called by a stack that goes on."""
    global _ours, _old, _stayed
    if not _ours:
        return
    if _stacks == 1:
        _ours = False
        gc.enable()
        return
    young = gc.get_count()[0]
    if young < YOUNG:
        return
    _stayed += young - gc.collect(0)
    if _stayed > _old * GROWTH:
        _old = max(FEW, _old + _stayed - gc.collect())
        _stayed = 0
