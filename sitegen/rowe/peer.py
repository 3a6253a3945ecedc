"""One peer of an endpoint: its queue of messages to send, and its socket while it has one."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import socket
from collections.abc import Awaitable, Callable
from time import monotonic

import aiohttp
from aiohttp import web

from sitegen.rowe.message import LONGEST, InvalidMessage, Message, decode, timed
from sitegen.rowe.outgoing import Outgoing, outgoing_queue

Socket = web.WebSocketResponse | aiohttp.ClientWebSocketResponse

Received = Callable[[Message, int], Awaitable[None]]

log = logging.getLogger("rowe")

# Invalid messages of a connection that are tolerated; then it is closed.
INVALID = 100
# Seconds that a peer has to answer that the connection is closed.
FAREWELL = 1


class Peer:
    """A program at the other end of a connection."""

    def __init__(self, name: str, loop: asyncio.AbstractEventLoop) -> None:
        """Make a peer without a connection."""
        self.name = name
        self.queue = outgoing_queue()
        self._loop = loop
        self._filled = asyncio.Event()
        # Whether `_filled` will be set. So a burst of messages wakes the loop once.
        self._woken = False
        # A message that could not be sent, and when it expires. It is sent first over the next
        # connection.
        self._failed: tuple[float, Outgoing] | None = None
        self._socket: Socket | None = None
        # What was logged about this connection.
        self._logged: set[str] = set()

    @property
    def connected(self) -> bool:
        """Whether the peer has a connection."""
        return self._socket is not None

    def put(self, message: Outgoing, time_to_live: float) -> None:
        """Append a message to the queue, from any thread."""
        self.queue.put(message, time_to_live, len(message.text))
        if not self._woken:
            self._woken = True
            self._loop.call_soon_threadsafe(self._filled.set)

    def note(self, what: str, details: str = "") -> None:
        """Log something about this connection, the first time that it happens."""
        if what not in self._logged:
            self._logged.add(what)
            log.warning("%s: %s%s", self.name, what, details)

    def close(self) -> None:
        """Discard what waits to be sent."""
        if self._failed:
            self._failed[1].settle(False)
        self.queue.clear()

    async def disconnect(self) -> None:
        """Close the connection, even if the other side does not answer."""
        if not self._socket:
            return
        with contextlib.suppress(TimeoutError, ConnectionError):
            await asyncio.wait_for(self._socket.close(), FAREWELL)

    async def run(self, connection: Socket, received: Received) -> None:
        """Send and receive until the connection ends.

        `received` is awaited with each message and its bytes.
        """
        self._socket = connection
        raw = connection.get_extra_info("socket")
        self._logged.clear()
        sender = asyncio.ensure_future(self._send_all(connection))
        try:
            await self._receive_all(connection, received)
        finally:
            sender.cancel()
            await asyncio.gather(sender, return_exceptions=True)
            # What the other side does not read would keep the connection open.
            with contextlib.suppress(OSError, AttributeError):
                raw.shutdown(socket.SHUT_RDWR)
            # Last, so that whoever sees that a peer is gone cannot send to it any more.
            self._socket = None

    async def _send_all(self, connection: Socket) -> None:
        while True:
            self._woken = False
            self._filled.clear()
            while taken := self._next():
                expiry, message = taken
                if not message.begin():
                    continue
                try:
                    await connection.send_str(timed(message.text, expiry - monotonic()))
                except (Exception, asyncio.CancelledError) as error:
                    # It is sent over the next connection, if there is one in time.
                    message.failed()
                    if expiry > monotonic():
                        self._failed = taken
                    else:
                        message.settle(False)
                    if isinstance(error, asyncio.CancelledError):
                        raise
                    return
                message.settle(True)
            await self._filled.wait()

    def _next(self) -> tuple[float, Outgoing] | None:
        """Return the next message to send, with the time when it expires."""
        failed, self._failed = self._failed, None
        if failed:
            if failed[0] > monotonic():
                return failed
            failed[1].settle(False)
        taken = self.queue.take()
        return (monotonic() + taken[0], taken[1]) if taken else None

    async def _receive_all(self, connection: Socket, received: Received) -> None:
        invalid = 0
        async for frame in connection:
            if frame.type == aiohttp.WSMsgType.ERROR:
                if getattr(frame.data, "code", 0) == aiohttp.WSCloseCode.MESSAGE_TOO_BIG:
                    self.note(f"a message is larger than {LONGEST} bytes, so the connection ends")
                return
            try:
                if frame.type != aiohttp.WSMsgType.TEXT:
                    raise InvalidMessage("not a text frame")
                message = decode(frame.data, self.name)
            except InvalidMessage as error:
                invalid += 1
                self.note("sent an invalid message: ", str(error))
                if invalid >= INVALID:
                    await connection.close(
                        code=aiohttp.WSCloseCode.POLICY_VIOLATION, message=b"invalid messages"
                    )
                    return
                continue
            await received(message, len(frame.data))
