"""Interrupts: what makes a program listen to the page that computes and never waits.

The page sets a byte in memory that it shares with the worker, and Python looks there now and then.
"""

from __future__ import annotations

import signal
import time
from types import FrameType

from pyodide.ffi import can_run_sync

from rclpy_backend.system import turns
from rclpy_backend.system.blocking import wait

# As runtime/interrupt.js has it.
HEAR = signal.SIGUSR2
# What the page said stands before the byte is set, and is here by then (s).
LIMIT = 0.1
OURS = __file__.rpartition("/")[0]


def install() -> None:
    """Listen when the page wants it."""
    signal.signal(HEAR, _hear)


def _hear(number: int, frame: FrameType | None) -> None:
    program, _ = turns.current()
    if program is None or frame is None:
        return
    if frame.f_code.co_filename.startswith(f"{OURS}/"):
        # Nobody else may have a turn there but where it waits; then again, after the next step.
        signal.raise_signal(number)
        return
    end = time.monotonic() + LIMIT
    while (left := end - time.monotonic()) > 0 and (not program.stacks or can_run_sync()):
        wait(left)
