"""Interrupts: let a program that computes without waiting receive messages from the page.

The page sets a byte in memory shared with the worker, and Python checks that byte regularly.
"""

from __future__ import annotations

import signal
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from sys import monitoring  # type: ignore[attr-defined]  # of Python 3.12 and newer
from types import CodeType, FrameType

from pyodide.ffi import can_run_sync

from rclpy_backend.system import turns
from rclpy_backend.system.blocking import wait

# As in runtime/interrupt.js.
HEAR = signal.SIGUSR2
# The page sets the byte before it posts its message, which arrives within this time (s).
LIMIT = 0.1
OURS = __file__.rpartition("/system/")[0]

# One that Python reserves for no kind of tool.
TOOL = 4
NEXT = monitoring.events.INSTRUCTION


@dataclass(eq=False, frozen=True)
class Interrupt:
    """An interrupt of a program, which had received so many signals by then."""

    program: turns.Program
    signals: int


# The frames of which the first that continues receives the message.
_callers: dict[FrameType, Interrupt] = {}


def install() -> None:
    """Install the handler of the page's interrupt."""
    signal.signal(HEAR, _hear)
    monitoring.use_tool_id(TOOL, "interrupts")
    monitoring.register_callback(TOOL, NEXT, _continue)


def _hear(number: int, frame: FrameType | None) -> None:
    program, _ = turns.current()
    if program is None or frame is None:
        return
    for ended in {one for one in _callers.values() if one.program.over}:
        _forget(ended)
    interrupt = Interrupt(program, program.signals_received)
    if not _is_ours(frame):
        _receive(interrupt)
        return
    # This layer must not be suspended outside of its own waits. An exception may end its callers.
    for caller in _outside(frame):
        _callers[caller] = interrupt
        monitoring.set_local_events(TOOL, caller.f_code, NEXT)


def _is_ours(frame: FrameType) -> bool:
    return frame.f_code.co_filename.startswith(f"{OURS}/")


def _outside(frame: FrameType) -> Iterator[FrameType]:
    """Yield the frames of a stack that are not of this layer."""
    up: FrameType | None = frame
    while up:
        if not _is_ours(up):
            yield up
        up = up.f_back


def _continue(code: CodeType, offset: int) -> None:
    """Receive the message if the frame that continues is one of the callers.

    This is not a trace function: for each one that is set, Python visits the frames of all stacks,
    and a suspended stack is not in memory where its frames point.
    """
    interrupt = _callers.get(sys._getframe(1))
    if interrupt:
        _forget(interrupt)
        _receive(interrupt)


def _forget(interrupt: Interrupt) -> None:
    frames = [frame for frame, one in _callers.items() if one is interrupt]
    for frame in frames:
        del _callers[frame]
    # By id: the copies of a module that the programs of a group have are equal.
    others = {id(frame.f_code) for frame in _callers}
    for frame in frames:
        if id(frame.f_code) not in others:
            monitoring.set_local_events(TOOL, frame.f_code, monitoring.events.NO_EVENTS)


def _receive(interrupt: Interrupt) -> None:
    """Let the message of the page arrive, whose signal handler may raise an exception."""
    program, end = interrupt.program, time.monotonic() + LIMIT
    while program.signals_received == interrupt.signals and (left := end - time.monotonic()) > 0:
        if program.stacks and not can_run_sync():
            return
        wait(left)
