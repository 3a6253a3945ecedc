"""Interrupts: let a program that computes without waiting receive messages from the page.

The page sets a byte in memory shared with the worker, and Python checks that byte regularly.
"""

from __future__ import annotations

import signal
import time
from types import FrameType

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
    if frame.f_code.co_filename.startswith(f"{OURS}/"):
        # This layer must not be suspended outside of its own waits, the next of which receives the
        # message. Raising the signal again would call this function again from within itself.
        return
    end = time.monotonic() + LIMIT
    while (left := end - time.monotonic()) > 0 and (not program.stacks or can_run_sync()):
        wait(left)
