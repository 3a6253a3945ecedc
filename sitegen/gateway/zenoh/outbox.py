"""Send messages over Zenoh in a thread of their own, because a slow network blocks it."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable

# Sends one message.
Send = Callable[[], None]


class Outbox:
    """A queue from the event loop to the thread that sends."""

    def __init__(self, most: int, dropped: Callable[[], None]) -> None:
        """Hold `most` bytes; of what comes then, nothing is sent, and `dropped` is called."""
        self._most = most
        self._dropped = dropped
        self._items: deque[tuple[Send, int]] = deque()
        self._bytes = 0
        self._news = threading.Condition()
        self._closed = False
        self._thread = threading.Thread(target=self._run, name="zenoh", daemon=True)
        self._thread.start()

    def put(self, send: Send, size: int) -> None:
        """Send a message of `size` bytes after those that were put before."""
        with self._news:
            if self._bytes + size > self._most and self._items:
                self._dropped()
                return
            self._items.append((send, size))
            self._bytes += size
            self._news.notify()

    def close(self) -> None:
        """Send what is there, but not for long, and end the thread."""
        with self._news:
            self._closed = True
            self._news.notify()
        self._thread.join(1)

    def _run(self) -> None:
        while True:
            with self._news:
                self._news.wait_for(lambda: self._items or self._closed)
                if not self._items:
                    return
                send, size = self._items.popleft()
                self._bytes -= size
            send()
