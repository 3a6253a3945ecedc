"""A message of rowe: a JSON object, with three fields that rowe itself reads."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import Any

LONGEST = 1 << 20  # bytes of a message as JSON

Body = dict[str, Any]


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
    if not isinstance(body, dict):
        raise InvalidMessage(f"a message is a JSON object, not {type(body).__name__}")
    fields: Body = {"message_id": message_id, "in_reply_to": in_reply_to}
    if time_to_live < math.inf:
        fields["time_to_live"] = round(max(time_to_live, 0), 6)
    taken = {name for name in ("message_id", "in_reply_to", "time_to_live") if name in body}
    if taken:
        raise InvalidMessage(f"'{min(taken)}' is a field of rowe; use another name")
    own = {name: value for name, value in fields.items() if value is not None}
    try:
        text = json.dumps({**own, **body}, allow_nan=False, separators=(",", ":"))
    except (TypeError, ValueError, RecursionError) as error:
        raise InvalidMessage(f"the message is not valid JSON: {error}") from error
    if len(text) > LONGEST:
        raise InvalidMessage(f"the message has {len(text)} bytes; the limit is {LONGEST}")
    return text


def decode(text: str, peer: str) -> Message:
    """Read a message that `peer` sent.

    Raises:
        InvalidMessage: the text is not a JSON object, or a field of rowe has a wrong type.
    """
    try:
        body = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise InvalidMessage(f"not valid JSON: {error}") from error
    if not isinstance(body, dict):
        raise InvalidMessage("not a JSON object")
    names = [body.pop(name, None) for name in ("message_id", "in_reply_to")]
    for name, value in zip(("message_id", "in_reply_to"), names, strict=True):
        if value is not None and not isinstance(value, str):
            raise InvalidMessage(f"{name}: must be text")
    seconds = body.pop("time_to_live", math.inf)
    # A comparison with NaN, which Python's JSON has, is false.
    number = isinstance(seconds, int | float) and not isinstance(seconds, bool)
    if not number or not seconds >= 0:
        raise InvalidMessage("time_to_live: must be a number of seconds, 0 or more")
    return Message(body, peer, names[0], names[1], float(seconds))
