"""The endpoints of others as a page knows them, and which of them it looks at."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sitegen.gateway.access import Access
from sitegen.gateway.names import PROTECTED, USING
from sitegen.gateway.native import Endpoint, Native, NativeError, Party, Qos, Sample, Subscription
from sitegen.gateway.pages.feeds import Feed, Feeds
from sitegen.gateway.pages.own import Owns
from sitegen.gateway.pages.wire import described

# The histories of the gateway's own subscriptions.
_RELIABLE, _NEWEST = 1000, 10


@dataclass
class _Told:
    id: int
    endpoint: Endpoint


class Remotes:
    """What one page is told of, and what it gets."""

    def __init__(
        self, native: Native, party: Party, access: Access, owns: Owns, feeds: Feeds
    ) -> None:
        self._native = native
        self._party = party
        self._access = access
        self._owns = owns
        self._feeds = feeds
        self._told: dict[str, _Told] = {}
        self._by_id: dict[int, _Told] = {}
        self._by_gid: dict[bytes, _Told] = {}
        self._ids = 0
        # The gateway's subscriptions for this page, with the feeds that need them.
        self._sources: dict[tuple[str, str, Qos], tuple[Subscription, set[int]]] = {}
        # Publishers of the page that somebody else looks at, whom it cannot see.
        self._opened: set[int] = set()

    async def news(self) -> list[dict[str, Any]]:
        """Return the messages about all that has changed since the last call."""
        messages: list[dict[str, Any]] = []
        present = {e.key: e for e in self._native.endpoints if self._is_visible(e)}
        # A node of whose endpoints none is visible is not visible either.
        seen = {e.node for e in present.values() if e.kind != "node"}
        hidden = {e.node for e in self._native.endpoints if e.kind != "node"} - seen
        present = {key: e for key, e in present.items() if e.node not in hidden}
        gone = [told for key, told in self._told.items() if key not in present]
        for told in gone:
            self._forget(told)
        come = [self._tell(e) for key, e in present.items() if key not in self._told]
        if come or gone:
            described_ones = [described(told.id, told.endpoint) for told in come]
            gone_ones = [told.id for told in gone]
            messages.append({"op": "graph", "come": described_ones, "gone": gone_ones})
        opened = {
            own.id
            for own in self._owns.publishers()
            if self._native.lookers(own.name, own.type) - {self._party.owner}
        }
        messages += [{"op": "open", "id": id} for id in opened - self._opened]
        messages += [{"op": "close", "id": id} for id in self._opened - opened]
        self._opened = opened
        for told in gone:
            await self._release(told.id)
        return messages

    async def open(self, id: int, period: int) -> None:
        """Send the page the messages of a publisher, at most one in `period` (ns)."""
        told = self._by_id.get(id)
        if told is None or told.endpoint.kind != "publisher":
            # It may have gone just now.
            return
        self._feeds.open(id, told.endpoint, period)
        await self._subscribe(id, told.endpoint)

    async def settle(self) -> None:
        """Subscribe to what the page still looks at, after subscriptions of its nodes have gone."""
        for id, told in list(self._by_id.items()):
            feed = self._feeds.get(id)
            if feed and feed.open:
                await self._subscribe(id, told.endpoint)

    async def _subscribe(self, id: int, endpoint: Endpoint) -> None:
        """Get the messages of a publisher, unless a native subscription of the page brings them."""
        offered = endpoint.qos
        # What a publisher keeps may have come to a subscription before the page has looked.
        if not offered.transient_local:
            for own in self._owns.subscriptions(endpoint.name, endpoint.type):
                if own.accepts(offered) and own.reliable >= offered.reliable:
                    return
        depth = _RELIABLE if offered.reliable else _NEWEST
        qos = Qos(depth, offered.reliable, offered.transient_local)
        key = (endpoint.name, endpoint.type, qos)
        if key in self._sources:
            self._sources[key][1].add(id)
            return
        try:
            source = await self._party.subscribe(
                endpoint.name,
                endpoint.type,
                qos,
                lambda sample: self._receive(endpoint.name, sample),
            )
        except NativeError as error:
            self._access.refused(str(error))
            return
        self._sources[key] = (source, {id})
        if id not in self._by_id:
            # It has gone meanwhile.
            await self._release(id)

    async def close(self, id: int) -> None:
        """Send no more messages of a publisher."""
        feed = self._feeds.get(id)
        if feed:
            feed.close()
        await self._release(id)

    def receive(self, topic: str, sample: Sample) -> None:
        """Pass a message on that a native subscription of the page has got."""
        feed = self._feed(sample)
        if feed and not feed.endpoint.qos.transient_local:
            self._receive(topic, sample)

    def _receive(self, topic: str, sample: Sample) -> None:
        feed = self._feed(sample)
        if not feed or feed.endpoint.name != topic or self._access.postponed("subscribe", topic):
            return
        if self._feeds.push(feed, sample):
            self._access.delivered(topic, feed.endpoint.type, sample.data, sample.time)

    def _feed(self, sample: Sample) -> Feed | None:
        # Not the page's own messages: those are not told as another's.
        told = self._by_gid.get(sample.gid)
        return self._feeds.get(told.id) if told else None

    def _is_visible(self, endpoint: Endpoint) -> bool:
        if endpoint.owner == self._party.owner:
            return False
        if PROTECTED.search(endpoint.node):
            return False
        if endpoint.kind == "node":
            return True
        # Not by `access.refusal`: what nobody has asked for is no refusal to log.
        return not self._access.rules.refusal(USING[endpoint.kind], endpoint.name)

    def _tell(self, endpoint: Endpoint) -> _Told:
        self._ids += 1
        told = _Told(self._ids, endpoint)
        self._told[endpoint.key] = told
        self._by_id[told.id] = told
        if endpoint.gid:
            self._by_gid[endpoint.gid] = told
        return told

    def _forget(self, told: _Told) -> None:
        del self._told[told.endpoint.key]
        del self._by_id[told.id]
        if told.endpoint.gid:
            self._by_gid.pop(told.endpoint.gid, None)
        self._feeds.remove(told.id)

    async def _release(self, id: int) -> None:
        for key, (source, users) in list(self._sources.items()):
            users.discard(id)
            if not users:
                del self._sources[key]
                await source.close()
