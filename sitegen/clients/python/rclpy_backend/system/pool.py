"""Pools of threads where there can be none: work is done when it is handed over.

A callback of a MultiThreadedExecutor may wait for another one. So the executor goes on in its
waits, and what would run beside it runs inside of it.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from concurrent.futures.thread import ThreadPoolExecutor
from typing import Any

# The executors whose callbacks run now, the innermost last; None while one looks for the next.
_running: list[Any] = []


def install() -> None:
    """Take the place of what hands work to threads."""
    ThreadPoolExecutor.submit = _submit  # type: ignore[method-assign]


def has_room() -> bool:
    """Return whether the innermost callback is of an executor that would have more threads."""
    executor: Any = _running[-1] if _running else None
    return executor is not None and _running.count(executor) < executor._executor._max_workers


def spin(seconds: float | None) -> None:
    """Let that executor wait at most so long, and run one more callback."""
    executor = _running[-1]
    _running.append(None)
    try:
        executor._spin_once_impl(seconds)
    finally:
        _running.pop()


def _submit(_: object, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
    future: Future[Any] = Future()
    # A task of rclpy has a weak reference to its executor.
    executor = getattr(function, "_executor", None)
    _running.append(executor and executor())
    try:
        future.set_result(function(*args, **kwargs))
    except Exception as error:
        future.set_exception(error)
    finally:
        _running.pop()
    return future
