"""Waiting: the one place where Python stands still, and the page goes on."""

from __future__ import annotations

import select
import time

from rclpy_backend.system import beside, collecting, pool, turns

# A program that never waits lets the event loop turn this often (s): often enough for a Stop
# button, seldom enough to cost nothing.
BREATH = 0.004

_waiting: dict[turns.Program, int] = {}
_last_turn = time.monotonic()


def wait(seconds: float | None) -> None:
    """Let the page go on until something happens, at most so long; 0 is one turn of its loop.

    Raises what a handler of a signal raises, KeyboardInterrupt by default; in threads of a program
    that is over, SystemExit.
    """
    global _last_turn
    program, me = turns.running(), turns.current_thread()
    if not program.stacks and seconds != 0:
        if pool.has_room():
            pool.spin(seconds)
            return
        if beside.run_one():
            return
        seconds = beside.until_next(seconds)
    _waiting[program] = _waiting.get(program, 0) + 1
    try:
        program.host.wait(-1 if seconds is None else seconds * 1000)
        if program.stacks:
            select.poll().poll()  # the others stood still in wait()
    finally:
        _waiting[program] -= 1
        if not _waiting[program]:
            del _waiting[program]
        turns.enter(program, me)
        collecting.look()
        _last_turn = time.monotonic()
    if program.over:
        raise SystemExit
    if program.signals:
        if number := program.host.signal():
            program.signals.arrive(number)
        program.signals.handle(main=me == program.ident)


def breathe() -> None:
    """Let the event loop turn if it has not for a while."""
    if time.monotonic() - _last_turn > BREATH:
        wait(0)


def wake() -> None:
    """End the waits of all other threads: something has changed."""
    for program in _waiting:
        program.host.wake()


def sleep(seconds: float) -> None:
    """Stand in for time.sleep()."""
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    end = time.monotonic() + seconds
    wait(0)
    while (left := end - time.monotonic()) > 0:
        wait(left)
