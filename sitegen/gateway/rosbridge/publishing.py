"""Operations of clients that publish: advertise, unadvertise, publish."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, field
from typing import Any

from sitegen.gateway.native import Publisher, Qos, load_type, to_cdr
from sitegen.gateway.rosbridge.decode import from_json
from sitegen.gateway.rosbridge.operation import (
    InvalidOperationError,
    flag,
    graph_name,
    number,
    text,
)
from sitegen.gateway.rosbridge.qos import given
from sitegen.gateway.rosbridge.session import Operation, Session
from sitegen.gateway.rosbridge.typenames import full

# How long a topic may take to come (s).
PATIENCE = 1.0
SETTLING = 0.05
DEEPEST_QUEUE = 10_000


@dataclass
class Advertised:
    """A publisher of the client; several of its parts may have advertised it."""

    publisher: Publisher
    type: str
    # By the ids of these parts; None for the one without id.
    holders: set[Any] = field(default_factory=set)
    matched: bool = False


class Publishing:
    """The publishers of one client, by topic."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._topics: dict[str, Advertised] = {}

    async def advertise(self, message: dict[str, Any]) -> None:
        """Make a publisher."""
        topic = graph_name(message, "topic")
        type_name = full(text(message, "type"), "msg")
        self._session.allow("publish", topic)
        known = self._topics.get(topic)
        if known and known.type == type_name:
            known.holders.add(message.get("id"))
            return
        if known:
            other = f"{topic} is advertised as {known.type}, not {type_name}"
            raise InvalidOperationError(f"advertise: {other}")
        depth = int(min(number(message, "queue_size", 100), DEEPEST_QUEUE)) or 100
        default = Qos(depth=depth, transient_local=flag(message, "latch"))
        await self._make(topic, type_name, given(message, default), message.get("id"))

    async def unadvertise(self, message: dict[str, Any]) -> None:
        """Remove a publisher, unless other parts of the client have advertised it, too."""
        topic = graph_name(message, "topic")
        known = self._topics.get(topic)
        if known is None:
            self._session.status("warning", f"{topic} is not advertised", message.get("id"))
            return
        if message.get("id") is not None:
            known.holders.discard(message["id"])
        if message.get("id") is None or not known.holders:
            del self._topics[topic]
            await known.publisher.close()

    async def publish(self, message: dict[str, Any]) -> None:
        """Publish a message; a topic that was not advertised has its type from the graph."""
        topic = graph_name(message, "topic")
        known = self._topics.get(topic)
        # It may have been allowed before: turns end.
        self._session.allow("publish", topic)
        if known is None:
            # What stands for another protocol may know it.
            type_name = full(text(message, "type"), "msg") if "type" in message else ""
            type_name = type_name or await self._session.type_of("publisher", topic, PATIENCE)
            if not type_name:
                raise InvalidOperationError(f"publish: {topic} is unknown; advertise it first")
            default = Qos(depth=100, transient_local=flag(message, "latch"))
            known = await self._make(topic, type_name, default, None)
        data = to_cdr(from_json(message.get("msg"), load_type(known.type)))
        if not known.matched:
            known.matched = True
            await self._wait(known)
        await known.publisher.publish(data)
        self._session.access.published(topic, known.type, data)

    async def _make(self, topic: str, type_name: str, qos: Qos, holder: Any) -> Advertised:
        limit = self._session.access.rules.limits.publishers
        if len(self._topics) >= limit:
            raise InvalidOperationError(f"advertise: {limit} topics are the limit")
        there = await self._session.type_of("publisher", topic)
        if there and there != type_name:
            raise InvalidOperationError(f"advertise: {topic} has the type {there}, not {type_name}")
        publisher = await self._session.party.advertise(topic, type_name, qos)
        made = self._topics[topic] = Advertised(publisher, type_name, {holder})
        return made

    async def _wait(self, known: Advertised) -> None:
        """Wait for subscriptions that are known, or they would miss the first message."""
        name = known.publisher.endpoint.name
        subscribed = any(
            endpoint.kind == "subscription"
            and endpoint.name == name
            and endpoint.qos.accepts(known.publisher.endpoint.qos)
            for endpoint in self._session.native.endpoints
        )
        if subscribed:
            await known.publisher.settle()
            # The subscription learns of it at about the same time.
            await asyncio.sleep(SETTLING)


def operations(session: Session) -> dict[str, Operation]:
    """Return the operations of this group."""
    publishing = Publishing(session)
    return {
        "advertise": publishing.advertise,
        "unadvertise": publishing.unadvertise,
        "publish": publishing.publish,
    }
