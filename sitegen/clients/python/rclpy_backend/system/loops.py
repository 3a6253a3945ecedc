"""Event loops of asyncio: Python's own, waiting by `blocking.wait`."""

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
    """The selector of a loop. In the browser, only messages and timeouts end a wait."""

    def __init__(self) -> None:
        self._woken = False
        self._waits = False

    def select(self, timeout: float | None) -> list[object]:
        """Wait until something happens or `timeout` seconds pass."""
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
        """End the current wait, or the next one at once."""
        self._woken = True
        if self._waits:
            blocking.wake()

    def close(self) -> None:
        """Do nothing: there is nothing to close."""


class Loop(base_events.BaseEventLoop):
    """An event loop that lets the page continue while it waits."""

    def __init__(self) -> None:
        super().__init__()
        self._selector = Selector()

    def call_soon(
        self, callback: Callable[[*Words], object], *args: *Words, context: Context | None = None
    ) -> asyncio.Handle:
        """Schedule a callback; promises of the page do so while the loop waits."""
        handle = super().call_soon(callback, *args, context=context)
        self._write_to_self()
        return handle

    def add_signal_handler(
        self, sig: int, callback: Callable[[*Words], object], *args: *Words
    ) -> None:
        """Call `callback` when the signal arrives."""
        signal.signal(sig, lambda *_: self.call_soon_threadsafe(callback, *args))

    def remove_signal_handler(self, sig: int) -> bool:
        """Restore the default handler; return whether there was another one."""
        before = signal.getsignal(sig)
        default = signal.default_int_handler if sig == signal.SIGINT else signal.SIG_DFL
        signal.signal(sig, default)
        return before is not default

    def _process_events(self, event_list: list[object]) -> None:
        pass

    def _write_to_self(self) -> None:
        self._selector.wake()


class Policy(events._BaseDefaultEventLoopPolicy):  # type: ignore[name-defined, misc]
    """The policy that gives each thread such loops."""

    _loop_factory = Loop

    def __init__(self) -> None:
        super().__init__()
        self._loops: dict[int, asyncio.AbstractEventLoop | None] = {}

    def get_event_loop(self) -> asyncio.AbstractEventLoop:
        """Return the thread's loop; create one in the main thread, as Python before 3.14 did."""
        thread = turns.current_thread()
        if thread == turns.running().ident and thread not in self._loops:
            self._loops[thread] = Loop()
        loop = self._loops.get(thread)
        if loop is None:
            name = threading.current_thread().name
            raise RuntimeError(f"There is no current event loop in thread {name!r}.")
        return loop

    def set_event_loop(self, loop: asyncio.AbstractEventLoop | None) -> None:
        """Set the thread's loop."""
        self._loops[turns.current_thread()] = loop


def none_runs() -> None:
    """Clear the running loop of a new stack, where Pyodide sets its own."""
    asyncio._set_running_loop(None)


def install() -> None:
    """Replace Pyodide's loop, of which there is only one and which never ends."""
    with warnings.catch_warnings(action="ignore"):
        asyncio.set_event_loop_policy(Policy())
    asyncio.run = runners.run
    for name in ("EventLoop", "SelectorEventLoop"):
        setattr(asyncio, name, Loop)
