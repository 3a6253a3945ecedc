"""Operations of clients that listen: subscribe, unsubscribe."""

from __future__ import annotations

import asyncio
from typing import Any

from sitegen.gateway.native import Endpoint, Qos, Sample, Subscription
from sitegen.gateway.rosbridge.operation import InvalidOperationError, graph_name, number, text
from sitegen.gateway.rosbridge.qos import fitting, given
from sitegen.gateway.rosbridge.session import Operation, Session
from sitegen.gateway.rosbridge.stream import COMPRESSIONS, Stream, Wish, together
from sitegen.gateway.rosbridge.typenames import full

# The depth of the subscription in the graph; the client's own queue is another.
DEPTH = 100
LONGEST_QUEUE = 10_000
# How long a subscription waits for publishers that the graph already has (s).
PATIENCE = 1.0
SETTLING = 0.05


class Listening:
    """One topic that the client listens to, with all its parts."""

    def __init__(self, session: Session, topic: str, type_name: str, qos: Qos | None) -> None:
        self.type = type_name
        self.wishes: dict[Any, Wish] = {}
        self.stream = Stream(session, topic, type_name, Wish())
        self._session = session
        self._topic = topic
        # Without a wish of the client, the quality of service follows the publishers.
        self._own = qos
        self._qos = Qos()
        self._subscription: Subscription | None = None
        # The newest message of each publisher, so that none comes twice after a change.
        self._seen: dict[bytes, int] = {}

    def wish(self) -> None:
        """Apply what the parts of the client ask for."""
        self.stream.wish = together(list(self.wishes.values()))

    async def open(self) -> None:
        """Subscribe."""
        self._qos = self._own or fitting(self._publishers(), DEPTH)
        self._subscription = await self._session.party.subscribe(
            self._topic, self.type, self._qos, self._received
        )
        self._session.outbox.streams.append(self.stream)
        # What the client asks for next may make them publish.
        end = asyncio.get_running_loop().time() + PATIENCE
        while self._publishers() and asyncio.get_running_loop().time() < end:
            if await self._subscription.matched():
                # The publisher learns of it at about the same time.
                await asyncio.sleep(0 if self._subscription.shared else SETTLING)
                return
            await asyncio.sleep(0.01)

    async def close(self) -> None:
        """Listen no more."""
        if self.stream in self._session.outbox.streams:
            self._session.outbox.streams.remove(self.stream)
        self.stream.clear()
        if self._subscription:
            subscription, self._subscription = self._subscription, None
            await subscription.close()

    async def adapt(self) -> None:
        """Subscribe again if the publishers are not the ones that the first time was made for."""
        publishers = self._publishers()
        qos = fitting(publishers, DEPTH)
        if self._own or not publishers or not self._subscription or qos == self._qos:
            return
        self._qos, before = qos, self._subscription
        self._subscription = await self._session.party.subscribe(
            self._topic, self.type, qos, self._received
        )
        await before.close()

    def _publishers(self) -> list[Endpoint]:
        return [
            endpoint
            for endpoint in self._session.native.endpoints
            if endpoint.kind == "publisher"
            and endpoint.name == self._topic
            and endpoint.type == self.type
        ]

    def _received(self, sample: Sample) -> None:
        if sample.sequence is not None:
            if sample.sequence <= self._seen.get(sample.gid, -1):
                return
            if len(self._seen) > 1000:
                self._seen.clear()
            self._seen[sample.gid] = sample.sequence
        self._session.access.delivered(self._topic, self.type, sample.data, sample.time)
        self.stream.put(sample)


class Subscribing:
    """The subscriptions of one client, by topic."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._topics: dict[str, Listening] = {}
        session.watchers.append(self._changed)

    async def subscribe(self, message: dict[str, Any]) -> None:
        """Listen to a topic, or add a part of the client that does."""
        topic = graph_name(message, "topic")
        compression = text(message, "compression", "none")
        if compression not in COMPRESSIONS:
            known = ", ".join(COMPRESSIONS)
            raise InvalidOperationError(f"subscribe: the compressions are {known}")
        wish = Wish(
            number(message, "throttle_rate"),
            int(min(number(message, "queue_length"), LONGEST_QUEUE)),
            int(number(message, "fragment_size")),
            compression,
        )
        self._session.allow("subscribe", topic)
        listening = self._topics.get(topic)
        if listening is None:
            listening = await self._listen(topic, message, wish)
        elif message.get("type") and full(message["type"], "msg") != listening.type:
            raise InvalidOperationError(f"subscribe: {topic} has the type {listening.type}")
        if len(listening.wishes) >= LONGEST_QUEUE:
            raise InvalidOperationError(f"subscribe: too many ids for {topic}")
        listening.wishes[message.get("id")] = wish
        listening.wish()

    async def unsubscribe(self, message: dict[str, Any]) -> None:
        """Listen no more: the part of this id, or all parts if there is none."""
        topic = graph_name(message, "topic")
        listening = self._topics.get(topic)
        if listening is None:
            return
        if message.get("id") is None:
            listening.wishes.clear()
        else:
            listening.wishes.pop(message["id"], None)
        if listening.wishes:
            listening.wish()
        else:
            del self._topics[topic]
            await listening.close()

    async def _listen(self, topic: str, message: dict[str, Any], wish: Wish) -> Listening:
        limit = self._session.access.rules.limits.subscriptions
        if len(self._topics) >= limit:
            raise InvalidOperationError(f"subscribe: {limit} topics are the limit")
        patience = 0 if message.get("type") else PATIENCE
        there = await self._session.type_of("publisher", topic, patience)
        wanted = full(message["type"], "msg") if message.get("type") else there
        if not wanted:
            raise InvalidOperationError(f"subscribe: {topic} is unknown; say its type")
        if there and there != wanted:
            raise InvalidOperationError(f"subscribe: {topic} has the type {there}, not {wanted}")
        qos = given(message, Qos(depth=DEPTH)) if message.get("qos") else None
        listening = Listening(self._session, topic, wanted, qos)
        listening.stream.wish = wish
        await listening.open()
        self._topics[topic] = listening
        return listening

    def _changed(self, come: list[Endpoint], gone: list[Endpoint]) -> None:
        for topic in {endpoint.name for endpoint in come if endpoint.kind == "publisher"}:
            if topic in self._topics:
                self._session.start(self._topics[topic].adapt())


def operations(session: Session) -> dict[str, Operation]:
    """Return the operations of this group."""
    subscribing = Subscribing(session)
    return {"subscribe": subscribing.subscribe, "unsubscribe": subscribing.unsubscribe}
