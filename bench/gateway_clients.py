"""Clients in Python: of a gateway, by frames of pages or rosbridge, and of a bare WebSocket."""

from __future__ import annotations

import base64
import json
import struct
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass
from typing import Any

import aiohttp
import cbor2

from bench.orders import Found

HEAD = struct.Struct("<IIIId")
# Gives an order (bench/orders.py) to whoever sends.
Order = Callable[[str], Any]


@dataclass(frozen=True)
class Topic:
    """What the robot publishes, and where it takes orders."""

    name: str
    type: str
    orders: str
    # Where the data begin: after the head of CDR, the layout, the offset and the length.
    start: int


BYTES = Topic("/bytes", "std_msgs/msg/UInt8MultiArray", "/go", 16)
NUMBERS = Topic("/numbers", "std_msgs/msg/Float64MultiArray", "/go_numbers", 20)


class Reader:
    """A client, and what it does with what it gets."""

    # What begins and ends its subscription.
    begin: dict[str, Any]
    end: dict[str, Any]

    def __init__(self, socket: aiohttp.ClientWebSocketResponse) -> None:
        self.socket = socket

    async def listen(self, yes: bool) -> None:
        """Subscribe, or no longer."""
        await self.socket.send_json(self.begin if yes else self.end)

    async def collect(self, count: int, quiet: float) -> Found:
        """Return what came, until that many messages or none for a while (s)."""
        found: Found = []
        while len(found) < count:
            try:
                message = await self.socket.receive(quiet)
            except TimeoutError:
                break
            now = time.time_ns()
            payloads = self.payloads(message)
            found += [(struct.unpack_from("<Q", data)[0], now) for data in payloads]
            await self.thank(len(payloads), len(message.data))
        return found

    def payloads(self, message: aiohttp.WSMessage) -> list[bytes]:
        """Return what the robot has sent in a WebSocket message."""
        return [message.data]

    async def thank(self, records: int, size: int) -> None:
        """Let the server send more."""


class FrameReader(Reader):
    """A page's client."""

    def __init__(self, socket: aiohttp.ClientWebSocketResponse, topic: Topic) -> None:
        super().__init__(socket)
        self._topic = topic

    async def join(self) -> None:
        """Say hello, and wait until the robot's publisher is told."""
        await self.socket.send_json({"op": "hello", "version": 1, "page": str(id(self))})
        while not hasattr(self, "begin"):
            said = json.loads((await self.socket.receive(20)).data)
            for one in said["come"] if said["op"] == "graph" else []:
                if one["kind"] == "publisher" and one["name"] == self._topic.name:
                    self.begin = {"op": "open", "id": one["id"]}
                    self.end = {"op": "close", "id": one["id"]}

    def payloads(self, message: aiohttp.WSMessage) -> list[bytes]:
        """Return the messages of a frame; news of the graph have none."""
        found: list[bytes] = []
        if message.type != aiohttp.WSMsgType.BINARY:
            return found
        at = 0
        while at < len(message.data):
            _, _, _, size, _ = HEAD.unpack_from(message.data, at)
            at += HEAD.size
            found.append(message.data[at + self._topic.start : at + size])
            at += size + 7 & ~7
        return found

    async def thank(self, records: int, size: int) -> None:
        """Give credit."""
        if records:
            await self.socket.send_json({"op": "credit", "records": records, "bytes": size})


class RosbridgeReader(Reader):
    """A client of rosbridge, with a compression of its own."""

    def __init__(
        self, socket: aiohttp.ClientWebSocketResponse, compression: str, topic: Topic
    ) -> None:
        super().__init__(socket)
        self._topic = topic
        how = {"compression": compression, "queue_length": 1000}
        self.begin = {"op": "subscribe", "topic": topic.name, "type": topic.type, **how}
        self.end = {"op": "unsubscribe", "topic": topic.name}

    def payloads(self, message: aiohttp.WSMessage) -> list[bytes]:
        """Return the bytes of a message: CDR in CBOR, and base64 or the first number in JSON."""
        if message.type == aiohttp.WSMsgType.BINARY:
            return [cbor2.loads(message.data)["msg"]["bytes"][self._topic.start :]]
        said = json.loads(message.data)
        if said["op"] != "publish":
            return []
        data = said["msg"]["data"]
        return [base64.b64decode(data) if isinstance(data, str) else struct.pack("<d", data[0])]


@asynccontextmanager
async def frames(url: str, topic: Topic = BYTES) -> AsyncIterator[Reader]:
    """Join a gateway as a page does."""
    async with _connected(url, "sitegen.1") as socket:
        reader = FrameReader(socket, topic)
        await reader.join()
        yield reader


@asynccontextmanager
async def rosbridge(url: str, compression: str, topic: Topic = BYTES) -> AsyncIterator[Reader]:
    """Connect to a gateway by rosbridge."""
    async with _connected(url) as socket:
        yield RosbridgeReader(socket, compression, topic)


@asynccontextmanager
async def bare(url: str) -> AsyncIterator[Reader]:
    """Connect to gateway_bare.py, which always sends what is ordered."""
    async with _connected(url) as socket:
        yield Reader(socket)


@asynccontextmanager
async def driver(url: str, topic: Topic = BYTES) -> AsyncIterator[Order]:
    """Connect to a gateway, to give orders to the robot."""
    async with _connected(url) as socket:
        about = {"topic": topic.orders, "type": "std_msgs/String"}
        await socket.send_json({"op": "advertise", **about})

        async def go(order: str) -> None:
            message = {"topic": topic.orders, "msg": {"data": order}}
            await socket.send_json({"op": "publish", **message})

        yield go


@asynccontextmanager
async def _connected(url: str, *protocols: str) -> AsyncIterator[aiohttp.ClientWebSocketResponse]:
    async with (
        aiohttp.ClientSession() as session,
        session.ws_connect(url, protocols=protocols, max_msg_size=0) as socket,
    ):
        yield socket
