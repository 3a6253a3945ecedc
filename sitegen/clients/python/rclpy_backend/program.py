"""Run an entry point as a console script does, or a file as Python does."""

from __future__ import annotations

import importlib
import os
import runpy
import sys
from collections.abc import Sequence
from contextlib import suppress

from rclpy_backend import signals
from rclpy_backend.system import exits, threads, turns
from rclpy_backend.system.tracebacks import traceback_of

# Where the page unpacks archives.
PREFIX = "/ros"
# What a native program has, too; the build reads conditions of packages with the same values.
ROS = {"ROS_VERSION": "2", "ROS_DISTRO": "kilted", "ROS_PYTHON_VERSION": "3"}
# Exceptions with which Stop ends a program.
ENDS = {"KeyboardInterrupt", "ExternalShutdownException", "RCLError"}


def run(module: str, attribute: str, arguments: Sequence[str], environment: dict[str, str]) -> int:
    """Call `attribute` of `module` with command-line arguments and return the exit code.

    Without an attribute, `module` is the path of a file to run. Uncaught exceptions are printed as
    Python does.
    """
    sys.argv[:] = list(arguments)
    os.environ.update(ROS | environment)
    os.environ["AMENT_PREFIX_PATH"] = PREFIX
    # Where compiled modules find shared libraries.
    os.environ["LD_LIBRARY_PATH"] = f"/usr/lib:{PREFIX}/lib"
    turns.running().signals = signals
    code = 0
    try:
        code = _code(_call(module, attribute)) if attribute else _execute(f"{PREFIX}/{module}")
    except SystemExit as end:
        code = _code(end.code)
    except BaseException as error:
        sys.stdout.flush()
        print(traceback_of(error), end="", file=sys.stderr)
        # A program that Stop ended has not failed, even if it raises: many call shutdown() twice.
        stopped = signals.received and type(error).__name__ in ENDS
        code = 0 if stopped else 1
    with suppress(KeyboardInterrupt, SystemExit):
        threads.join_all()
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
    """Return the exit code of `result`, as sys.exit() does."""
    if result is None or isinstance(result, int):
        return int(result or 0)
    print(result, file=sys.stderr)
    return 1
