"""A message of rowe: a JSON object, with three fields that rowe itself reads."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import Any

LONGEST = 1 << 20  # bytes of a message as JSON
DEEPEST = 100  # objects and arrays in each other

Body = dict[str, Any]
OWN = ("message_id", "in_reply_to", "time_to_live")


class InvalidMessage(ValueError):
    """A message that is not a JSON object, is too long, or has an invalid field of rowe."""


@dataclass(frozen=True)
class Message:
    """A message that arrived.

    `body` is the JSON object without the fields of rowe, and `peer` the name of the sender. A reply
    has the `message_id` of its request in `in_reply_to`. `time_to_live` is in seconds.
    """

    body: Body
    peer: str
    message_id: str | None
    in_reply_to: str | None
    time_to_live: float


def encode(
    body: Body,
    *,
    message_id: str | None = None,
    in_reply_to: str | None = None,
    time_to_live: float = math.inf,
) -> str:
    """Return a message as JSON.

    Raises:
        InvalidMessage: the body is not a JSON object, or is longer than a mebibyte.
    """
    fields = {"message_id": message_id, "in_reply_to": in_reply_to}
    given = {name: value for name, value in fields.items() if value is not None}
    return timed(encode_fields(body, given), time_to_live)


def encode_fields(body: Body, fields: dict[str, str]) -> str:
    """Return a message as JSON, but for its time to live, which `timed` adds when it is sent."""
    if not isinstance(body, dict):
        raise InvalidMessage(f"a message is a JSON object, not {type(body).__name__}")
    taken = {name for name in OWN if name in body}
    if taken:
        raise InvalidMessage(f"'{min(taken)}' is a field of rowe; use another name")
    try:
        text = json.dumps({**fields, **body}, allow_nan=False, separators=(",", ":"))
    except (TypeError, ValueError, RecursionError) as error:
        raise InvalidMessage(f"the message is not valid JSON: {error}") from error
    if len(text) > LONGEST:
        raise InvalidMessage(f"the message has {len(text)} bytes; the limit is {LONGEST}")
    _check_depth(text, body)
    return text


def timed(text: str, time_to_live: float) -> str:
    """Return the message `text` with the time that it has left."""
    if time_to_live == math.inf:
        return text
    field = f'{{"time_to_live":{max(time_to_live, 0):.6f}'
    return f"{field}}}" if text == "{}" else f"{field},{text[1:]}"


def decode(text: str, peer: str) -> Message:
    """Read a message that `peer` sent.

    Raises:
        InvalidMessage: the text is not a JSON object, or a field of rowe has a wrong type.
    """
    try:
        body = json.loads(text, parse_constant=_no_constant)
    except RecursionError:
        raise InvalidMessage(f"nested more than {DEEPEST} levels deep") from None
    except ValueError as error:
        raise InvalidMessage(f"not valid JSON: {error}") from error
    if not isinstance(body, dict):
        raise InvalidMessage("not a JSON object")
    _check_depth(text, body)
    names = [body.pop(name, None) for name in ("message_id", "in_reply_to")]
    for name, value in zip(("message_id", "in_reply_to"), names, strict=True):
        if value is not None and not isinstance(value, str):
            raise InvalidMessage(f"{name}: must be text")
    seconds = body.pop("time_to_live", math.inf)
    number = isinstance(seconds, int | float) and not isinstance(seconds, bool)
    if not number or not seconds >= 0:
        raise InvalidMessage("time_to_live: must be a number of seconds, 0 or more")
    try:
        return Message(body, peer, names[0], names[1], float(seconds))
    except OverflowError:  # an integer of more than 308 digits
        return Message(body, peer, names[0], names[1], math.inf)


def _no_constant(name: str) -> None:
    # Python's JSON has numbers that no other language reads.
    raise ValueError(f"{name} is not a number of JSON")


def _check_depth(text: str, body: Body) -> None:
    """Raise InvalidMessage if values are nested too deeply. Most texts have too few brackets."""
    if text.count("{") + text.count("[") <= DEEPEST:
        return
    level: list[Any] = [body]
    for _ in range(DEEPEST):
        level = [
            inner
            for value in level
            for inner in (value.values() if isinstance(value, dict) else value)
            if isinstance(inner, dict | list | tuple)
        ]
        if not level:
            return
    raise InvalidMessage(f"nested more than {DEEPEST} levels deep")
