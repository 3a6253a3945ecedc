"""What the threads of Zenoh hand to the event loop."""

from __future__ import annotations

import asyncio
import threading
from collections import deque
from typing import Generic, TypeVar

T = TypeVar("T")


class Inbox(Generic[T]):
    """A queue from threads to the event loop, bounded by the size of what is in it.

    A full one makes its threads wait, and with them the network: reliable messages then wait at
    their senders.
    """

    def __init__(self, most: int) -> None:
        """Hold `most` bytes."""
        self._most = most
        self._loop = asyncio.get_running_loop()
        self._arrived = asyncio.Event()
        self._items: deque[T] = deque()
        self._bytes = 0
        self._room = threading.Condition()
        self._closed = False

    def put(self, item: T, size: int) -> None:
        """Add an item of `size` bytes, from any thread but that of the event loop."""
        with self._room:
            self._room.wait_for(lambda: self._closed or self._has_room(size))
            if self._closed:
                return
            self._bytes += size
            self._items.append(item)
            first = len(self._items) == 1
        if first:
            self._loop.call_soon_threadsafe(self._arrived.set)

    async def take(self) -> list[T]:
        """Wait until something is there, and return all of it."""
        await self._arrived.wait()
        with self._room:
            self._arrived.clear()
            items = list(self._items)
            self._items.clear()
            self._bytes = 0
            self._room.notify_all()
        return items

    def close(self) -> None:
        """Drop what is there, and take no more."""
        with self._room:
            self._closed = True
            self._items.clear()
            self._room.notify_all()

    def _has_room(self, size: int) -> bool:
        # What is larger than all the room comes alone.
        return self._bytes + size <= self._most or not self._items
