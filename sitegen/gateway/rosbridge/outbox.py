"""What waits to be sent to one client, within bounds."""

from __future__ import annotations

import asyncio
import time
from collections import deque
from collections.abc import Iterator
from contextlib import suppress
from typing import Protocol

from aiohttp import web

from sitegen.gateway.access import Access

Message = str | bytes
# Answers that may wait before the client is no longer read (characters and bytes).
ROOM = 1_000_000


class Stream(Protocol):
    """Messages of one topic, of which the oldest may be left out."""

    def due(self) -> float | None:
        """Return when the next message may be sent, None if there is none (s, monotonic)."""

    def take(self) -> Iterator[Message]:
        """Yield the next message, which may be in fragments."""

    def drop(self) -> bool:
        """Leave out the oldest message that waits; return whether there was one."""


class Outbox:
    """Sends answers in order, and messages of topics in between; each is encoded when it is due.

    So a client that reads slowly keeps what was received, at most `queue_size` bytes, and gets the
    newest. One that reads nothing for `stall` seconds is let go.
    """

    def __init__(self, socket: web.WebSocketResponse, access: Access) -> None:
        self._socket = socket
        self._access = access
        self._limits = access.rules.limits
        self._answers: deque[Message] = deque()
        self._answers_size = 0
        self._held = 0
        self.streams: list[Stream] = []
        self._news = asyncio.Event()
        self._sent = asyncio.Event()

    def answer(self, message: Message) -> None:
        """Send a message that must not be left out."""
        self._answers.append(message)
        self._answers_size += len(message)
        if self._answers_size > self._limits.queue_size:
            self._access.end("answers are not read")
        self._news.set()

    async def room(self) -> None:
        """Wait while too many answers are not read yet: their client is not read, either."""
        while self._answers_size > ROOM and not self._socket.closed:
            self._sent.clear()
            await self._sent.wait()

    def hold(self, size: int) -> None:
        """Count the bytes of a message that a stream keeps, or no longer keeps if negative."""
        self._held += size
        # The streams that were served last have waited longest.
        while self._held > self._limits.queue_size:
            if not any(stream.drop() for stream in self.streams):
                break

    def wake(self) -> None:
        """Look for messages that are due."""
        self._news.set()

    async def run(self) -> None:
        """Send until cancelled, or until the connection has ended."""
        while not self._socket.closed:
            self._news.clear()
            if self._answers:
                message = self._answers.popleft()
                await self._send(message)
                self._answers_size -= len(message)
                self._sent.set()
                continue
            wait = await self._serve()
            if wait is None or wait > 0:
                with suppress(TimeoutError):
                    await asyncio.wait_for(self._news.wait(), wait)

    async def flush(self) -> None:
        """Send the answers that wait."""
        while self._answers and not self._socket.closed:
            await self._send(self._answers.popleft())

    async def _serve(self) -> float | None:
        """Send one message of a stream; return how long to wait, None for ever."""
        soonest: float | None = None
        now = time.monotonic()
        for stream in self.streams:
            due = stream.due()
            if due is None:
                continue
            if due <= now:
                # Others have their turn first next time.
                self.streams.remove(stream)
                self.streams.append(stream)
                for message in stream.take():
                    await self._send(message)
                return 0
            soonest = due if soonest is None else min(soonest, due)
        return None if soonest is None else max(0.0, soonest - now)

    async def _send(self, message: Message) -> None:
        try:
            async with asyncio.timeout(self._limits.stall):
                if isinstance(message, bytes):
                    await self._socket.send_bytes(message)
                else:
                    await self._socket.send_str(message)
        except TimeoutError:
            self._access.end("nothing is read any more")
            await asyncio.sleep(3600)
        except ConnectionError:
            await asyncio.sleep(3600)
