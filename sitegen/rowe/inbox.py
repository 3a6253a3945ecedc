"""The messages that arrived and wait for the program."""

from __future__ import annotations

import asyncio
import math
import threading
from time import monotonic

from sitegen.rowe.expiring import ExpiringQueue, QueueFull
from sitegen.rowe.message import Message

# Seconds after which a full inbox looks whether messages have expired.
LOOK_AGAIN = 0.1


class Inbox:
    """A queue of messages, which an event loop fills, and coroutines or threads empty."""

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        """Make an empty inbox, filled by `loop`."""
        self._loop = loop
        self._messages: ExpiringQueue[Message] = ExpiringQueue()
        self._condition = threading.Condition()
        self._arrived = asyncio.Condition()
        # Coroutines in `receive`.
        self._waiting = 0
        self._room = asyncio.Event()
        self._full = False
        self._closed = False

    async def put(self, message: Message, size: int) -> None:
        """Append a message. While there is no room, wait, so that its socket is not read."""
        while True:
            self._room.clear()
            # Before it is tried: who takes a message meanwhile sets `_room`.
            self._full = True
            try:
                self._messages.put(message, message.time_to_live, size)
            except QueueFull:
                try:
                    await asyncio.wait_for(self._room.wait(), LOOK_AGAIN)
                except TimeoutError:
                    continue
            else:
                self._full = False
                break
        with self._condition:
            self._condition.notify()
        if self._waiting:
            await self._wake_all()

    def receive_blocking(self, timeout: float | None = None) -> Message | None:
        """Block until there is a message and return the oldest; None after `timeout` seconds."""
        end = math.inf if timeout is None else monotonic() + timeout
        with self._condition:
            while not (taken := self._take()):
                left = end - monotonic()
                if left <= 0 or self._closed:
                    return None
                self._condition.wait(min(left, threading.TIMEOUT_MAX))
        return taken

    async def receive(self, timeout: float | None = None) -> Message | None:
        """Wait for a message and return the oldest. Return None after `timeout` seconds."""
        end = math.inf if timeout is None else monotonic() + timeout
        async with self._arrived:
            while not (taken := self._take()):
                left = end - monotonic()
                if left <= 0 or self._closed:
                    return None
                self._waiting += 1
                try:
                    await asyncio.wait_for(self._arrived.wait(), None if left == math.inf else left)
                except TimeoutError:
                    continue
                finally:
                    self._waiting -= 1
        return taken

    async def close(self) -> None:
        """End all calls that wait for a message, as if their time were over."""
        self._closed = True
        with self._condition:
            self._condition.notify_all()
        await self._wake_all()

    async def _wake_all(self) -> None:
        async with self._arrived:
            self._arrived.notify_all()

    def _take(self) -> Message | None:
        taken = self._messages.take()
        if taken and self._full and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._room.set)
        return taken[1] if taken else None
