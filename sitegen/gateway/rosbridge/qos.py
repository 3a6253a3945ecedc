"""The quality of service that clients ask for, and that fits what is there."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from sitegen.gateway.native import Endpoint, Qos
from sitegen.gateway.rosbridge.operation import InvalidOperationError

DEEPEST = 10_000
WORDS = {
    "reliability": {"reliable": {"reliable": True}, "best_effort": {"reliable": False}},
    "durability": {
        "transient_local": {"transient_local": True},
        "volatile": {"transient_local": False},
    },
    "history": {"keep_all": {"keep_all": True}, "keep_last": {"keep_all": False}},
}


def given(message: dict[str, Any], default: Qos) -> Qos:
    """Return `default` with what an operation says in "qos"."""
    said = message.get("qos")
    if said is None:
        return default
    if not isinstance(said, dict):
        raise InvalidOperationError(f"{message['op']}: 'qos' must be an object")
    found = default
    for key, words in WORDS.items():
        word = str(said.get(key, "system_default")).lower()
        if word in words:
            found = replace(found, **words[word])
        elif word not in ("system_default", "best_available", "unknown"):
            raise InvalidOperationError(f"{message['op']}: '{word[:40]}' is no {key}")
    depth = said.get("depth")
    if isinstance(depth, int) and 0 < depth <= DEEPEST:
        found = replace(found, depth=depth)
    return found


def fitting(publishers: Iterable[Endpoint], depth: int) -> Qos:
    """Return a profile that matches all publishers, and is as good as they allow.

    Without publishers, it is reliable, as most of them are.
    """
    offered = [endpoint.qos for endpoint in publishers]
    return Qos(
        depth=depth,
        reliable=all(qos.reliable for qos in offered),
        transient_local=bool(offered) and all(qos.transient_local for qos in offered),
    )
