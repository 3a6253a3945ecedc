"""One peer of an endpoint: its queue of messages to send, and its socket while it has one."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from dataclasses import dataclass, field
from time import monotonic
from typing import Any

import aiohttp
from aiohttp import web

from sitegen.rowe.expiring import ExpiringQueue
from sitegen.rowe.message import Body, InvalidMessage, decode, encode

Socket = web.WebSocketResponse | aiohttp.ClientWebSocketResponse

log = logging.getLogger("rowe")

# Invalid messages of a connection that are tolerated; then it is closed.
INVALID = 100


@dataclass
class Outgoing:
    """A message to send; `sent` gets whether it was sent or discarded."""

    body: Body
    fields: dict[str, Any]
    sent: asyncio.Future[bool] = field(
        default_factory=lambda: asyncio.get_running_loop().create_future()
    )
    # It has left its queue: from now on, it is sent or failed, but it does not expire.
    sending: bool = False

    def settle(self, sent: bool) -> None:
        """Tell whoever waits for it."""
        if not self.sent.done():
            self.sent.set_result(sent)


def outgoing_queue() -> ExpiringQueue[Outgoing]:
    """Return an empty queue of messages to send."""
    return ExpiringQueue(dropped=lambda message: message.settle(False))


class Peer:
    """A program at the other end of a connection."""

    def __init__(self, name: str) -> None:
        """Make a peer without a connection."""
        self.name = name
        self.queue = outgoing_queue()
        self._filled = asyncio.Event()
        # A message that could not be sent, and when it expires. It is sent first over the next
        # connection.
        self._failed: tuple[float, Outgoing] | None = None
        self.connected = False

    def put(self, message: Outgoing, time_to_live: float) -> None:
        """Append a message to the queue."""
        self.queue.put(message, time_to_live)
        self._filled.set()

    def close(self) -> None:
        """Discard what waits to be sent."""
        if self._failed:
            self._failed[1].settle(False)
        self.queue.clear()

    async def run(self, socket: Socket, received: Callable[..., Any]) -> None:
        """Send and receive until the connection ends. `received` is awaited with each message."""
        self.connected = True
        sender = asyncio.ensure_future(self._send_all(socket))
        try:
            await self._receive_all(socket, received)
        finally:
            sender.cancel()
            await asyncio.gather(sender, return_exceptions=True)
            # Last, so that whoever sees that a peer is gone cannot send to it any more.
            self.connected = False

    async def _send_all(self, socket: Socket) -> None:
        while True:
            self._filled.clear()
            while taken := self._next():
                expiry, message = taken
                message.sending = True
                text = encode(message.body, **message.fields, time_to_live=expiry - monotonic())
                try:
                    await socket.send_str(text)
                except (ConnectionError, asyncio.CancelledError) as error:
                    # It is sent over the next connection, if there is one in time.
                    message.sending = False
                    self._failed = taken
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

    async def _receive_all(self, socket: Socket, received: Callable[..., Any]) -> None:
        invalid = 0
        async for frame in socket:
            if frame.type == aiohttp.WSMsgType.ERROR:
                return
            try:
                if frame.type != aiohttp.WSMsgType.TEXT:
                    raise InvalidMessage("not a text frame")
                message = decode(frame.data, self.name)
            except InvalidMessage as error:
                invalid += 1
                if invalid == 1:
                    log.warning("%s: sent an invalid message: %s", self.name, error)
                if invalid >= INVALID:
                    await socket.close(
                        code=aiohttp.WSCloseCode.POLICY_VIOLATION, message=b"invalid messages"
                    )
                    return
                continue
            await received(message)
