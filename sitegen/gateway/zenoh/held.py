"""Messages that wait for the endpoint that they belong to."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Generic, TypeVar

K = TypeVar("K")
T = TypeVar("T")

_MOST = 1000
_MOST_BYTES = 16 * 1024 * 1024
_MOST_QUEUES = 16


class Held(Generic[T]):
    """A queue of messages; of too many, the newest stay."""

    def __init__(self) -> None:
        self._items: deque[tuple[T, int]] = deque()
        self._bytes = 0

    def add(self, item: T, size: int) -> None:
        """Add a message of `size` bytes."""
        self._items.append((item, size))
        self._bytes += size
        while len(self._items) > 1 and (len(self._items) > _MOST or self._bytes > _MOST_BYTES):
            self._bytes -= self._items.popleft()[1]

    def release(self, take: Callable[[T], object]) -> None:
        """Call `take` with each message, oldest first, and keep none."""
        while self._items:
            item, size = self._items.popleft()
            self._bytes -= size
            take(item)


def hold(queues: dict[K, Held[T]], key: K) -> Held[T]:
    """Return the queue of `key`; of too many, the oldest goes, whose endpoint never came."""
    if key not in queues:
        if len(queues) >= _MOST_QUEUES:
            del queues[next(iter(queues))]
        queues[key] = Held()
    return queues[key]
