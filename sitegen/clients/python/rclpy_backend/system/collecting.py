"""Collect garbage while stacks are suspended.

Python 3.14 collects in steps that start from the frames of all stacks. A suspended stack is not in
memory where its frames point, since another stack has taken its place. So such a step may loop
forever or corrupt memory. An explicit collection, of young or of all objects, ignores frames.
"""

from __future__ import annotations

import gc

# Number of new objects, less those freed, that starts a collection of the young generation.
YOUNG = 5000
# A full collection starts when the surviving objects have grown by this share, from FEW on.
GROWTH = 0.25
FEW = 50_000

_stacks = 0
_ours = False
_old = FEW
_stayed = 0


def begin() -> None:
    """Count a new stack; call this before it starts."""
    global _stacks, _ours
    _stacks += 1
    if _stacks > 1 and gc.isenabled():
        _ours = True
        gc.disable()


def end() -> None:
    """Count the end of a stack. The others may be suspended, so collect nothing yet."""
    global _stacks
    _stacks -= 1


def stacks() -> int:
    """Return the number of stacks."""
    return _stacks


def look() -> None:
    """Collect garbage if there are enough new objects; call this from a stack that resumes."""
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
