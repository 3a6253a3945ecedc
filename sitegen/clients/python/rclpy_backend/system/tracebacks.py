"""Format tracebacks as native Python does."""

from __future__ import annotations

import code
import importlib
import re
import traceback
from collections.abc import Iterator

# The modules that start programs.
STARTERS = (
    code.interact.__code__.co_filename,  # __file__ may be that of the bytecode
    importlib.import_module.__code__.co_filename,
    "<frozen runpy>",
)
# This layer, which natively is a library in C++, Pyodide, and what Python hides where an import
# fails.
HIDDEN = re.compile(
    rf"{re.escape(__file__.rpartition('/system/')[0])}/|.*/_?pyodide/|<frozen importlib\b"
)


def traceback_of(error: BaseException) -> str:
    """Return the traceback of an exception that left a program.

    It starts in the program, and so do those of its causes. As natively, what stands in for C++ has
    no frames there, and neither have imports.
    """
    told = traceback.TracebackException.from_exception(error)
    _shorten(told)
    return "".join(told.format())


def _shorten(told: traceback.TracebackException) -> None:
    shown = traceback.StackSummary.from_list(list(_shown(told.stack)))
    # A file that Python cannot parse has not run: native Python names only its line.
    told.stack = shown or None  # type: ignore[assignment]
    for earlier in (told.__cause__, told.__context__):
        if earlier:
            _shorten(earlier)


def _shown(frames: traceback.StackSummary) -> Iterator[traceback.FrameSummary]:
    begun = False
    for frame in frames:
        if HIDDEN.match(frame.filename):
            continue
        begun = begun or frame.filename not in STARTERS
        if begun:
            yield frame
