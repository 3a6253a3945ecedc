"""Check and write what travels between a page and its gateway."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, get_args

from sitegen.gateway.native import Endpoint, Qos
from sitegen.gateway.native.endpoint import Kind

# As in sitegen/runtime/protocol.js: reader, writer, sequence, size, timestamp.
HEAD = struct.Struct("<IIIId")
# The largest message, text or frame (bytes), and the longest name.
LARGEST = 64 * 1024 * 1024
_NAME = 255
# The largest history that a page may ask for.
_DEPTH = 5000


class InvalidMessageError(Exception):
    """A page has sent what the protocol does not allow; the text says what."""


@dataclass(frozen=True)
class Record:
    """A message on its way: see docs/gateway-protocol.md."""

    reader: int
    writer: int
    sequence: int
    data: bytes


@dataclass(frozen=True)
class Announced:
    """An endpoint of a page; one without `node` is not shown in the native graph."""

    id: int
    kind: Kind
    node: str
    name: str
    type: str
    hash: str
    qos: Qos


def records(frame: bytes) -> Iterator[Record]:
    """Return the records of a frame.

    Raises:
        InvalidMessageError: the frame does not end with a record
    """
    at = 0
    while at < len(frame):
        if at + HEAD.size > len(frame):
            raise InvalidMessageError("a frame that ends within a record")
        reader, writer, sequence, size, _ = HEAD.unpack_from(frame, at)
        end = at + HEAD.size + size
        if end > len(frame):
            raise InvalidMessageError("a frame that ends within a record")
        yield Record(reader, writer, sequence, frame[at + HEAD.size : end])
        at += HEAD.size + ((size + 7) & ~7)


def record(reader: int, writer: int, sequence: int, data: bytes, time: float) -> bytes:
    """Return the bytes of a record; `time` is that of sending (ms since 1970)."""
    head = HEAD.pack(reader, writer, sequence % 2**32, len(data), time)
    return head + data + bytes(-len(data) % 8)


def parse(text: str) -> dict[str, Any]:
    """Return a message in JSON.

    Raises:
        InvalidMessageError: it is no object with an `op`
    """
    try:
        message = json.loads(text)
    except (ValueError, RecursionError):
        raise InvalidMessageError("a text that is not JSON") from None
    if not isinstance(message, dict) or not isinstance(message.get("op"), str):
        raise InvalidMessageError("a text without an 'op'")
    return message


def announced(given: Any) -> Announced:
    """Return an endpoint that a page announces.

    Raises:
        InvalidMessageError: a field is missing or not valid
    """
    if not isinstance(given, dict) or given.get("kind") not in get_args(Kind):
        raise InvalidMessageError("an invalid endpoint")
    texts = [given.get(key, "") for key in ("node", "name", "type", "hash")]
    if not all(map(is_name, texts)):
        raise InvalidMessageError("an invalid endpoint")
    node, name, type_name, digest = texts
    id, qos = number(given.get("id")), _qos(given.get("qos"))
    return Announced(id, given["kind"], node, name, type_name, digest, qos)


def is_name(given: Any) -> bool:
    """Return whether something is a text as short as the names of ROS."""
    return isinstance(given, str) and len(given) <= _NAME


def number(given: Any) -> int:
    """Return an id.

    Raises:
        InvalidMessageError: it is none
    """
    if type(given) is not int or not 0 < given < 2**32:
        raise InvalidMessageError("an invalid id")
    return given


def described(id: int, endpoint: Endpoint) -> dict[str, Any]:
    """Return an endpoint as pages are told of it."""
    qos = endpoint.qos
    return {
        "id": id,
        "kind": endpoint.kind,
        "node": endpoint.node,
        "name": endpoint.name,
        "type": endpoint.type,
        "hash": endpoint.hash,
        "qos": {
            "depth": qos.depth,
            "reliable": qos.reliable,
            "transientLocal": qos.transient_local,
            "keepAll": qos.keep_all,
            "deadline": _limit(qos.deadline),
            "lifespan": _limit(qos.lifespan),
            "manual": qos.manual,
            "lease": _limit(qos.lease),
        },
    }


def _limit(milliseconds: float) -> float | None:
    return None if math.isinf(milliseconds) else milliseconds


def _qos(given: Any) -> Qos:
    if given is None:
        return Qos()
    if not isinstance(given, dict):
        raise InvalidMessageError("an invalid quality of service")
    flags = [given.get(key, False) for key in ("reliable", "transientLocal", "keepAll", "manual")]
    times = [given.get(key) for key in ("deadline", "lifespan", "lease")]
    depth = given.get("depth", 10)
    sound = all(type(flag) is bool for flag in flags) and type(depth) is int and depth >= 0
    if not sound or not all(time is None or _is_time(time) for time in times):
        raise InvalidMessageError("an invalid quality of service")
    reliable, transient_local, keep_all, manual = flags
    # Profiles spell "none" as zero, too.
    deadline, lifespan, lease = (float(time) if time else math.inf for time in times)
    return Qos(
        min(depth, _DEPTH), reliable, transient_local, keep_all, deadline, lifespan, manual, lease
    )


def _is_time(given: Any) -> bool:
    return type(given) in (int, float) and 0 <= given < 2**53
