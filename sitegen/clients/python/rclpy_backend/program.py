"""Run an entry point of a package as its console script does."""

from __future__ import annotations

import importlib
import os
import sys
import traceback
from collections.abc import Sequence

from rclpy_backend import signals, threads

# Where the page unpacks what runs in it.
PREFIX = "/ros"


def run(module: str, attribute: str, arguments: Sequence[str]) -> int:
    """Call `attribute` of `module` with a command line, and return the exit code.

    What leaves it is printed as Python prints it.
    """
    sys.argv[:] = list(arguments)
    os.environ["AMENT_PREFIX_PATH"] = PREFIX
    threads.install()
    code = 0
    try:
        function = importlib.import_module(module)
        for name in attribute.split("."):
            function = getattr(function, name)
        code = _code(function())  # type: ignore[operator]
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


def _code(result: object) -> int:
    """Return what sys.exit() makes of `result`."""
    if result is None or isinstance(result, int):
        return int(result or 0)
    print(result, file=sys.stderr)
    return 1


def _print(error: BaseException) -> None:
    """Print a traceback that begins in the program."""
    frames = error.__traceback__
    while frames and frames.tb_frame.f_code.co_filename in (__file__, importlib.__file__):
        frames = frames.tb_next
    sys.stdout.flush()
    traceback.print_exception(type(error), error, frames)
