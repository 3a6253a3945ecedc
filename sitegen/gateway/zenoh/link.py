"""Join the native graph with those of other gateways, over Zenoh."""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import Awaitable, Callable

import zenoh
from zenoh import handlers

from sitegen.errors import SiteError
from sitegen.gateway.access import Access, Guard
from sitegen.gateway.native import Native, Publisher, Request, Sample
from sitegen.gateway.rules import Rules
from sitegen.gateway.zenoh.asking import Asking
from sitegen.gateway.zenoh.attachment import Attachment, unpack
from sitegen.gateway.zenoh.inbound import Arrived, Inbound
from sitegen.gateway.zenoh.inbox import Inbox
from sitegen.gateway.zenoh.keys import Token, gid_of, parse, tokens_of
from sitegen.gateway.zenoh.outbound import MARK, Outbound
from sitegen.gateway.zenoh.outbox import Outbox
from sitegen.gateway.zenoh.peer import Peer

# What has come and is not yet in the native graph (bytes).
_INBOX = 32_000_000
# All that the two tell others would come back to them, for ever.
_TWICE = "another gateway has joined this graph already"
# Addresses that have not answered after so long are told (s).
_PATIENCE = 5.0
# A slow network is told so often (s).
_AGAIN = 60.0


def check(rules: Rules, native: Native) -> None:
    """Raise a SiteError if the graph cannot be joined with others."""
    if rules.keys:
        message = "gateway.yaml asks clients for keys, which other gateways do not have"
        raise SiteError([f"--zenoh: {message}; remove 'keys', or start without --zenoh"])
    if native.rmw == "rmw_zenoh_cpp":
        message = "ROS 2 uses Zenoh here itself"
        how = "set its router's connect/endpoints instead, and start without --zenoh"
        raise SiteError([f"--zenoh: {message}; {how}"])
    if _marks(native):
        raise SiteError([f"--zenoh: {_TWICE}; stop one of them, or start without --zenoh"])


