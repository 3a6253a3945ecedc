"""Threads: each is a stack that is suspended while it waits; only then does another one run.

Python's own `threading` stays; this module replaces the functions of `_thread` that it uses. Where
the browser cannot suspend stacks, a program has one thread.
"""

from __future__ import annotations

import _threading_local
import multiprocessing
import os
import queue
import sys
import threading
import time
import weakref
from collections.abc import Callable
from concurrent.futures import thread as futures
from typing import Any

from pyodide.ffi import create_proxy

from rclpy_backend.system import beside, collecting, loops, pool, turns
from rclpy_backend.system.blocking import breathe, sleep, wait, wake
from rclpy_backend.system.tracebacks import traceback_of

# The number of processors that programs see, by which they choose a number of threads. These are
# stacks that take turns; more than one, so that a thread may wait for another.
PROCESSORS = 4

NO_STACKS = (
    "this browser does not support JavaScript Promise Integration, which threads need; "
    "use Chrome 137, Edge 137, Firefox 153 or newer"
)
# The programs that have been warned.
_warned: set[turns.Program] = set()


class Lock:
    """A lock; replaces `_thread.lock`."""

    __slots__ = ("__weakref__", "_locked", "_wanted")

    def __init__(self) -> None:
        self._locked = False
        self._wanted = 0

    def acquire(self, blocking: bool = True, timeout: float | None = -1) -> bool:
        """Acquire the lock; return False if that was not possible within `timeout` seconds."""
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
        """Release the lock.

        Raises:
            RuntimeError: if it is not locked.
        """
        if not self._locked:
            raise RuntimeError("release unlocked lock")
        self._locked = False
        if self._wanted:
            wake()

    def locked(self) -> bool:
        """Return whether the lock is held."""
        return self._locked

    # An executor takes two dozen locks for each message, so these avoid every needless call.
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
    """The handle of a thread; replaces `_thread._ThreadHandle`."""

    def __init__(self) -> None:
        self.ident: int | None = None
        self._done = False

    def is_done(self) -> bool:
        """Return whether the thread has ended."""
        breathe()  # a loop may poll this and nothing else
        return self._done

    def _set_done(self) -> None:
        self._done = True
        wake()

    def join(self, timeout: float | None = None) -> None:
        """Wait until the thread ends, up to `timeout` seconds."""
        end = None if timeout is None or timeout < 0 else time.monotonic() + timeout
        while not self._done:
            left = None if end is None else end - time.monotonic()
            if left is not None and left <= 0:
                return
            wait(left)


def _warn() -> None:
    """Warn once if a program waits for another thread in a browser without threads."""
    program = turns.running()
    if program.stacks or program in _warned:
        return
    _warned.add(program)
    print(f"Waiting for another thread, which cannot run: {NO_STACKS}", file=sys.stderr)


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


def _report(args: threading.ExceptHookArgs) -> None:
    """Replace threading.excepthook()."""
    if args.exc_value is None or isinstance(args.exc_value, SystemExit):
        return
    name = args.thread.name if args.thread else "<unknown>"
    print(f"Exception in thread {name}:", file=sys.stderr)
    print(traceback_of(args.exc_value), end="", file=sys.stderr)


def install(*, stacks: bool) -> None:
    """Make `threading` and the modules based on it use these threads."""
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
        "excepthook": _report,
    }
    for name, replacement in replaced.items():
        setattr(threading, name, replacement)
    # Remove the interpreter's own main thread, which runs no program.
    threading._active.clear()  # type: ignore[attr-defined]
    queue.SimpleQueue = queue._PySimpleQueue  # type: ignore[attr-defined, misc]
    multiprocessing.Lock = Lock  # type: ignore[assignment]
    time.sleep = sleep  # type: ignore[assignment]
    os.cpu_count = lambda: PROCESSORS
    os.sched_getaffinity = lambda _: set(range(PROCESSORS))


def join_all() -> None:
    """Wait for the program's non-daemon threads, as Python does when the main thread has ended.

    Those of thread pools end when they have nothing left to do.
    """
    own = turns.running().threads
    for worker in list(futures._threads_queues):
        if worker.ident in own:
            _end_pool(worker)
    for thread in threading.enumerate():
        if thread is not threading.main_thread() and not thread.daemon and thread.ident in own:
            thread.join()
    sys.stdout.flush()


def _end_pool(worker: threading.Thread) -> None:
    """Shut down the pool of a thread. Python's own function would end those of all programs."""
    reference, *_ = getattr(worker, "_args", None) or [None]
    executor = reference() if isinstance(reference, weakref.ref) else None
    if executor:  # else it is gone, and has told its threads
        executor.shutdown(wait=False)
