"""A queue whose items expire."""

from __future__ import annotations

import math
import time
from collections import OrderedDict
from collections.abc import Callable
from typing import Generic, TypeVar

Item = TypeVar("Item")

TICK = 0.05  # seconds


class QueueFull(Exception):
    """The queue contains as many items as it can."""


class ExpiringQueue(Generic[Item]):
    """A queue whose items expire, each at its own time.

    Every operation takes constant time, amortized, however many items expire and wherever they
    are: the items that expire in the same tick of the clock are in one bucket.
    """

    def __init__(
        self,
        capacity: int = 10_000,
        dropped: Callable[[Item], None] = lambda item: None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Make an empty queue, which calls `dropped` with each item that expired in it."""
        self._capacity = capacity
        self._dropped = dropped
        self._clock = clock
        self._items: OrderedDict[int, tuple[float, Item]] = OrderedDict()
        self._buckets: dict[int, set[int]] = {}
        self._tick = self._tick_of(clock())
        self._tickets = 0

    def __len__(self) -> int:
        """Return the number of items, without those whose bucket was dropped."""
        self._drop_buckets()
        return len(self._items)

    def put(self, item: Item, time_to_live: float = math.inf) -> int:
        """Append an item that expires in `time_to_live` seconds, and return its ticket.

        Raises:
            QueueFull: the queue contains as many items as it can.
        """
        self._drop_buckets()
        if len(self._items) >= self._capacity:
            raise QueueFull
        self._tickets += 1
        expiry = self._clock() + time_to_live
        self._items[self._tickets] = (expiry, item)
        if expiry < math.inf:
            self._buckets.setdefault(self._tick_of(expiry), set()).add(self._tickets)
        return self._tickets

    def take(self) -> tuple[float, Item] | None:
        """Remove the oldest item, and return the seconds that it has left and the item."""
        self._drop_buckets()
        while self._items:
            ticket, (expiry, item) = self._items.popitem(last=False)
            self._forget(ticket, expiry)
            left = expiry - self._clock()
            if left > 0:
                return left, item
            self._dropped(item)
        return None

    def discard(self, ticket: int) -> bool:
        """Remove the item of a ticket. Return whether it was still in the queue."""
        entry = self._items.pop(ticket, None)
        if entry:
            self._forget(ticket, entry[0])
        return entry is not None

    def clear(self) -> None:
        """Drop all items."""
        while self._items:
            self._dropped(self._items.popitem(last=False)[1][1])
        self._buckets.clear()

    def _drop_buckets(self) -> None:
        now = self._tick_of(self._clock())
        passed = range(self._tick, now)
        over = passed if len(passed) < len(self._buckets) else [t for t in self._buckets if t < now]
        self._tick = now
        for tick in over:
            for ticket in self._buckets.pop(tick, ()):
                entry = self._items.pop(ticket, None)
                if entry:
                    self._dropped(entry[1])

    def _forget(self, ticket: int, expiry: float) -> None:
        """Remove a ticket from its bucket."""
        if expiry == math.inf:
            return
        tick = self._tick_of(expiry)
        bucket = self._buckets.get(tick, set())
        bucket.discard(ticket)
        if not bucket:
            self._buckets.pop(tick, None)

    @staticmethod
    def _tick_of(seconds: float) -> int:
        return math.floor(seconds / TICK)
