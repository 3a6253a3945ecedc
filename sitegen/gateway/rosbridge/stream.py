"""The messages of one subscription, on their way to the client."""

from __future__ import annotations

import json
import time
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import cbor2

from sitegen.gateway.native import MalformedMessageError, Sample, from_cdr, load_type
from sitegen.gateway.rosbridge.encode import to_cbor, to_json
from sitegen.gateway.rosbridge.session import Session

COMPRESSIONS = ("none", "png", "cbor", "cbor-raw")
# Messages that wait at most, unless the client says how many.
WAITING = 1000


@dataclass(frozen=True)
class Wish:
    """What one part of a client asks for; times in ms, 0 for none, sizes in characters."""

    throttle_rate: float = 0
    queue_length: int = 0
    fragment_size: int = 0
    compression: str = "none"


def together(wishes: list[Wish]) -> Wish:
    """Return what satisfies all parts of a client: a message is sent to it only once."""
    sizes = [wish.fragment_size for wish in wishes if wish.fragment_size]
    chosen = {wish.compression for wish in wishes}
    return Wish(
        min(wish.throttle_rate for wish in wishes),
        max(wish.queue_length for wish in wishes),
        min(sizes, default=0),
        next(name for name in reversed(COMPRESSIONS) if name in chosen),
    )


class Stream:
    """What waits of one topic; each message is encoded when it is due."""

    def __init__(self, session: Session, topic: str, type_name: str, wish: Wish) -> None:
        self.wish = wish
        self._session = session
        self._topic = topic
        self._type = type_name
        self._waiting: deque[Sample] = deque()
        self._last = 0.0

    def put(self, sample: Sample) -> None:
        """Take a message that has come."""
        wish = self.wish
        # With a rate and without a queue, only the newest is of interest.
        most = wish.queue_length or (1 if wish.throttle_rate else WAITING)
        self._waiting.append(sample)
        self._session.outbox.hold(len(sample.data))
        while len(self._waiting) > most:
            self.drop()
        self._session.outbox.wake()

    def due(self) -> float | None:
        """Return when the next message may be sent, None if there is none (s, monotonic)."""
        return self._last + self.wish.throttle_rate / 1000 if self._waiting else None

    def take(self) -> Iterator[str | bytes]:
        """Yield the next message, which may be in fragments."""
        sample = self._pop()
        self._last = time.monotonic()
        wish = self.wish
        try:
            body = encoded(sample, self._topic, self._type, wish.compression)
        except MalformedMessageError as error:
            self._session.status("error", f"{self._topic}: {error}")
            return
        if isinstance(body, bytes):
            yield body
        else:
            yield from self._session.packed(body, wish.compression, wish.fragment_size)

    def drop(self) -> bool:
        """Leave out the oldest message that waits; return whether there was one."""
        if self._waiting:
            self._pop()
            return True
        return False

    def clear(self) -> None:
        """Leave out all."""
        while self.drop():
            pass

    def _pop(self) -> Sample:
        sample = self._waiting.popleft()
        self._session.outbox.hold(-len(sample.data))
        return sample


class _Last:
    """The message that was encoded last: many clients get the same, one after the other."""

    def __init__(self) -> None:
        self.sample: Sample | None = None
        self.body: str | bytes = ""


_last: dict[tuple[str, str, str], _Last] = {}


def encoded(sample: Sample, topic: str, type_name: str, compression: str) -> str | bytes:
    """Return the operation that carries a message.

    Raises: MalformedMessageError if it is no message of this type.
    """
    form = {"png": "none"}.get(compression, compression)
    last = _last.setdefault((topic, type_name, form), _Last())
    if last.sample is not sample:
        last.body = FORMS[form](sample, topic, type_name)
        last.sample = sample
    if len(_last) > 1000:
        _last.clear()
    return last.body


def _text(sample: Sample, topic: str, type_name: str) -> str:
    values = to_json(from_cdr(sample.data, load_type(type_name)))
    body = {"op": "publish", "topic": topic, "msg": values}
    return json.dumps(body, separators=(",", ":"))


def _cbor(sample: Sample, topic: str, type_name: str) -> bytes:
    values = to_cbor(from_cdr(sample.data, load_type(type_name)))
    return cbor2.dumps({"op": "publish", "topic": topic, "msg": values})


def _raw(sample: Sample, topic: str, _: str) -> bytes:
    now = time.time_ns()
    values = {"secs": now // 10**9, "nsecs": now % 10**9, "bytes": sample.data}
    return cbor2.dumps({"op": "publish", "topic": topic, "msg": values})


FORMS: dict[str, Callable[[Sample, str, str], Any]] = {
    "none": _text,
    "cbor": _cbor,
    "cbor-raw": _raw,
}
