"""The endpoints of the native graph, as peers see them, and what the publishers among them send."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import zenoh
from zenoh import ext

from sitegen.gateway.names import PROTECTED, USING
from sitegen.gateway.native import (
    Endpoint,
    Native,
    NativeError,
    Qos,
    Sample,
    Subscription,
    hash_of,
    load_type,
)
from sitegen.gateway.rules import Rules
from sitegen.gateway.zenoh.attachment import Attachment
from sitegen.gateway.zenoh.held import Held, hold
from sitegen.gateway.zenoh.keys import Token, data_key
from sitegen.gateway.zenoh.outbox import Outbox
from sitegen.gateway.zenoh.peer import DEPTHS, is_peer
from sitegen.gateway.zenoh.serving import Serving

# The gateways that join the same graph find each other by the names of these nodes.
MARK = "/_sitegen_zenoh_"


@dataclass
class _Offer:
    """An endpoint of the native graph that peers see."""

    token: Token
    declared: zenoh.LivelinessToken
    # Of Zenoh, for publishers.
    publisher: Any = None
    # What a publisher keeps for late subscriptions has to be on the network before they come.
    collector: Subscription | None = None
    # The number of the last message that was sent.
    last: int = -1


class Outbound:
    """What this gateway has on the network."""

    def __init__(
        self,
        native: Native,
        session: zenoh.Session,
        rules: Rules,
        outbox: Outbox,
        write: Callable[[str], None],
    ) -> None:
        self._native = native
        self._session = session
        self._rules = rules
        self._outbox = outbox
        self._write = write
        # What belongs to nobody is not shown to anybody.
        self._party = native.join(None)
        self._serving = Serving(session, self._party)
        self._offers: dict[str, _Offer] = {}
        self._by_gid: dict[bytes, _Offer] = {}
        self._node_ids: dict[str, int] = {}
        self._ids = itertools.count(1)
        self._early: dict[bytes, Held[Sample]] = {}
        self._unknown: set[str] = set()

    def present(self) -> list[Endpoint]:
        """Return the nodes and endpoints of the native graph that cross."""
        native = self._native
        own = f"/{native.name}"
        found = [one for one in native.endpoints if self._crosses(one)]
        # Panels, and clients of rosbridge, look at topics without a node of their own.
        for (topic, kind, qos), shared in native.shared.items():
            if not all(map(is_peer, shared.owners())):
                key = f"shared {topic} {kind} {qos}"
                looked = Endpoint(key, "subscription", own, topic, kind, "", qos)
                if self._crosses(looked):
                    found.append(looked)
        if any(one.node == own for one in found):
            found.append(Endpoint("own node", "node", own, own, "", "", Qos()))
        return found

    def key(self, endpoint: Endpoint) -> str:
        """Return the key of the messages of a topic."""
        hash = hash_of(endpoint.type)
        return data_key(self._native.domain, endpoint.name, endpoint.type, hash)

    async def update(self, endpoints: Iterable[Endpoint]) -> None:
        """Tell peers which endpoints are there, and which have gone."""
        present = {endpoint.key: endpoint for endpoint in endpoints}
        for key in self._offers.keys() - present.keys():
            await self._withdraw(key)
        come = [one for key, one in present.items() if key not in self._offers]
        # Nodes come before their endpoints.
        for endpoint in sorted(come, key=lambda one: one.kind != "node"):
            await self._offer(endpoint)

    def send(self, sample: Sample) -> bool:
        """Send a message of a native publisher, once, though several subscriptions bring it."""
        if is_peer(sample.owner):
            return False
        offer = self._by_gid.get(sample.gid)
        if offer is None:
            # It is known when the graph has been read, or never.
            hold(self._early, sample.gid).add(sample, len(sample.data))
            return False
        number = sample.time if sample.sequence is None else sample.sequence
        if number <= offer.last:
            return False
        offer.last = number
        attachment = Attachment(number, sample.time, offer.token.gid).packed()
        send = partial(_put, offer.publisher, sample.data, attachment)
        self._outbox.put(send, len(sample.data))
        return True

    async def close(self) -> None:
        """Take everything from the network."""
        for key in list(self._offers):
            await self._withdraw(key)
        self._serving.close()
        await self._party.close()

    def _crosses(self, endpoint: Endpoint) -> bool:
        if is_peer(endpoint.owner) or endpoint.node.startswith(MARK):
            return False
        if PROTECTED.search(endpoint.node):
            return False
        if endpoint.kind == "node":
            return True
        if self._rules.refusal(USING[endpoint.kind], endpoint.name):
            return False
        return self._is_installed(endpoint)

    def _is_installed(self, endpoint: Endpoint) -> bool:
        try:
            load_type(endpoint.type)
        except NativeError as error:
            if endpoint.name not in self._unknown:
                self._unknown.add(endpoint.name)
                self._write(f"zenoh: {endpoint.name} stays here: {error}")
            return False
        return True

    async def _offer(self, endpoint: Endpoint) -> None:
        node_id = self._node_ids.setdefault(endpoint.node, next(self._ids))
        token = Token(
            self._native.domain,
            str(self._session.zid()),
            node_id,
            node_id if endpoint.kind == "node" else next(self._ids),
            endpoint.kind,
            endpoint.node,
            endpoint.name if endpoint.kind != "node" else "",
            endpoint.type,
            hash_of(endpoint.type),
            endpoint.qos,
        )
        publisher = self._publisher(token) if endpoint.kind == "publisher" else None
        if endpoint.kind == "service":
            await self._serving.add(token)
        declared = self._session.liveliness().declare_token(token.key)
        offer = self._offers[endpoint.key] = _Offer(token, declared, publisher)
        if publisher is None or endpoint.gid is None:
            return
        self._by_gid[endpoint.gid] = offer
        if early := self._early.pop(endpoint.gid, None):
            early.release(self.send)
        if endpoint.qos.transient_local:
            offer.collector = await self._collect(endpoint)

    async def _collect(self, endpoint: Endpoint) -> Subscription | None:
        def collected(sample: Sample) -> None:
            self.send(sample)

        try:
            qos = replace(endpoint.qos, depth=max(endpoint.qos.depth, DEPTHS["subscription"]))
            return await self._party.subscribe(endpoint.name, endpoint.type, qos, collected)
        except NativeError as error:
            self._write(f"zenoh: {endpoint.name}: {error}")
            return None

    async def _withdraw(self, key: str) -> None:
        offer = self._offers.pop(key)
        if offer.token.kind == "service":
            await self._serving.remove(offer.token)
        if offer.token.kind == "publisher":
            self._by_gid = {gid: one for gid, one in self._by_gid.items() if one is not offer}
        if offer.collector:
            await offer.collector.close()
        # After what it has sent.
        self._outbox.put(partial(_undeclare, offer), 0)

    def _publisher(self, token: Token) -> Any:
        qos = token.qos
        options: dict[str, Any] = {
            # Reliable messages wait for a slow network, in a thread of their own.
            "congestion_control": zenoh.CongestionControl.BLOCK
            if qos.reliable
            else zenoh.CongestionControl.DROP,
            "reliability": zenoh.Reliability.RELIABLE
            if qos.reliable
            else zenoh.Reliability.BEST_EFFORT,
        }
        if not qos.transient_local:
            return self._session.declare_publisher(token.data_key, **options)
        cache = ext.CacheConfig(qos.depth)
        return ext.declare_advanced_publisher(
            self._session, token.data_key, cache=cache, publisher_detection=True, **options
        )


def _put(publisher: Any, data: bytes, attachment: bytes) -> None:
    # The session may have been closed.
    with suppress(zenoh.ZError):
        publisher.put(data, attachment=attachment)


def _undeclare(offer: _Offer) -> None:
    with suppress(zenoh.ZError):
        offer.declared.undeclare()  # type: ignore[no-untyped-call]
        if offer.publisher:
            offer.publisher.undeclare()
