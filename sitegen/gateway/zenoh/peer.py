"""Another gateway, or another program of rmw_zenoh: its part in the native graph."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from sitegen.gateway.access import Access
from sitegen.gateway.names import HAVING, PROTECTED
from sitegen.gateway.native import (
    Client,
    Native,
    NativeError,
    Publisher,
    Request,
    Sample,
    Server,
    Subscription,
    hash_of,
    load_type,
)
from sitegen.gateway.zenoh.keys import Token

# The parties of peers in the native graph are called so, and then by their session.
_OWNER = "zenoh "
# The least histories of reliable endpoints: the graph of ROS 2 tells no depths, so other gateways
# do not know them. A publisher may keep so much for a slow subscription, of large images, too.
DEPTHS = {"subscription": 1000, "publisher": 100}
# Nodes and endpoints of one peer. Unlike a page, it stands for a whole robot.
_MOST = 10_000

Part = Publisher | Subscription | Client | Server


def is_peer(owner: str | None) -> bool:
    """Return whether an endpoint of the native graph stands for one of a peer."""
    return owner is not None and owner.startswith(_OWNER)


class Ways(Protocol):
    """Where what peers ask for goes."""

    def send(self, sample: Sample) -> bool:
        """Send a message to those who look at its publisher; return whether it was sent."""

    def call(self, token: Token, request: Request, access: Access) -> None:
        """Ask a service of a peer."""

    def open(self, token: Token, publisher: Publisher, access: Access) -> None:
        """Publish natively what comes from a publisher of a peer."""

    async def shut(self, token: Token) -> None:
        """Publish what has come from a publisher that has gone, and no more."""


class Peer:
    """All that one session of Zenoh has in its graph."""

    def __init__(self, session: str, native: Native, access: Access, ways: Ways) -> None:
        self._native = native
        self._access = access
        self._ways = ways
        self._party = native.join(f"{_OWNER}{session}")
        # By the key of the token; None stands for nodes, and for what does not cross.
        self._parts: dict[str, Part | None] = {}
        self._refused: list[str] = []

    @property
    def is_empty(self) -> bool:
        """Whether everything of it has gone."""
        return not self._parts

    async def add(self, token: Token) -> None:
        """Make a node or an endpoint in the native graph, if the rules allow it."""
        if token.key in self._parts:
            return
        if len(self._parts) >= _MOST:
            self._access.refused(f"more than {_MOST} nodes and endpoints; it gets no more")
            return
        self._parts[token.key] = None
        if PROTECTED.search(token.node):
            return
        try:
            if token.kind == "node":
                await self._add_node(token)
            elif self._access.rules.refusal(HAVING[token.kind], token.name):
                self._refused.append(token.name)
            else:
                _compare(token)
                part = self._parts[token.key] = await self._make(token)
                if isinstance(part, Publisher):
                    self._ways.open(token, part, self._access)
        except NativeError as error:
            self._access.refused(f"{token.name or token.node}: {error}")

    async def remove(self, token: Token) -> None:
        """Remove a node or an endpoint that has gone."""
        if token.key not in self._parts:
            return
        part = self._parts.pop(token.key)
        if token.kind == "publisher":
            await self._ways.shut(token)
        if part:
            await part.close()
        elif token.kind == "node" and self._node(token):
            await self._party.remove_node(token.node)

    def summarize(self) -> None:
        """Tell what has been refused since the last call, in one line."""
        names = sorted(set(self._refused))
        self._refused.clear()
        if names:
            more = f" and {len(names) - 1} more" if len(names) > 1 else ""
            self._access.say(f"gateway.yaml does not allow {names[0]}{more}")

    async def close(self, why: str) -> None:
        """Remove everything of this peer, and stop what it drove."""
        await self._party.close()
        await self._access.close(why)
        self._access.say(why)

    def _node(self, token: Token) -> str | None:
        # Gateways have nodes of the same name, and each stands for the other.
        return None if token.node == f"/{self._native.name}" else token.node

    async def _add_node(self, token: Token) -> None:
        if node := self._node(token):
            await self._party.add_node(node)

    async def _make(self, token: Token) -> Part:
        name, kind, node, qos = token.name, token.type, self._node(token), token.qos
        # Of what a publisher keeps for late subscriptions, they are to get no more than it kept.
        if qos.reliable and not (qos.transient_local and token.kind == "publisher"):
            qos = replace(qos, depth=max(qos.depth, DEPTHS.get(token.kind, 0)))
        if token.kind == "publisher":
            return await self._party.advertise(name, kind, qos, node=node)
        if token.kind == "client":
            return await self._party.client(name, kind, node=node)
        if token.kind == "service":

            def asked(request: Request) -> None:
                self._ways.call(token, request, self._access)

            return await self._party.serve(name, kind, asked, node=node)

        def received(sample: Sample) -> None:
            if self._ways.send(sample):
                self._access.delivered(name, kind, sample.data, sample.time)

        return await self._party.subscribe(name, kind, qos, received, node=node)


def _compare(token: Token) -> None:
    load_type(token.type)
    here = hash_of(token.type)
    if token.hash != here:
        there = token.hash or "unknown"
        raise NativeError(
            f"'{token.type}' differs between the two gateways: {there} there, {here or 'unknown'} "
            "here; install the same version of its package"
        )
