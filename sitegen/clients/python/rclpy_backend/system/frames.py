"""Refuse functions that visit the frames of all stacks while some of these are suspended.

A suspended stack is not in memory where its frames point, since another stack has taken its place.
Python would take what is there for frames, and loop forever or crash the page.
"""

from __future__ import annotations

import faulthandler
import functools
import sys
from collections.abc import Callable
from sys import monitoring  # type: ignore[attr-defined]  # of Python 3.12 and newer
from types import ModuleType
from typing import Any

from rclpy_backend.system import collecting

VISITORS: dict[ModuleType, tuple[str, ...]] = {
    sys: (
        *("settrace", "setprofile", "_settraceallthreads", "_setprofileallthreads"),
        *("_current_frames", "_current_exceptions"),
    ),
    monitoring: ("set_events", "restart_events", "clear_tool_id", "free_tool_id"),
    faulthandler: ("dump_traceback",),
}
# If a function is not set, removing it visits nothing.
SET: dict[str, Callable[[], object]] = {"settrace": sys.gettrace, "setprofile": sys.getprofile}
# The ids of tools that could not start, and so will not free them.
_abandoned: set[int] = set()


def install() -> None:
    """Replace the functions by which debuggers, profilers and the like work."""
    for module, names in VISITORS.items():
        for name in names:
            setattr(module, name, _guarded(f"{module.__name__}.{name}", getattr(module, name)))
    monitoring.use_tool_id = _use_tool_id


def _use_tool_id(tool: int, name: str, original: Any = monitoring.use_tool_id) -> None:
    """Replace sys.monitoring.use_tool_id()."""
    if tool in _abandoned:
        _abandoned.remove(tool)
    else:
        original(tool, name)


def _guarded(name: str, function: Callable[..., Any]) -> Callable[..., Any]:
    is_set = SET.get(function.__name__, lambda: True)

    @functools.wraps(function)
    def call(*args: Any, **named: Any) -> Any:
        if collecting.stacks() > 1 and (args != (None,) or is_set()):
            if name == "sys.monitoring.set_events":
                _abandoned.add(args[0])
            raise RuntimeError(
                f"{name}() is not available in the browser while other threads or nodes share "
                "this interpreter; debuggers and profilers need one that runs a single thread"
            )
        return function(*args, **named)

    return call
