"""Interrupts: let a program that computes without waiting receive messages from the page.

The page sets a byte in memory shared with the worker, and Python checks that byte regularly.
"""

from __future__ import annotations

import signal
import sys
import time
from types import FrameType
from typing import Any

from pyodide.ffi import can_run_sync

from rclpy_backend.system import turns
from rclpy_backend.system.blocking import wait

# As in runtime/interrupt.js.
HEAR = signal.SIGUSR2
# The page sets the byte before it posts its message, which arrives within this time (s).
LIMIT = 0.1
OURS = __file__.rpartition("/system/")[0]


def install() -> None:
    """Install the handler of the page's interrupt."""
    signal.signal(HEAR, _hear)


def _hear(number: int, frame: FrameType | None) -> None:
    program, _ = turns.current()
    if program is None or frame is None:
        return
    # This layer must not be suspended outside of its own waits.
    caller: FrameType | None = frame
    while caller and caller.f_code.co_filename.startswith(f"{OURS}/"):
        caller = caller.f_back
    if caller is frame:
        _receive(program)
    elif caller:
        _receive_after(caller, program)


def _receive(program: turns.Program) -> None:
    """Let the message of the page arrive, whose signal handler may raise an exception."""
    end = time.monotonic() + LIMIT
    while (left := end - time.monotonic()) > 0 and (not program.stacks or can_run_sync()):
        wait(left)


def _receive_after(caller: FrameType, program: turns.Program) -> None:
    """Let it arrive as soon as `caller` continues, which is traced until then."""

    def trace(frame: FrameType, event: str, _: Any) -> None:
        if frame.f_trace is trace:
            frame.f_trace = traced
        if sys.gettrace() is _ignore:
            sys.settrace(None)
        # After an exception, the layer may have been waiting, and have received the message.
        if event != "exception":
            _receive(program)

    traced = caller.f_trace
    caller.f_trace = trace
    if not sys.gettrace():
        # The tracer of a frame is called only if there is one for all new frames, too.
        sys.settrace(_ignore)


def _ignore(frame: FrameType, event: str, arg: Any) -> None:
    """Trace nothing in a new frame."""
