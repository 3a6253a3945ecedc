"""Tracebacks as Python writes them on a robot."""

from __future__ import annotations

import code
import importlib
import traceback
from collections.abc import Iterator

# What starts programs, and what stands in for a library in C++.
OURS = __file__.rpartition("/system/")[0]
BELOW = "rclpy._rclpy_pybind11"
STARTERS = (code.__file__, importlib.__file__, "<frozen runpy>")


def traceback_of(error: BaseException) -> str:
    """Return the traceback of an exception that left a program.

    It begins in the program, and so do those of the exceptions before it. What is raised below
    rclpy does not tell where, as natively, and an interrupt not where in a page Python waits.
    """
    told = traceback.TracebackException.from_exception(error)
    _shorten(told, error)
    return "".join(told.format())


def _shorten(told: traceback.TracebackException, error: BaseException | None) -> None:
    told.stack = traceback.StackSummary.from_list(list(_shown(told.stack, error)))
    if told.__cause__:
        _shorten(told.__cause__, error and error.__cause__)
    if told.__context__:
        _shorten(told.__context__, error and error.__context__)


def _shown(
    frames: traceback.StackSummary, error: BaseException | None
) -> Iterator[traceback.FrameSummary]:
    begun = False
    short = isinstance(error, KeyboardInterrupt) or type(error).__module__ == BELOW
    for frame in frames:
        ours = frame.filename.startswith(f"{OURS}/")
        begun = begun or not (ours or frame.filename in STARTERS)
        if begun and not (ours and short):
            yield frame
