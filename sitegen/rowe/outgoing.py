"""A message that waits to be sent, and the queue of such messages."""

from __future__ import annotations

import threading
from concurrent.futures import Future

from sitegen.rowe.expiring import ExpiringQueue
from sitegen.rowe.message import Body, encode_fields


class Outgoing:
    """A message to send; `sent` gets whether it was sent or discarded, if somebody waits for it."""

    __slots__ = ("_done", "_lock", "_sending", "sent", "text")

    def __init__(self, body: Body, fields: dict[str, str], waits: bool = False) -> None:
        """Encode a message now, so that the caller may change its body afterwards."""
        self.text = encode_fields(body, fields)
        # A future takes longer to make than all the rest.
        self.sent: Future[bool] | None = Future() if waits else None
        self._lock = threading.Lock()
        self._sending = False
        self._done = False

    def begin(self) -> bool:
        """Return whether it may be sent. From now on, it is sent or fails, but does not expire."""
        with self._lock:
            self._sending = not self._done
            return self._sending

    def failed(self) -> None:
        """Let it expire again: it waits for the next connection."""
        with self._lock:
            self._sending = False

    def settle(self, sent: bool) -> None:
        """Tell whoever waits for it."""
        with self._lock:
            self._settle(sent)

    def expire(self) -> None:
        """Discard it, unless it is being sent."""
        with self._lock:
            if not self._sending:
                self._settle(False)

    def _settle(self, sent: bool) -> None:
        if not self._done:
            self._done = True
            if self.sent:
                self.sent.set_result(sent)


def outgoing_queue() -> ExpiringQueue[Outgoing]:
    """Return an empty queue of messages to send."""
    return ExpiringQueue(dropped=lambda message: message.settle(False))
