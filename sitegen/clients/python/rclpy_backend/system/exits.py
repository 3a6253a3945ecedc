"""Exit handlers: `atexit`, separately for each program."""

from __future__ import annotations

import atexit
import sys
from collections.abc import Callable
from typing import Any

from rclpy_backend.system import turns
from rclpy_backend.system.tracebacks import traceback_of


def install() -> None:
    """Replace Python's own functions, whose handlers would run only when the page closes."""
    atexit.register = register
    atexit.unregister = unregister


def register(function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Callable[..., Any]:
    """Replace atexit.register()."""
    turns.running().exits.append((function, args, kwargs))
    return function


def unregister(function: Callable[..., Any], /) -> None:
    """Replace atexit.unregister()."""
    exits = turns.running().exits
    exits[:] = [each for each in exits if each[0] != function]


def run() -> None:
    """Call the registered functions, the last one first, and print their exceptions."""
    exits = turns.running().exits
    while exits:
        function, args, kwargs = exits.pop()
        try:
            function(*args, **kwargs)
        except SystemExit:
            pass
        except BaseException as error:
            print(f"Exception ignored in atexit callback {function!r}:", file=sys.stderr)
            print(traceback_of(error), end="", file=sys.stderr)
