"""Tracebacks as Python writes them on a robot."""

from __future__ import annotations

import code
import importlib
import traceback
from collections.abc import Iterator

# What starts programs, and what stands in for a library in C++.
OURS = __file__.rpartition("/")[0]
STARTERS = (code.__file__, importlib.__file__, "<frozen runpy>")


def traceback_of(error: BaseException) -> str:
    """Return the traceback of an exception that left a program.

    It begins in the program. An interrupt does not tell where in a page Python waits, either.
    """
    told = traceback.TracebackException.from_exception(error)
    told.stack = traceback.StackSummary.from_list(list(_shown(told.stack, error)))
    return "".join(told.format())


def _shown(
    frames: traceback.StackSummary, error: BaseException
) -> Iterator[traceback.FrameSummary]:
    begun = False
    for frame in frames:
        ours = frame.filename.startswith(f"{OURS}/")
        begun = begun or not (ours or frame.filename in STARTERS)
        if begun and not (ours and isinstance(error, KeyboardInterrupt)):
            yield frame
