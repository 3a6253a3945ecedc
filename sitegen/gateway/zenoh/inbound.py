"""What the publishers of peers send, published in the native graph."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import zenoh
from zenoh import ext, handlers

from sitegen.gateway.access import Access
from sitegen.gateway.native import NativeError, Publisher
from sitegen.gateway.zenoh.attachment import Attachment
from sitegen.gateway.zenoh.held import Held, hold
from sitegen.gateway.zenoh.keys import Token


@dataclass(frozen=True)
class Arrived:
    """A message that has come, with the key that it was sent to."""

    key: str
    data: bytes
    attachment: Attachment


@dataclass
class _Incoming:
    """A publisher of a peer, and the native one that stands for it."""

    token: Token
    publisher: Publisher
    access: Access
    # The number of the last message.
    last: int = -1
    # Waits until the native publisher has found its subscriptions; None afterwards.
    held: Held[bytes] | None = field(default_factory=Held)
    settling: asyncio.Task[None] | None = None


class Inbound:
    """The subscribers of this gateway on the network, and the publishers that they feed."""

    def __init__(self, session: zenoh.Session, received: Callable[[zenoh.Sample], None]) -> None:
        """Call `received` with each sample, in a thread of Zenoh."""
        self._session = session
        self._handler = handlers.Callback(received, indirect=False)
        # By the key of the messages, then by the gid.
        self._incoming: dict[str, dict[bytes, _Incoming]] = {}
        self._looked: set[str] = set()
        self._subscribers: dict[str, Any] = {}
        self._unclaimed: dict[str, Held[Arrived]] = {}

    def open(self, token: Token, publisher: Publisher, access: Access) -> None:
        """Publish with `publisher` what comes from the publisher of a token."""
        incoming = _Incoming(token, publisher, access)
        self._incoming.setdefault(token.data_key, {})[token.gid] = incoming
        self._subscribe()
        if unclaimed := self._unclaimed.pop(token.data_key, None):
            unclaimed.release(self.take)

    async def shut(self, token: Token) -> None:
        """Publish what has come from a publisher that has gone, and no more."""
        group = self._incoming.get(token.data_key, {})
        incoming = group.get(token.gid)
        if incoming is None:
            return
        if incoming.settling:
            await incoming.settling
        self._incoming[token.data_key] = {
            gid: one for gid, one in group.items() if one is not incoming
        }
        if not self._incoming[token.data_key]:
            del self._incoming[token.data_key]
        self._subscribe()

    def look(self, keys: set[str]) -> None:
        """Get the messages of these keys, which somebody here looks at."""
        self._looked = keys
        self._subscribe()

    def take(self, arrived: Arrived) -> asyncio.Future[None] | None:
        """Publish a message; the future is done when the middleware has it."""
        incoming = self._find(arrived)
        if incoming is None:
            if arrived.key in self._subscribers:
                hold(self._unclaimed, arrived.key).add(arrived, len(arrived.data))
            return None
        # The history of a publisher comes again with each subscriber.
        if arrived.attachment.sequence <= incoming.last:
            return None
        incoming.last = arrived.attachment.sequence
        token, access = incoming.token, incoming.access
        if len(arrived.data) > access.rules.limits.message_size:
            access.refused(f"a message on {token.name} exceeds the limit; it was dropped")
            return None
        access.published(token.name, token.type, arrived.data)
        if incoming.held:
            incoming.held.add(arrived.data, len(arrived.data))
            incoming.settling = incoming.settling or asyncio.create_task(_settle(incoming))
            return None
        return _publish(incoming, arrived.data)

    def close(self) -> None:
        """End all subscribers."""
        for subscriber in self._subscribers.values():
            subscriber.undeclare()
        self._subscribers.clear()
        for group in self._incoming.values():
            for incoming in group.values():
                if incoming.settling:
                    incoming.settling.cancel()

    def _find(self, arrived: Arrived) -> _Incoming | None:
        group = self._incoming.get(arrived.key)
        if not group:
            return None
        gid = arrived.attachment.gid
        if gid not in group:
            # Not all programs derive it from their token: it is of one that was not heard yet.
            silent = [one for one in group.values() if one.last < 0]
            if silent:
                group[gid] = silent[0]
        return group.get(gid)

    def _subscribe(self) -> None:
        """Subscribe to what is looked at and to what is latched, and to nothing else."""
        latched = {
            key
            for key, group in self._incoming.items()
            for one in group.values()
            if one.token.qos.transient_local
        }
        needed = self._looked | latched
        for key in self._subscribers.keys() - needed:
            self._subscribers.pop(key).undeclare()
            self._unclaimed.pop(key, None)
        history = ext.HistoryConfig(detect_late_publishers=True)
        for key in needed - self._subscribers.keys():
            self._subscribers[key] = ext.declare_advanced_subscriber(
                self._session, key, self._handler, history=history
            )


async def _settle(incoming: _Incoming) -> None:
    """Let a new native publisher find its subscriptions, then publish what has waited."""
    # What is latched waits for them by itself.
    if not incoming.token.qos.transient_local:
        await incoming.publisher.settle()
    held, incoming.held, incoming.settling = incoming.held, None, None
    if held:
        held.release(lambda data: _publish(incoming, data))


def _publish(incoming: _Incoming, data: bytes) -> asyncio.Future[None]:
    future = incoming.publisher.publish(data)

    def done(future: asyncio.Future[None]) -> None:
        if not future.cancelled() and isinstance(error := future.exception(), NativeError):
            incoming.access.refused(f"{incoming.token.name}: {error}")

    future.add_done_callback(done)
    return future
