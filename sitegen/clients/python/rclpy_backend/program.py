"""Run an entry point of a package as its console script does, or a program as Python does."""

from __future__ import annotations

import importlib
import os
import runpy
import sys
import traceback
from collections.abc import Sequence

from rclpy_backend import signals, threads, turns

# Where the page unpacks what runs in it.
PREFIX = "/ros"
# Of tracebacks: what starts the program is none of its business.
HIDDEN = (__file__, importlib.__file__, "<frozen runpy>")


def run(module: str, attribute: str, arguments: Sequence[str]) -> int:
    """Call `attribute` of `module` with a command line, and return the exit code.

    Without an attribute, `module` is the place of a program. What leaves it is printed as Python
    prints it.
    """
    sys.argv[:] = list(arguments)
    os.environ["AMENT_PREFIX_PATH"] = PREFIX
    turns.running().signals = signals
    code = 0
    try:
        code = _code(_call(module, attribute)) if attribute else _execute(f"{PREFIX}/{module}")
        threads.join_all()
    except SystemExit as end:
        code = _code(end.code)
    except BaseException as error:
        _print(error)
        # A program that Stop ended has not failed, whatever it prints.
        stopped = isinstance(error, KeyboardInterrupt) and signals.received
        code = 0 if stopped else 1
    for stream in (sys.stdout, sys.stderr):
        stream.flush()
    return code


def _call(module: str, attribute: str) -> object:
    function = importlib.import_module(module)
    for name in attribute.split("."):
        function = getattr(function, name)
    return function()  # type: ignore[operator]


def _execute(file: str) -> int:
    sys.argv[0] = file
    sys.path.insert(0, file.rpartition("/")[0])
    runpy.run_path(file, run_name="__main__")
    return 0


def _code(result: object) -> int:
    """Return what sys.exit() makes of `result`."""
    if result is None or isinstance(result, int):
        return int(result or 0)
    print(result, file=sys.stderr)
    return 1


def _print(error: BaseException) -> None:
    """Print a traceback that begins in the program."""
    frames = error.__traceback__
    while frames and frames.tb_frame.f_code.co_filename in HIDDEN:
        frames = frames.tb_next
    sys.stdout.flush()
    traceback.print_exception(type(error), error, frames)
