"""The endpoints of a page, and the native ones that stand for them."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass

from sitegen.gateway.access import Access
from sitegen.gateway.names import HAVING, PARAMETERS
from sitegen.gateway.native import (
    Client,
    NativeError,
    Party,
    Publisher,
    Qos,
    Request,
    Sample,
    Server,
    Subscription,
    hash_of,
)
from sitegen.gateway.pages.wire import Announced, InvalidMessageError, Record

# The nodes of a page, and requests that wait for its answer.
_MOST_NODES = 200
_MOST_REQUESTS = 1000


@dataclass
class Own:
    """An endpoint of the page, with its native one."""

    announced: Announced
    native: Publisher | Subscription | Client | Server | None
    # Whether it has not sent anything yet.
    fresh: bool = True
    # Whether the page has been told that it is not its turn.
    postponed: bool = False


class Owns:
    """All endpoints of a page."""

    def __init__(
        self,
        party: Party,
        access: Access,
        received: Callable[[str, Sample], None],
        send: Callable[[int, int, int, bytes], None],
        refuse: Callable[[int, str], None],
    ) -> None:
        """Call `received` with samples of a topic, and `send` to send a record to the page.

        `refuse` tells the page why what one of its endpoints sends goes no further.
        """
        self._access = access
        self._party = party
        self._received = received
        self._send = send
        self._refuse = refuse
        self._all: dict[int, Own] = {}
        # Requests to services of the page, which answers them by their number.
        self._asked: dict[int, tuple[int, Request]] = {}
        self._numbers = 0
        self._calls: set[asyncio.Future[bytes]] = set()

    def publishers(self) -> list[Announced]:
        """Return the publishers of the page that are in the native graph."""
        return [
            own.announced
            for own in self._all.values()
            if own.announced.kind == "publisher" and own.native
        ]

    def subscriptions(self, topic: str, type_name: str) -> list[Qos]:
        """Return what the page's own native subscriptions of a topic request."""
        return [
            own.announced.qos
            for own in self._all.values()
            if isinstance(own.native, Subscription)
            and (own.announced.name, own.announced.type) == (topic, type_name)
        ]

    async def add(self, announced: Announced) -> None:
        """Make a native endpoint for one of the page.

        Raises:
            NativeError: ROS does not take it, or its type is not the one of the gateway
            InvalidMessageError: the page may not announce it
        """
        if announced.id in self._all:
            raise InvalidMessageError("an endpoint twice")
        limits = self._access.rules.limits
        most = {"publisher": limits.publishers, "subscription": limits.subscriptions}
        most |= {"service": limits.services, "client": limits.services, "node": _MOST_NODES}
        count = sum(
            own.announced.kind == announced.kind
            # Each node has half a dozen services for its parameters.
            and not PARAMETERS.fullmatch(own.announced.name)
            for own in self._all.values()
        )
        if count >= most[announced.kind]:
            raise NativeError(f"{count} of a kind are the limit for {announced.kind}s of a page")
        self._all[announced.id] = own = Own(announced, None)
        if announced.kind == "node":
            await self._party.add_node(announced.name)
        else:
            _compare(announced)
            own.native = await self._make(announced)

    async def remove(self, id: int) -> None:
        """Remove the native endpoint of one that is gone."""
        own = self._all.pop(id, None)
        if own is None:
            return
        if own.native:
            await own.native.close()
        elif own.announced.kind == "node":
            await self._party.remove_node(own.announced.name)

    async def settle(self, record: Record) -> None:
        """Let a publisher that the page has just announced find its subscriptions first."""
        own = self._all.get(record.writer)
        if own and isinstance(own.native, Publisher) and own.fresh:
            own.fresh = False
            # What is latched waits for them by itself.
            if not own.announced.qos.transient_local:
                await own.native.settle()

    def take(self, record: Record) -> asyncio.Future[None] | None:
        """Handle a record of the page: a message, a request or a response."""
        own = self._all.get(record.writer)
        if own is None or own.native is None:
            # Refused, or gone while the record was on its way.
            return None
        announced = own.announced
        use = HAVING[announced.kind]
        if why := self._access.postponed(use, announced.name):
            # What it sends comes in numbers, and the page hears it once.
            if not own.postponed:
                self._refuse(record.writer, why.partition(";")[0])
            own.postponed = True
            return None
        own.postponed = False
        if isinstance(own.native, Publisher):
            self._access.published(announced.name, announced.type, record.data)
            return own.native.publish(record.data)
        if isinstance(own.native, Client):
            self._call(own.native, record)
        elif isinstance(own.native, Server):
            service, request = self._asked.pop(record.sequence, (0, None))
            if request and service == record.writer:
                return request.respond(record.data)
        return None

    def close(self) -> None:
        """Wait for no more answers."""
        for call in self._calls:
            call.cancel()
        self._asked.clear()

    async def _make(self, announced: Announced) -> Publisher | Subscription | Client | Server:
        name, kind, node = announced.name, announced.type, announced.node or None
        if announced.kind == "publisher":
            return await self._party.advertise(name, kind, announced.qos, node=node)
        if announced.kind == "subscription":

            def received(sample: Sample) -> None:
                self._received(name, sample)

            return await self._party.subscribe(name, kind, announced.qos, received, node=node)
        if announced.kind == "client":
            return await self._party.client(name, kind, node=node)
        id = announced.id
        return await self._party.serve(name, kind, lambda asked: self._ask(id, asked), node=node)

    def _call(self, client: Client, record: Record) -> None:
        if len(self._calls) >= self._access.rules.limits.calls:
            self._access.refused("more calls at once than the limit; they were dropped")
            return
        call = client.call(record.data)
        self._calls.add(call)

        def answered(done: asyncio.Future[bytes]) -> None:
            self._calls.discard(done)
            if done.cancelled():
                return
            if error := done.exception():
                self._access.refused(str(error))
            else:
                self._send(record.writer, record.reader, record.sequence, done.result())

        call.add_done_callback(answered)

    def _ask(self, service: int, request: Request) -> None:
        self._numbers = self._numbers % (2**32 - 1) + 1
        self._asked[self._numbers] = (service, request)
        if len(self._asked) > _MOST_REQUESTS:
            # Its client has waited the longest.
            del self._asked[next(iter(self._asked))]
        self._send(service, 0, self._numbers, request.data)


def _compare(announced: Announced) -> None:
    here = hash_of(announced.type)
    if announced.hash and here and announced.hash != here:
        raise NativeError(
            f"'{announced.type}' differs between the page and the gateway: rebuild the page with "
            "the same version of its package"
        )
