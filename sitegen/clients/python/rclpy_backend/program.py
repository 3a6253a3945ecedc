"""Run an entry point of a package as its console script does, or a program as Python does."""

from __future__ import annotations

import importlib
import os
import runpy
import sys
from collections.abc import Sequence

from rclpy_backend import signals
from rclpy_backend.system import exits, threads, turns
from rclpy_backend.system.tracebacks import traceback_of

# Where the page unpacks what runs in it.
PREFIX = "/ros"
# What Stop makes of a program that does not expect it.
ENDS = {"KeyboardInterrupt", "ExternalShutdownException", "RCLError"}


def run(module: str, attribute: str, arguments: Sequence[str]) -> int:
    """Call `attribute` of `module` with a command line, and return the exit code.

    Without an attribute, `module` is the place of a program. What leaves it is printed as Python
    prints it.
    """
    sys.argv[:] = list(arguments)
    os.environ["AMENT_PREFIX_PATH"] = PREFIX
    # Where libraries are that compiled modules share.
    os.environ["LD_LIBRARY_PATH"] = f"/usr/lib:{PREFIX}/lib"
    turns.running().signals = signals
    code = 0
    try:
        code = _code(_call(module, attribute)) if attribute else _execute(f"{PREFIX}/{module}")
        threads.join_all()
    except SystemExit as end:
        code = _code(end.code)
    except BaseException as error:
        sys.stdout.flush()
        print(traceback_of(error), end="", file=sys.stderr)
        # A program that Stop ended has not failed, whatever it prints: many shut down once more.
        stopped = signals.received and type(error).__name__ in ENDS
        code = 0 if stopped else 1
    exits.run()
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
