"""A queue whose items expire."""

from __future__ import annotations

import math
import threading
import time
from collections import OrderedDict
from collections.abc import Callable
from typing import Generic, TypeVar

Item = TypeVar("Item")

TICK = 0.05  # seconds
CAPACITY = 10_000
# The bytes of all messages in a queue. It bounds the memory when messages are large.
HEAVIEST = 64 << 20


class QueueFull(Exception):
    """The queue contains as much as it can."""


class ExpiringQueue(Generic[Item]):
    """A queue whose items expire, each at its own time. All threads may use it.

    Every operation takes constant time, amortized, however many items expire and wherever they
    are: the items that expire in the same tick of the clock are in one bucket.
    """

    def __init__(
        self,
        capacity: int = CAPACITY,
        dropped: Callable[[Item], None] = lambda item: None,
        clock: Callable[[], float] = time.monotonic,
        heaviest: int = HEAVIEST,
    ) -> None:
        """Make an empty queue, which calls `dropped` with each item that expired in it."""
        self._capacity = capacity
        self._dropped = dropped
        self._clock = clock
        self._heaviest = heaviest
        # By ticket: expiry, item, weight.
        self._items: OrderedDict[int, tuple[float, Item, int]] = OrderedDict()
        self._buckets: dict[int, set[int]] = {}
        self._tick = self._tick_of(clock())
        self._tickets = 0
        self._weight = 0
        # Items that are dropped may ask the queue something.
        self._lock = threading.RLock()

    def __len__(self) -> int:
        """Return the number of items, without those whose bucket was dropped."""
        with self._lock:
            self._drop_buckets()
            return len(self._items)

    def put(self, item: Item, time_to_live: float = math.inf, weight: int = 0) -> int:
        """Append an item that expires in `time_to_live` seconds, and return its ticket.

        Raises:
            QueueFull: there are `capacity` items, or they weigh `heaviest` bytes with this one.
        """
        with self._lock:
            self._drop_buckets()
            heavy = self._items and self._weight + weight > self._heaviest
            if len(self._items) >= self._capacity or heavy:
                raise QueueFull(f"the queue is full: {len(self._items)} messages are waiting")
            self._tickets += 1
            expiry = self._clock() + time_to_live
            self._items[self._tickets] = (expiry, item, weight)
            self._weight += weight
            if expiry < math.inf:
                self._buckets.setdefault(self._tick_of(expiry), set()).add(self._tickets)
            return self._tickets

    def take(self) -> tuple[float, Item] | None:
        """Remove the oldest item, and return the seconds that it has left and the item."""
        with self._lock:
            self._drop_buckets()
            while self._items:
                ticket, (expiry, item, weight) = self._items.popitem(last=False)
                self._forget(ticket, expiry, weight)
                left = expiry - self._clock()
                if left > 0:
                    return left, item
                self._dropped(item)
        return None

    def discard(self, ticket: int) -> bool:
        """Remove the item of a ticket. Return whether it was still in the queue."""
        with self._lock:
            entry = self._items.pop(ticket, None)
            if entry:
                self._forget(ticket, entry[0], entry[2])
            return entry is not None

    def clear(self) -> None:
        """Drop all items."""
        with self._lock:
            while self._items:
                self._dropped(self._items.popitem(last=False)[1][1])
            self._buckets.clear()
            self._weight = 0

    def _drop_buckets(self) -> None:
        now = self._tick_of(self._clock())
        if now == self._tick:
            return
        passed = range(self._tick, now)
        over = passed if len(passed) < len(self._buckets) else [t for t in self._buckets if t < now]
        self._tick = now
        for tick in over:
            for ticket in self._buckets.pop(tick, ()):
                entry = self._items.pop(ticket, None)
                if entry:
                    self._weight -= entry[2]
                    self._dropped(entry[1])

    def _forget(self, ticket: int, expiry: float, weight: int) -> None:
        """Remove a ticket from its bucket."""
        self._weight -= weight
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
