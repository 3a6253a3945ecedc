"""Loops of asyncio: Pyodide has one of its own, which must know whose turn it is, too."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pyodide.webloop import WebLoop

from rclpy_backend import turns

_call_later = WebLoop.call_later
_run_until_complete = WebLoop.run_until_complete


def install() -> None:
    """Let callbacks run as who asked for them, and who waits for a loop go on as itself."""
    WebLoop.call_later = _scheduled
    WebLoop.run_until_complete = _completed


def _scheduled(
    loop: Any, delay: float, callback: Callable[..., object], *args: Any, context: Any = None
) -> Any:
    program, thread = turns.current()

    def call() -> None:
        if program is None:
            callback(*args)
        elif not program.over:
            turns.enter(program, thread)
            callback(*args)

    return _call_later(loop, delay, call, context=context)


def _completed(loop: Any, future: Any) -> Any:
    program, thread = turns.current()
    try:
        return _run_until_complete(loop, future)
    finally:
        turns.enter(program, thread)
