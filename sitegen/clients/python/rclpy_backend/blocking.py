"""Waiting: the one place where Python stands still, and the page goes on."""

from __future__ import annotations

import time

import ros_host
from pyodide.ffi import run_sync

from rclpy_backend import signals

# A program that never waits lets the event loop turn this often (s): often enough for a Stop
# button, seldom enough to cost nothing.
BREATH = 0.004

_current = 0
_waiting = 0
_last_turn = time.monotonic()


def current_thread() -> int:
    """Return the number of the thread that runs; that of the program itself is 0."""
    return _current


def enter_thread(number: int) -> None:
    """Say which thread runs from now on."""
    global _current
    _current = number


def wait(seconds: float | None) -> None:
    """Let the page go on until something happens, at most so long; 0 is one turn of its loop.

    Raises what a handler of a signal raises, KeyboardInterrupt by default.
    """
    global _waiting, _last_turn
    me = _current
    _waiting += 1
    try:
        number = run_sync(ros_host.wait(-1 if seconds is None else seconds * 1000))
    finally:
        _waiting -= 1
        enter_thread(me)
        _last_turn = time.monotonic()
    if number:
        signals.arrive(number)
    signals.handle(main=me == 0)


def breathe() -> None:
    """Let the event loop turn if it has not for a while."""
    if time.monotonic() - _last_turn > BREATH:
        wait(0)


def wake() -> None:
    """End the waits of all other threads: something has changed."""
    if _waiting:
        ros_host.wake()


def sleep(seconds: float) -> None:
    """Stand in for time.sleep()."""
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    end = time.monotonic() + seconds
    wait(0)
    while (left := end - time.monotonic()) > 0:
        wait(left)
