"""An endpoint of rowe for asyncio: server, client, or both, with one or more peers."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import math
import uuid
from typing import Self

import aiohttp
from aiohttp import web

from sitegen.rowe.expiring import ExpiringQueue, QueueFull
from sitegen.rowe.message import LONGEST, Body, InvalidMessage, Message, encode
from sitegen.rowe.peer import Outgoing, Peer, Socket, outgoing_queue

# Seconds between attempts to connect, the last repeated.
PAUSES = (0.1, 0.2, 0.5, 1, 2, 5)
# Seconds between pings, by which both sides notice that a connection is gone.
HEARTBEAT = 15


class AsyncEndpoint:
    """Sends JSON objects to peers and receives theirs.

    A peer that the endpoint connects to has the name given to `connect`, and keeps its queue while
    it is not reachable. A peer that connects to the endpoint has the name in the query of the URL
    that it uses (`ws://…/?name=arm`), or its address; its queue ends with the connection.
    """

    def __init__(self) -> None:
        """Make an endpoint without peers."""
        self._peers: dict[str, Peer] = {}
        # Messages to "the" peer, before there is one.
        self._unaddressed = outgoing_queue()
        self._incoming: ExpiringQueue[Message] = ExpiringQueue()
        self._arrived = asyncio.Condition()
        self._replies: dict[str, asyncio.Future[Message]] = {}
        self._runner: web.AppRunner | None = None
        self._tasks: list[asyncio.Task[None]] = []
        self._numbers = itertools.count(1)

    @property
    def peers(self) -> list[str]:
        """The names of the peers that are connected now."""
        return [name for name, peer in self._peers.items() if peer.connected]

    async def listen(self, port: int = 0, host: str = "127.0.0.1") -> int:
        """Accept connections at any path of an address, and return the port."""
        application = web.Application()
        application.router.add_get("/{path:.*}", self.accept)
        self._runner = web.AppRunner(application, access_log=None)
        await self._runner.setup()
        site = web.TCPSite(self._runner, host, port)
        await site.start()
        return int(self._runner.addresses[0][1])

    async def accept(self, request: web.Request) -> web.WebSocketResponse:
        """Serve a peer, as a handler of an aiohttp application."""
        socket = web.WebSocketResponse(heartbeat=HEARTBEAT, max_msg_size=LONGEST)
        await socket.prepare(request)
        asked = request.query.get("name", "")[:100]
        name = asked or f"{request.remote}:{next(self._numbers)}"
        if name in self._peers:
            name = f"{name}:{next(self._numbers)}"
        await self.serve(name, socket)
        return socket

    async def serve(self, name: str, socket: Socket) -> None:
        """Exchange messages with a new peer of this name until its connection ends."""
        peer = self._peers[name] = Peer(name)
        self._address(peer)
        try:
            await peer.run(socket, self._receive)
        finally:
            del self._peers[name]
            peer.close()

    def connect(self, url: str, name: str = "") -> str:
        """Connect to a server, and again after a lost connection. Return the name of the peer."""
        name = name or url
        if name in self._peers:
            raise ValueError(f"there is a peer named '{name}' already")
        peer = self._peers[name] = Peer(name)
        self._address(peer)
        self._tasks.append(asyncio.ensure_future(self._keep_connected(url, peer)))
        return name

    async def send(self, body: Body, *, to: str = "", time_to_live: float = math.inf) -> bool:
        """Send a message, and return True when it was sent or False when it was discarded.

        It is discarded when its time to live (seconds) is over, or its peer is gone.

        Raises:
            InvalidMessage: the body is not a JSON object, or is too long.
            QueueFull: 10,000 messages wait for the peer.
            ValueError: `to` is needed since there are several peers, or there is no such peer.
        """
        return await self._send(body, {}, to, time_to_live)

    def async_send(self, body: Body, *, to: str = "", time_to_live: float = math.inf) -> None:
        """Queue a message to be sent. Raises the same errors as `send`."""
        self._put(Outgoing(body, {}), to, time_to_live)

    async def receive(self, timeout: float | None = None) -> Message | None:
        """Wait for a message and return the oldest. Return None after `timeout` seconds."""
        loop = asyncio.get_running_loop()
        end = math.inf if timeout is None else loop.time() + timeout
        async with self._arrived:
            while not (taken := self._incoming.take()):
                left = end - loop.time()
                if left <= 0:
                    return None
                try:
                    await asyncio.wait_for(self._arrived.wait(), None if left == math.inf else left)
                except TimeoutError:
                    return None
            self._arrived.notify_all()
        return taken[1]

    async def invoke(self, body: Body, *, to: str = "", time_to_live: float = 5) -> Message:
        """Send a request and return the reply.

        Raises:
            TimeoutError: there is no reply within `time_to_live` seconds.
            The errors of `send`.
        """
        name = uuid.uuid4().hex
        reply = self._replies[name] = asyncio.get_running_loop().create_future()
        try:
            self._put(Outgoing(body, {"message_id": name}), to, time_to_live)
            return await asyncio.wait_for(reply, time_to_live)
        except TimeoutError:
            raise TimeoutError(f"no reply within {time_to_live} s") from None
        finally:
            del self._replies[name]

    async def reply(self, request: Message, body: Body, *, time_to_live: float = math.inf) -> bool:
        """Reply to a request. Return whether the reply was sent, as `send` does.

        Raises:
            InvalidMessage: the request has no `message_id`, or the errors of `send`.
        """
        return await self._send(body, _reply_to(request), request.peer, time_to_live)

    def async_reply(self, request: Message, body: Body, *, time_to_live: float = math.inf) -> None:
        """Queue a reply to a request. Raises the same errors as `reply`."""
        self._put(Outgoing(body, _reply_to(request)), request.peer, time_to_live)

    async def close(self) -> None:
        """Close all connections. What waits to be sent is discarded."""
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        if self._runner:
            await self._runner.cleanup()
        for peer in self._peers.values():
            peer.close()
        self._unaddressed.clear()

    async def __aenter__(self) -> Self:
        """Return the endpoint, which is closed at the end of the block."""
        return self

    async def __aexit__(self, *_: object) -> None:
        """Close the endpoint."""
        await self.close()

    async def _send(self, body: Body, fields: dict[str, str], to: str, time_to_live: float) -> bool:
        message = Outgoing(body, fields)
        self._put(message, to, time_to_live)
        try:
            seconds = None if time_to_live == math.inf else time_to_live
            return await asyncio.wait_for(asyncio.shield(message.sent), seconds)
        except TimeoutError:
            # A message that left its queue in time is being sent.
            if not message.sending:
                message.settle(False)
            return await message.sent

    def _put(self, message: Outgoing, to: str, time_to_live: float) -> None:
        encode(message.body, **message.fields)
        if not time_to_live >= 0:
            raise ValueError("time_to_live: must be a number of seconds, 0 or more")
        if not to and len(self._peers) > 1:
            raise ValueError(f"name the peer: one of {', '.join(self._peers)}")
        if to and to not in self._peers:
            raise ValueError(f"there is no peer named '{to}'")
        if self._peers:
            self._peers[to or next(iter(self._peers))].put(message, time_to_live)
        else:
            self._unaddressed.put(message, time_to_live)

    def _address(self, peer: Peer) -> None:
        """Give the first peer what waits for one."""
        while taken := self._unaddressed.take():
            peer.put(taken[1], taken[0])

    async def _keep_connected(self, url: str, peer: Peer) -> None:
        pauses = itertools.chain(PAUSES, itertools.repeat(PAUSES[-1]))
        async with aiohttp.ClientSession() as session:
            while True:
                try:
                    async with session.ws_connect(
                        url, heartbeat=HEARTBEAT, max_msg_size=LONGEST
                    ) as socket:
                        pauses = itertools.chain(PAUSES, itertools.repeat(PAUSES[-1]))
                        await peer.run(socket, self._receive)
                except (aiohttp.ClientError, OSError, TimeoutError):
                    pass
                await asyncio.sleep(next(pauses))

    async def _receive(self, message: Message) -> None:
        if message.in_reply_to is not None:
            waiting = self._replies.get(message.in_reply_to)
            if waiting and not waiting.done():
                waiting.set_result(message)
            # Nobody waits any more for a reply that comes too late.
            return
        async with self._arrived:
            while True:
                try:
                    self._incoming.put(message, message.time_to_live)
                except QueueFull:
                    # Its socket is not read until messages were taken or have expired.
                    with contextlib.suppress(TimeoutError):
                        await asyncio.wait_for(self._arrived.wait(), 0.1)
                else:
                    break
            self._arrived.notify_all()


def _reply_to(request: Message) -> dict[str, str]:
    if request.message_id is None:
        raise InvalidMessage("the request has no message_id, so it expects no reply")
    return {"in_reply_to": request.message_id}