class Link:
    """The connection of this gateway with all peers."""

    def __init__(
        self,
        native: Native,
        session: zenoh.Session,
        rules: Rules,
        guard: Guard,
        write: Callable[[str], None],
    ) -> None:
        self._native = native
        self._session = session
        self._rules = rules
        self._guard = guard
        self._write = write
        self._own = str(session.zid())
        self._loop = asyncio.get_running_loop()
        # The one that came first stays.
        self._mark = f"{MARK}{time.time_ns():020}_{self._own}"
        self._marking = native.join(None)
        self._inbox: Inbox[Arrived | tuple[bool, Token]] = Inbox(_INBOX)
        self._outbox = Outbox(rules.limits.queue_size, self._congested)
        self._outbound = Outbound(native, session, rules, self._outbox, write)
        self._inbound = Inbound(session, self._received)
        self._asking = Asking(session)
        self._peers: dict[str, Peer] = {}
        self._tokens: asyncio.Queue[tuple[bool, Token]] = asyncio.Queue()
        self._changed = asyncio.Event()
        self._tasks: list[asyncio.Task[None]] = []
        self._stops: list[Callable[[], object]] = []
        self._congested_at = -_AGAIN
        self._closed = False
        self._closing: asyncio.Task[None] | None = None

    async def start(self, addresses: int) -> None:
        """Tell peers of the graph, and the graph of peers.

        If not so many addresses as `addresses` are reached soon, that is said.
        """
        await self._marking.add_node(self._mark)
        self._stops.append(self._native.watch(lambda come, gone: self._changed.set()))
        steps = (self._deliver, self._meet, self._follow)
        self._tasks = [asyncio.create_task(self._repeat(step)) for step in steps]
        self._tasks.append(asyncio.create_task(self._count(addresses)))
        links = self._session.info.declare_transport_events_listener(
            handlers.Callback(self._linked, indirect=False), history=True
        )
        tokens = self._session.liveliness().declare_subscriber(
            tokens_of(self._native.domain),
            handlers.Callback(self._told, indirect=False),
            history=True,
        )
        self._stops += [tokens.undeclare, links.undeclare]
        self._changed.set()

    async def close(self) -> None:
        """Leave the network, and remove all of its endpoints from the native graph."""
        if self._closed:
            return
        self._closed = True
        for stop in self._stops:
            stop()
        self._inbox.close()
        for task in self._tasks:
            task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await task
        self._inbound.close()
        for session in list(self._peers):
            await self._peers.pop(session).close("the gateway is stopping")
        await self._outbound.close()
        await self._marking.close()
        await self._loop.run_in_executor(None, self._outbox.close)
        await self._loop.run_in_executor(None, self._session.close)

    # What peers ask for: `Ways` in peer.py.

    def send(self, sample: Sample) -> bool:
        """Send a message to those who look at its publisher."""
        return self._outbound.send(sample)

    def call(self, token: Token, request: Request, access: Access) -> None:
        """Ask a service of a peer."""
        self._asking.call(token, request, access)

    def open(self, token: Token, publisher: Publisher, access: Access) -> None:
        """Publish natively what comes from a publisher of a peer."""
        self._inbound.open(token, publisher, access)

    async def shut(self, token: Token) -> None:
        """Publish what has come from a publisher that has gone, and no more."""
        await self._inbound.shut(token)

    # In threads of Zenoh.

    def _received(self, sample: zenoh.Sample) -> None:
        data, key = sample.payload.to_bytes(), str(sample.key_expr)
        attachment = unpack(sample.attachment.to_bytes()) if sample.attachment else None
        if attachment is None:
            # Of a program without ROS, which does not number its messages.
            now = time.time_ns()
            attachment = Attachment(now, now, gid_of(key))
        self._inbox.put(Arrived(key, data, attachment), len(data))

    def _told(self, sample: zenoh.Sample) -> None:
        key = str(sample.key_expr)
        token = parse(key)
        if token and token.session != self._own:
            self._inbox.put((sample.kind == zenoh.SampleKind.PUT, token), len(key))

    def _linked(self, event: zenoh.TransportEvent) -> None:
        there = event.kind == zenoh.SampleKind.PUT
        state = "connected to" if there else "lost the connection to"
        line = f"zenoh: {state} {event.transport.whatami} {event.transport.zid}"
        with contextlib.suppress(RuntimeError):
            self._loop.call_soon_threadsafe(self._write, line)

    # In the event loop.

    async def _repeat(self, step: Callable[[], Awaitable[None]]) -> None:
        """Do a step again and again, whatever a peer sends."""
        while not self._closed:
            try:
                await step()
            except Exception as error:
                self._write(f"zenoh: failed: {type(error).__name__}: {error}")

    async def _deliver(self) -> None:
        """Publish what has arrived, in the order in which it did."""
        futures = []
        for item in await self._inbox.take():
            if isinstance(item, Arrived):
                if future := self._inbound.take(item):
                    futures.append(future)
            else:
                self._tokens.put_nowait(item)
        # No more is taken before the middleware has this.
        if futures:
            await asyncio.wait(futures)

    async def _meet(self) -> None:
        """Make what a peer tells of, or remove what has gone."""
        come, token = await self._tokens.get()
        peer = self._peers.get(token.session)
        if come and (peer := peer or await self._greet(token.session)):
            await peer.add(token)
        elif peer:
            await peer.remove(token)
            if peer.is_empty:
                del self._peers[token.session]
                await peer.close("left")
        if self._tokens.empty():
            for one in self._peers.values():
                one.summarize()

    async def _greet(self, session: str) -> Peer | None:
        most = self._rules.limits.connections
        access = Access(self._rules, f"zenoh {session[:8]}", self._write, self._guard)
        if len(self._peers) >= most:
            access.say(f"refused: all {most} connections are in use")
            return None
        await access.enter()
        peer = self._peers[session] = Peer(session, self._native, access, self)
        return peer

    async def _follow(self) -> None:
        """Tell peers what has changed in the native graph, and look at what is looked at here."""
        await self._changed.wait()
        self._changed.clear()
        if any(mark < self._mark for mark in _marks(self._native)):
            self._write(f"zenoh: {_TWICE}; this one leaves the other gateways")
            self._closing = asyncio.create_task(self.close())
            return
        present = self._outbound.present()
        looked = [one for one in present if one.kind == "subscription"]
        # Before others are told that it is looked at, and send it.
        self._inbound.look({self._outbound.key(one) for one in looked})
        await self._outbound.update(present)

    async def _count(self, addresses: int) -> None:
        """Say it if some of the addresses do not answer; Zenoh itself keeps trying."""
        await asyncio.sleep(_PATIENCE)
        reached = len(self._session.info.transports())
        if reached < addresses:
            count = f"{reached} of {addresses} addresses" if addresses > 1 else "the address"
            state = "connected to only" if reached else "no connection to"
            self._write(f"zenoh: {state} {count} so far; it is tried again and again")

    def _congested(self) -> None:
        # Messages come in numbers, and the log tells of them once in a while.
        if (now := time.monotonic()) - self._congested_at >= _AGAIN:
            self._congested_at = now
            self._write("zenoh: the network is slower than the messages; some were dropped")


def _marks(native: Native) -> list[str]:
    return [one.name for one in native.endpoints if one.name.startswith(MARK)]
