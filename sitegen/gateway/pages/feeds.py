"""What waits to be sent to a page: the messages of topics that it looks at, within bounds."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

from sitegen.gateway.native import Endpoint, Sample
from sitegen.gateway.pages.wire import record

# Sent and not yet taken by the page: enough for a fast network, little for a tab that sleeps.
WINDOW_BYTES = 4 * 1024 * 1024
WINDOW_RECORDS = 2000
# What waits for the window, of one reliable publisher. Of a best-effort one only the newest waits.
_KEPT_RECORDS = 1000
_KEPT_BYTES = 16 * 1024 * 1024
# Small records share frames up to this size.
_FRAME = 64 * 1024
# Says in the head of a record that it was sent before the page looked.
LATCHED = 1


class Feed:
    """The messages of one publisher for one page."""

    def __init__(self, id: int, endpoint: Endpoint, period: int) -> None:
        self.id = id
        self.endpoint = endpoint
        self._period = period
        self._queue: deque[Sample] = deque()
        self._bytes = 0
        self._sent = 0
        self._last = 0
        self._numbered = 0
        self.open = True
        # Whether it is in the queue of those that have their turn.
        self.waiting = False

    def push(self, sample: Sample) -> bool:
        """Add a message, unless it has come before or too soon; return whether it was added."""
        if not self.open:
            return False
        # Several subscriptions may have brought it, also the one before the page looked away.
        if sample.sequence is not None:
            if sample.sequence <= self._last:
                return False
            self._last = sample.sequence
        if self._period and not sample.latched and sample.time - self._sent < self._period:
            return False
        self._sent = sample.time
        self._queue.append(sample)
        self._bytes += len(sample.data)
        most = _KEPT_RECORDS if self.endpoint.qos.reliable else 1
        while len(self._queue) > 1 and (len(self._queue) > most or self._bytes > _KEPT_BYTES):
            self._bytes -= len(self._queue.popleft().data)
        return True

    def pop(self) -> bytes | None:
        """Remove the oldest message and return its record, or None."""
        if not self._queue:
            return None
        sample = self._queue.popleft()
        self._bytes -= len(sample.data)
        self._numbered += 1
        reader = LATCHED if sample.latched else 0
        return record(reader, self.id, self._numbered, sample.data, sample.time / 1e6)

    def close(self) -> None:
        """Take no more until the page looks again."""
        self.open = False
        self._queue.clear()
        self._bytes = 0


class Feeds:
    """All feeds of a page, and the window of what may be on its way."""

    def __init__(self, wake: Callable[[], None]) -> None:
        self._wake = wake
        self._feeds: dict[int, Feed] = {}
        self._turns: deque[Feed] = deque()
        self._bytes = 0
        self._records = 0

    def get(self, id: int) -> Feed | None:
        """Return the feed of a publisher, open or not."""
        return self._feeds.get(id)

    def open(self, id: int, endpoint: Endpoint, period: int) -> Feed:
        """Begin to take the messages of a publisher, at most one in `period` (ns)."""
        feed = self._feeds.get(id)
        if feed is None:
            feed = self._feeds[id] = Feed(id, endpoint, period)
        feed.open = True
        return feed

    def remove(self, id: int) -> None:
        """Forget a publisher that is gone, once what it sent is sent."""
        self._feeds.pop(id, None)

    def push(self, feed: Feed, sample: Sample) -> bool:
        """Add a message; return whether it was neither too soon nor there before."""
        if not feed.push(sample):
            return False
        if not feed.waiting:
            feed.waiting = True
            self._turns.append(feed)
        self._wake()
        return True

    def credit(self, count: int, size: int) -> None:
        """The page has taken messages."""
        self._records = max(0, self._records - count)
        self._bytes = max(0, self._bytes - size)
        self._wake()

    def frame(self) -> bytes | None:
        """Return the next frame, or None while the window is full or nothing waits."""
        parts: list[bytes] = []
        size = 0
        while self._turns and size < _FRAME and self._has_room():
            feed = self._turns.popleft()
            part = feed.pop()
            if part is None:
                feed.waiting = False
                continue
            # Each publisher has its turn, so a large image delays no small message for long.
            self._turns.append(feed)
            parts.append(part)
            size += len(part)
            self._records += 1
            self._bytes += len(part)
        return b"".join(parts) if parts else None

    def _has_room(self) -> bool:
        return self._bytes < WINDOW_BYTES and self._records < WINDOW_RECORDS
