"""Thread pools without threads: work runs when it is submitted.

A callback of a MultiThreadedExecutor may wait for another callback. So the executor continues
inside such a wait, and callbacks nest instead of running in parallel.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from concurrent.futures.thread import ThreadPoolExecutor
from typing import Any

# The executors whose callbacks are running, the innermost last; None while one selects the next.
_running: list[Any] = []


def install() -> None:
    """Replace ThreadPoolExecutor.submit()."""
    ThreadPoolExecutor.submit = _submit  # type: ignore[method-assign]


def has_room() -> bool:
    """Return whether the executor of the innermost callback would have a free thread."""
    executor: Any = _running[-1] if _running else None
    return executor is not None and _running.count(executor) < executor._executor._max_workers


def spin(seconds: float | None) -> None:
    """Let that executor wait up to `seconds` and run one more callback."""
    executor = _running[-1]
    _running.append(None)
    try:
        executor._spin_once_impl(seconds)
    finally:
        _running.pop()


def _submit(_: object, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
    future: Future[Any] = Future()
    # An rclpy task holds a weak reference to its executor.
    executor = getattr(function, "_executor", None)
    _running.append(executor and executor())
    try:
        future.set_result(function(*args, **kwargs))
    except Exception as error:
        future.set_exception(error)
    finally:
        _running.pop()
    return future
