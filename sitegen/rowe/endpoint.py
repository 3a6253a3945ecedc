"""An endpoint of rowe for asyncio: server, client, or both, with one or more peers."""

from __future__ import annotations

import asyncio
import itertools
import math
import threading
import uuid
from concurrent.futures import Future
from typing import Self

from aiohttp import web

from sitegen.rowe.expiring import QueueFull
from sitegen.rowe.inbox import Inbox
from sitegen.rowe.message import LONGEST, Body, InvalidMessage, Message
from sitegen.rowe.outgoing import Outgoing, outgoing_queue
from sitegen.rowe.peer import Peer, Socket
from sitegen.rowe.reconnecting import HEARTBEAT, checked, keep_connected


class AsyncEndpoint:
    """Sends JSON objects to peers and receives theirs.

    A peer that the endpoint connects to has the name given to `connect`, and keeps its queue while
    it is not reachable. A peer that connects to the endpoint has the name in the query of the URL
    that it uses (`ws://…/?name=arm`), or its address; its queue ends with the connection.
    """

    def __init__(self) -> None:
        """Make an endpoint without peers, in a running event loop."""
        self._loop = asyncio.get_running_loop()
        self._peers: dict[str, Peer] = {}
        # Messages to "the" peer, before there is one.
        self._unaddressed = outgoing_queue()
        self.inbox = Inbox(self._loop)
        # By the id of a request: the peer's name and its reply.
        self._replies: dict[str, tuple[str, Future[Message]]] = {}
        self._runners: list[web.AppRunner] = []
        self._tasks: list[asyncio.Task[None]] = []
        self._numbers = itertools.count(1)
        # Other threads put messages while peers come and go.
        self._lock = threading.Lock()
        self._closed = False

    def peers(self) -> list[str]:
        """Return the names of the peers that are connected now."""
        return [peer.name for peer in list(self._peers.values()) if peer.connected]

    async def listen(self, port: int = 0, host: str = "127.0.0.1") -> int:
        """Accept connections at any path of an address, and return the port."""
        application = web.Application()
        application.router.add_get("/{path:.*}", self.accept)
        runner = web.AppRunner(application, access_log=None, shutdown_timeout=1)
        self._runners.append(runner)
        await runner.setup()
        await web.TCPSite(runner, host, port).start()
        return int(runner.addresses[0][1])

    async def accept(self, request: web.Request) -> web.WebSocketResponse:
        """Serve a peer, as a handler of an aiohttp application."""
        socket = web.WebSocketResponse(heartbeat=HEARTBEAT, max_msg_size=LONGEST, compress=False)
        await socket.prepare(request)
        asked = request.query.get("name", "")[:100]
        name = asked or f"{request.remote}:{next(self._numbers)}"
        if name in self._peers:
            name = f"{name}:{next(self._numbers)}"
        await self.serve(name, socket)
        return socket

    async def serve(self, name: str, socket: Socket) -> None:
        """Exchange messages with a new peer of this name until its connection ends."""
        peer = self._add(name)
        try:
            await peer.run(socket, lambda message, size: self._receive(peer, message, size))
        finally:
            with self._lock:
                del self._peers[name]
            peer.close()
            self._fail(name, f"'{name}' left before it replied")

    def connect(self, url: str, name: str = "") -> str:
        """Connect to a server, and again after a lost connection. Return the name of the peer.

        Raises:
            ValueError: the URL is not one of a WebSocket, or there is a peer of this name.
        """
        checked(url)
        peer = self._add(name or url)

        async def run(socket: Socket) -> None:
            await peer.run(socket, lambda message, size: self._receive(peer, message, size))

        self._tasks.append(asyncio.ensure_future(keep_connected(url, peer.name, run)))
        return peer.name

    async def send(self, body: Body, ttl: float = math.inf, *, to: str = "") -> bool:
        """Send a message, and return True when it was sent or False when it was discarded.

        It is discarded when its time to live (seconds) is over, or its peer is gone.

        Raises:
            InvalidMessage: the body is not a JSON object, is too long or too deep.
            QueueFull: 10,000 messages, or 64 MB of them, wait for the peer.
            ValueError: `to` is needed since there are several peers, or there is no such peer.
        """
        return await self._settled(self.put(body, {}, ttl, to, True), ttl)

    def async_send(self, body: Body, ttl: float = math.inf, *, to: str = "") -> None:
        """Queue a message to be sent. Raises the same errors as `send`."""
        self.put(body, {}, ttl, to)

    def broadcast(self, body: Body, ttl: float = math.inf) -> list[str]:
        """Queue a message for each connected peer, and return their names.

        A peer whose queue is full does not get it, and is not among them.
        """
        names = []
        for peer in [peer for peer in list(self._peers.values()) if peer.connected]:
            try:
                self.put(body, {}, ttl, peer.name)
            except QueueFull:
                peer.note("does not read, so it misses broadcasts")
            except LookupError:
                # It has just left.
                continue
            else:
                names.append(peer.name)
        return names

    async def receive(self, timeout: float | None = None) -> Message | None:
        """Wait for a message and return the oldest. Return None after `timeout` seconds."""
        return await self.inbox.receive(timeout)

    async def invoke(self, body: Body, timeout: float = 5, *, to: str = "") -> Message:
        """Send a request and return the reply.

        Raises:
            TimeoutError: there is no reply within `timeout` seconds.
            ConnectionError: the peer, which had connected to this endpoint, left.
            The errors of `send`.
        """
        key, reply = self.ask(body, timeout, to)
        try:
            return await asyncio.wait_for(asyncio.wrap_future(reply), timeout)
        except TimeoutError:
            raise TimeoutError(f"no reply within {timeout} s") from None
        finally:
            self.forget(key)

    async def reply(self, request: Message, body: Body, ttl: float = math.inf) -> bool:
        """Reply to a request. Return whether the reply was sent; False if the peer is gone.

        Raises:
            InvalidMessage: the request has no `message_id`, or the errors of `send`.
        """
        message = self.put_reply(request, body, ttl, True)
        return await self._settled(message, ttl) if message else False

    def async_reply(self, request: Message, body: Body, ttl: float = math.inf) -> None:
        """Queue a reply to a request. Raises the same errors as `reply`."""
        self.put_reply(request, body, ttl)

    async def close(self) -> None:
        """Close all connections. What waits to be sent is discarded."""
        with self._lock:
            self._closed = True
        # Before connections are closed, which clients open again.
        for runner in self._runners:
            for site in list(runner.sites):
                await site.stop()
        await asyncio.gather(*(peer.disconnect() for peer in self._peers.values()))
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        for runner in self._runners:
            await runner.cleanup()
        for peer in list(self._peers.values()):
            peer.close()
        self._unaddressed.clear()
        self._fail(None, "the endpoint was closed")
        await self.inbox.close()

    async def __aenter__(self) -> Self:
        """Return the endpoint, which is closed at the end of the block."""
        return self

    async def __aexit__(self, *_: object) -> None:
        """Close the endpoint."""
        await self.close()

    # What follows, and `async_send` and `broadcast`, can be called from any thread.

    def put(
        self, body: Body, fields: dict[str, str], ttl: float, to: str, waits: bool = False
    ) -> Outgoing:
        """Queue a message. If the caller `waits`, it is told whether it was sent."""
        if not ttl >= 0:
            raise ValueError("ttl: must be a number of seconds, 0 or more")
        message = Outgoing(body, fields, waits)
        with self._lock:
            if self._closed:
                raise RuntimeError("the endpoint is closed")
            if not to and len(self._peers) > 1:
                raise ValueError(f"name the peer: one of {', '.join(self._peers)}")
            if to and to not in self._peers:
                raise UnknownPeer(f"there is no peer named '{to}'")
            if self._peers:
                self._peers[to or next(iter(self._peers))].put(message, ttl)
            else:
                self._unaddressed.put(message, ttl, len(message.text))
        return message

    def put_reply(
        self, request: Message, body: Body, ttl: float, waits: bool = False
    ) -> Outgoing | None:
        """Queue a reply. Return None if the peer is gone, which the program could not know."""
        if request.message_id is None:
            raise InvalidMessage("the request has no message_id, so it expects no reply")
        try:
            fields = {"in_reply_to": request.message_id}
            return self.put(body, fields, ttl, request.peer, waits)
        except UnknownPeer:
            return None

    def ask(self, body: Body, timeout: float, to: str) -> tuple[str, Future[Message]]:
        """Queue a request. Return its id and its reply to come."""
        key, reply = uuid.uuid4().hex, Future[Message]()
        self._replies[key] = (to or next(iter(list(self._peers)), ""), reply)
        try:
            self.put(body, {"message_id": key}, timeout, to)
        except BaseException:
            self.forget(key)
            raise
        return key, reply

    def forget(self, key: str) -> None:
        """Wait no longer for a reply."""
        self._replies.pop(key, None)

    def _add(self, name: str) -> Peer:
        """Add a peer; the first one gets what waits for one."""
        peer = Peer(name, self._loop)
        with self._lock:
            if name in self._peers:
                raise ValueError(f"there is a peer named '{name}' already")
            self._peers[name] = peer
            while taken := self._unaddressed.take():
                peer.put(taken[1], taken[0])
        return peer

    def _fail(self, name: str | None, reason: str) -> None:
        """End the calls that wait for a peer, or for all of them."""
        for peer, reply in list(self._replies.values()):
            if name in (None, peer) and not reply.done():
                reply.set_exception(ConnectionError(reason))

    async def _settled(self, message: Outgoing, ttl: float) -> bool:
        assert message.sent
        sent = asyncio.wrap_future(message.sent)
        if ttl < math.inf:
            await asyncio.wait([sent], timeout=ttl)
            message.expire()
        return await sent

    async def _receive(self, peer: Peer, message: Message, size: int) -> None:
        if message.in_reply_to is None:
            await self.inbox.put(message, size)
            return
        _, reply = self._replies.get(message.in_reply_to, ("", None))
        if reply and not reply.done():
            reply.set_result(message)
        else:
            peer.note("sent a reply that nobody waits for, or that came too late")


class UnknownPeer(ValueError, LookupError):
    """There is no peer of this name."""
