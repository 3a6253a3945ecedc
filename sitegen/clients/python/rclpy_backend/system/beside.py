"""Run threads that only spin during the waits of the main thread, without JSPI.

Most threads of ROS programs run rclpy.spin() or the spin() of an executor. Where a browser cannot
suspend stacks, a wait of the main thread does this: it runs one callback that is ready and then
checks whether it still has to wait. So callbacks run only while the main thread waits.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable
from typing import Any, NamedTuple, Protocol

from rclpy_backend.system import turns


class Handle(Protocol):
    """The handle of a thread, set to done when the thread ends."""

    def _set_done(self) -> None: ...


class Spinner(NamedTuple):
    """A thread that spins, with its executor."""

    executor: Any
    handle: Handle
    thread: threading.Thread


# Exceptions that end a thread but not the program.
ENDS = (Exception, SystemExit)

_spinners: list[Spinner] = []
# Those whose callback is running, the innermost last.
_busy: list[Spinner] = []


def takes(function: Callable[[], object], handle: Handle) -> bool:
    """Take over a thread that is being started if it only spins; return whether it does.

    `function` is its _bootstrap(), which then only reports that the thread has started.
    """
    thread: Any = getattr(function, "__self__", None)
    executor = _executor(thread)
    if executor is None:
        return False
    thread._target = None
    _spinners.append(Spinner(executor, handle, thread))
    return True


def _executor(thread: Any) -> Any:
    """Return the executor that a thread would spin, or None if it does anything else."""
    target = getattr(thread, "_target", None)
    if type(thread).run is not threading.Thread.run or target is None:
        return None
    rclpy = sys.modules.get("rclpy")
    if rclpy and target is rclpy.spin:
        words = dict(zip(("node", "executor"), thread._args, strict=False)) | thread._kwargs
        executor = words.get("executor") or rclpy.get_global_executor()
        executor.add_node(words["node"])
        return executor
    owner = getattr(target, "__self__", None)
    owner = getattr(owner, "_executor", owner)  # of an EventsExecutor
    spins = getattr(target, "__name__", "") == "spin" and hasattr(owner, "wait_for_ready_callbacks")
    return owner if spins else None


def begin(ident: int) -> None:
    """Keep the thread taken over last in the list of live threads, although its body has ended."""
    threading._active[ident] = _spinners[-1].thread  # type: ignore[attr-defined]


def any_idle() -> bool:
    """Return whether one of these threads could run."""
    return len(_spinners) > len(_busy)


def run_one() -> bool:
    """Run one callback that is ready, if any; return whether anything has changed."""
    for spinner in [one for one in _spinners if one not in _busy]:
        _busy.append(spinner)
        try:
            if _run(spinner):
                return True
        finally:
            _busy.remove(spinner)
    return False


def _run(spinner: Spinner) -> bool:
    executors: Any = sys.modules["rclpy.executors"]
    executor = spinner.executor
    try:
        if not executor.context.ok():
            raise SystemExit
        handler, _, _ = executor.wait_for_ready_callbacks(timeout_sec=0)
        program, me = turns.running(), turns.current_thread()
        turns.enter(program, spinner.thread.ident or 0)
        try:
            handler()
        finally:
            turns.enter(program, me)
        if handler.exception() is not None:
            raise handler.exception()
    except executors.TimeoutException:
        return False
    except ENDS:
        end = sys.exc_info()
        _spinners.remove(spinner)
        over = (SystemExit, executors.ShutdownException, executors.ExternalShutdownException)
        if not isinstance(end[1], over):
            threading.excepthook(threading.ExceptHookArgs([*end, spinner.thread]))
        threading._active.pop(spinner.thread.ident, None)  # type: ignore[attr-defined]
        spinner.handle._set_done()
    return True


def until_next(seconds: float | None) -> float | None:
    """Return the longest time to wait (s): until the next timer of the threads that could run."""
    idle = [spinner for spinner in _spinners if spinner not in _busy]
    nodes = [node for spinner in idle for node in spinner.executor.get_nodes()]
    timers = [timer for node in nodes for timer in node.timers]
    left = [timer.time_until_next_call() for timer in timers if not timer.clock.handle.simulated]
    times = [max(each, 0) / 1e9 for each in left if each is not None]
    return min([*times, *([] if seconds is None else [seconds])], default=None)
