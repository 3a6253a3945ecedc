"""Threads: each is a stack that is set aside while it waits, and only then another one runs.

The classes of Python's own `threading` stay; what they are made of is replaced. Where the browser
can set no stacks aside, a program has one thread.
"""

from __future__ import annotations

import _threading_local
import multiprocessing
import os
import queue
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

from pyodide.ffi import create_proxy

from rclpy_backend.system import beside, collecting, loops, pool, turns
from rclpy_backend.system.blocking import breathe, sleep, wait, wake

# What a program is told that the machine has, by which it decides how many threads it starts. They
# are stacks here and take turns, and one that waits for another must not be the only one.
PROCESSORS = 4

NO_STACKS = (
    "this browser lacks JavaScript Promise Integration, which threads in a page need; "
    "Chrome 137, Edge 137, Firefox 153 and newer have it"
)
# The programs that were told that they wait for a thread that cannot be.
_warned: set[turns.Program] = set()


class Lock:
    """Stands in for the lock of a real thread."""

    __slots__ = ("__weakref__", "_locked", "_wanted")

    def __init__(self) -> None:
        self._locked = False
        self._wanted = 0

    def acquire(self, blocking: bool = True, timeout: float | None = -1) -> bool:
        """Take it; return False if that was not possible in `timeout` seconds."""
        end = None if timeout is None or timeout < 0 else time.monotonic() + timeout
        while self._locked:
            left = None if end is None else end - time.monotonic()
            if not blocking or (left is not None and left <= 0):
                return False
            if left is None and not pool.has_room() and not beside.any_idle():
                _warn()
            self._wanted += 1
            try:
                wait(left)
            finally:
                self._wanted -= 1
        self._locked = True
        return True

    def release(self) -> None:
        """Let another one take it."""
        if not self._locked:
            raise RuntimeError("release unlocked lock")
        self._locked = False
        if self._wanted:
            wake()

    def locked(self) -> bool:
        """Return whether somebody has it."""
        return self._locked

    # An executor passes through two dozen of these for each message, so no call more than needed.
    def __enter__(self) -> bool:
        if self._locked:
            return self.acquire()
        self._locked = True
        return True

    def __exit__(self, *_: object) -> None:
        if self._wanted or not self._locked:
            self.release()
        self._locked = False

    def _at_fork_reinit(self) -> None:
        self._locked = False


class Handle:
    """Stands in for the handle of a real thread."""

    def __init__(self) -> None:
        self.ident: int | None = None
        self._done = False

    def is_done(self) -> bool:
        """Return whether it has ended."""
        breathe()  # a loop may ask for this and nothing else
        return self._done

    def _set_done(self) -> None:
        self._done = True
        wake()

    def join(self, timeout: float | None = None) -> None:
        """Wait for its end."""
        end = None if timeout is None or timeout < 0 else time.monotonic() + timeout
        while not self._done:
            left = None if end is None else end - time.monotonic()
            if left is not None and left <= 0:
                return
            wait(left)


def _warn() -> None:
    """Say it once when a program waits for another thread and there can be none."""
    program = turns.running()
    if program.stacks or program in _warned:
        return
    _warned.add(program)
    print(f"Waiting for another thread, but {NO_STACKS}", file=sys.stderr)


def _start(
    function: Callable[[], object], handle: Handle | None = None, daemon: bool = True
) -> Handle:
    handle = handle or Handle()
    program = turns.running()
    if not program.stacks and not beside.takes(function, handle):
        raise RuntimeError(f"can't start new thread: {NO_STACKS}")
    handle.ident = turns.new_thread()
    if not program.stacks:
        me = turns.current_thread()
        turns.enter(program, handle.ident)
        function()
        turns.enter(program, me)
        beside.begin(handle.ident)
        return handle
    collecting.begin()

    def body() -> None:
        if program.over:
            collecting.end()
            return
        turns.enter(program, handle.ident or 0)
        loops.none_runs()
        try:
            function()
        finally:
            handle._set_done()
            collecting.end()

    program.host.spawn(create_proxy(body))
    return handle


def install(*, stacks: bool) -> None:
    """Let `threading`, and what is made of it, work with such threads."""
    if not stacks:
        pool.install()
    replaced: dict[str, Any] = {
        "_start_joinable_thread": _start,
        "_ThreadHandle": Handle,
        "_allocate_lock": Lock,
        "Lock": Lock,
        "RLock": threading._PyRLock,  # type: ignore[attr-defined]
        "get_ident": turns.current_thread,
        "get_native_id": turns.current_thread,
        "local": _threading_local.local,
    }
    for name, replacement in replaced.items():
        setattr(threading, name, replacement)
    # Made before: the thread that stands for the interpreter, which runs no program.
    threading._active.clear()  # type: ignore[attr-defined]
    queue.SimpleQueue = queue._PySimpleQueue  # type: ignore[attr-defined, misc]
    multiprocessing.Lock = Lock  # type: ignore[assignment]
    time.sleep = sleep  # type: ignore[assignment]
    os.cpu_count = lambda: PROCESSORS
    os.sched_getaffinity = lambda _: set(range(PROCESSORS))


def join_all() -> None:
    """Wait for the threads that the program must not end before."""
    own = turns.running().threads
    for thread in threading.enumerate():
        if thread is not threading.main_thread() and not thread.daemon and thread.ident in own:
            thread.join()
    sys.stdout.flush()
