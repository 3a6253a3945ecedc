"""What programs want done when they end: `atexit`, for each program by itself."""

from __future__ import annotations

import atexit
import sys
from collections.abc import Callable
from typing import Any

from rclpy_backend.system import turns
from rclpy_backend.system.tracebacks import traceback_of


def install() -> None:
    """Take the place of Python's, whose time comes when the page is gone."""
    atexit.register = register
    atexit.unregister = unregister


def register(function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Callable[..., Any]:
    """Stand in for atexit.register()."""
    turns.running().exits.append((function, args, kwargs))
    return function


def unregister(function: Callable[..., Any], /) -> None:
    """Stand in for atexit.unregister()."""
    exits = turns.running().exits
    exits[:] = [each for each in exits if each[0] != function]


def run() -> None:
    """Call what was registered, the last first; errors are printed and change nothing."""
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
