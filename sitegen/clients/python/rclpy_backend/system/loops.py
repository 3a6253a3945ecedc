"""Loops of asyncio: Python's own, which wait as everything else does."""

from __future__ import annotations

import asyncio
import signal
import threading
import warnings
from asyncio import base_events, events, runners
from collections.abc import Callable
from contextvars import Context
from typing import TypeVarTuple

from rclpy_backend.system import blocking, turns

Words = TypeVarTuple("Words")


class Selector:
    """What a loop waits with. Nothing but messages and times ends a wait in a page."""

    def __init__(self) -> None:
        self._woken = False
        self._waits = False

    def select(self, timeout: float | None) -> list[object]:
        """Wait until something happens, at most so long (s)."""
        if self._woken or timeout == 0:
            blocking.breathe()
        else:
            self._waits = True
            try:
                blocking.wait(timeout)
            finally:
                self._waits = False
        self._woken = False
        return []

    def wake(self) -> None:
        """End the wait, or the next one before it begins."""
        self._woken = True
        if self._waits:
            blocking.wake()

    def close(self) -> None:
        """There is nothing to close."""


class Loop(base_events.BaseEventLoop):
    """A loop that lets the page go on while it waits."""

    def __init__(self) -> None:
        super().__init__()
        self._selector = Selector()

    def call_soon(
        self, callback: Callable[[*Words], object], *args: *Words, context: Context | None = None
    ) -> asyncio.Handle:
        """Call something in the next round; the promises of the page do that while it waits."""
        handle = super().call_soon(callback, *args, context=context)
        self._write_to_self()
        return handle

    def add_signal_handler(
        self, sig: int, callback: Callable[[*Words], object], *args: *Words
    ) -> None:
        """Call something when a signal comes."""
        signal.signal(sig, lambda *_: self.call_soon_threadsafe(callback, *args))

    def remove_signal_handler(self, sig: int) -> bool:
        """Let the signal do what it does by itself; return whether it was another thing."""
        before = signal.getsignal(sig)
        default = signal.default_int_handler if sig == signal.SIGINT else signal.SIG_DFL
        signal.signal(sig, default)
        return before is not default

    def _process_events(self, event_list: list[object]) -> None:
        pass

    def _write_to_self(self) -> None:
        self._selector.wake()


class Policy(events._BaseDefaultEventLoopPolicy):  # type: ignore[name-defined, misc]
    """Gives each thread such loops."""

    _loop_factory = Loop

    def __init__(self) -> None:
        super().__init__()
        self._loops: dict[int, asyncio.AbstractEventLoop | None] = {}

    def get_event_loop(self) -> asyncio.AbstractEventLoop:
        """Return the thread's loop. A main thread gets one, as it did before Python 3.14."""
        thread = turns.current_thread()
        if thread == turns.running().ident and thread not in self._loops:
            self._loops[thread] = Loop()
        loop = self._loops.get(thread)
        if loop is None:
            name = threading.current_thread().name
            raise RuntimeError(f"There is no current event loop in thread {name!r}.")
        return loop

    def set_event_loop(self, loop: asyncio.AbstractEventLoop | None) -> None:
        """Give the thread that loop."""
        self._loops[turns.current_thread()] = loop


def none_runs() -> None:
    """Begin a stack: Pyodide says in each that its own loop runs there."""
    asyncio._set_running_loop(None)


def install() -> None:
    """Take the place of the loop that Pyodide brings, which is one for all and never ends."""
    with warnings.catch_warnings(action="ignore"):
        asyncio.set_event_loop_policy(Policy())
    asyncio.run = runners.run
    for name in ("EventLoop", "SelectorEventLoop"):
        setattr(asyncio, name, Loop)
