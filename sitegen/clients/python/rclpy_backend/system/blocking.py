"""Waiting: the only place where Python blocks while the page continues."""

from __future__ import annotations

import select
import time

from rclpy_backend.system import beside, collecting, pool, turns

# How often a program that never waits yields to the event loop (s): often enough for the Stop
# button, rarely enough to cost nothing.
BREATH = 0.004

_waiting: dict[turns.Program, int] = {}
_last_turn = time.monotonic()


def wait(seconds: float | None) -> None:
    """Suspend the program until something happens or `seconds` pass; 0 is one turn of the loop.

    Raises:
    KeyboardInterrupt: on Stop, or whatever another signal handler raises.
        SystemExit: in the threads of a program that has ended.
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
            select.poll().poll()  # suspends the stack; without stacks, host.wait() has blocked
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
            program.signals_received += 1
            program.signals.arrive(number)
        program.signals.handle(main=me == program.ident)


def breathe() -> None:
    """Yield to the event loop if the program has not done so for a while."""
    if time.monotonic() - _last_turn > BREATH:
        wait(0)


def wake() -> None:
    """Wake up all other threads: something has changed."""
    for program in _waiting:
        program.host.wake()


def sleep(seconds: float) -> None:
    """Replace time.sleep().

    Raises:
        ValueError: if `seconds` is negative.
    """
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    begin = time.monotonic()
    wait(0)
    # Subtracts as callers do: the clock of a browser can stand exactly at begin + seconds, and
    # rounding would make the difference less than `seconds`.
    while (slept := time.monotonic() - begin) < seconds:
        wait(seconds - slept)
