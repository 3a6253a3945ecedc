"""The protocol of pages, spoken by a plain WebSocket: what a page does, without the page."""

from __future__ import annotations

import asyncio
import json
import secrets
import struct
from collections.abc import AsyncIterator, Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from typing import Any

import aiohttp
from joined import Gateway

# Reader, writer, sequence, size, timestamp.
HEAD = struct.Struct("<IIIId")
STRING = "std_msgs/msg/String"
QOS = {"depth": 10, "reliable": True, "transientLocal": False, "keepAll": False}


class Client:
    """A page that has joined, and what it has been told."""

    def __init__(self, socket: aiohttp.ClientWebSocketResponse) -> None:
        self.socket = socket
        self.remote: dict[str, int] = {}
        self.texts: dict[int, list[str]] = {}
        self.said: list[dict[str, Any]] = []

    async def say(self, **message: object) -> None:
        await self.socket.send_str(json.dumps(message))

    async def hear(self) -> bool:
        """Take what comes next; return False at the end."""
        message = await self.socket.receive(20)
        if message.type == aiohttp.WSMsgType.BINARY:
            at = count = 0
            while at < len(message.data):
                _, writer, _, size, _ = HEAD.unpack_from(message.data, at)
                body = message.data[at + HEAD.size : at + HEAD.size + size]
                self.texts.setdefault(writer, []).append(body[8:].decode().rstrip("\0"))
                at += HEAD.size + (size + 7 & ~7)
                count += 1
            await self.say(op="credit", records=count, bytes=len(message.data))
        elif message.type == aiohttp.WSMsgType.TEXT:
            said = json.loads(message.data)
            self.said.append(said)
            if said["op"] == "graph":
                for one in said["come"]:
                    self.remote[f"{one['kind']} {one['node']} {one['name']}"] = one["id"]
        else:
            return False
        return True

    async def until(self, check: Callable[[], object]) -> None:
        while not check():
            assert await self.hear(), "the connection has ended"

    def there(self) -> list[dict[str, Any]]:
        """The pages that have joined, as it was told last."""
        told = [said["pages"] for said in self.said if said["op"] == "people"]
        return told[-1] if told else []

    def reasons(self) -> list[str]:
        return [said["reason"] for said in self.said if said["op"] == "refused"]


@asynccontextmanager
async def connected(gateway: Gateway, **more: object) -> AsyncIterator[Client]:
    """Join; `more` is what the page says of itself."""
    async with (
        aiohttp.ClientSession() as session,
        session.ws_connect(
            f"ws://127.0.0.1:{gateway.port}", protocols=["sitegen.1"], max_msg_size=0
        ) as socket,
    ):
        client = Client(socket)
        await client.say(**{"op": "hello", "version": 1, "page": secrets.token_hex(4), **more})
        await client.until(lambda: len(client.said) == 2)
        assert [said["op"] for said in client.said] == ["challenge", "welcome"]
        yield client


def run(work: Callable[[], Awaitable[None]]) -> None:
    async def main() -> None:
        async with asyncio.timeout(60):
            await work()
        # aiohttp closes its sockets in later turns of the loop.
        await asyncio.sleep(0.1)

    # Playwright's loop runs in this thread while another test's browser is open.
    with ThreadPoolExecutor(1) as pool:
        pool.submit(asyncio.run, main()).result()


def record(writer: int, data: bytes) -> bytes:
    return HEAD.pack(0, writer, 1, len(data), 0) + data + bytes(-len(data) % 8)


def text(data: str) -> bytes:
    body = data.encode() + b"\0"
    return b"\0\1\0\0" + len(body).to_bytes(4, "little") + body


def endpoint(
    id: int, kind: str, name: str, type: str = STRING, **more: object
) -> dict[str, object]:
    return {"id": id, "kind": kind, "node": "/raw", "name": name, "type": type, "qos": QOS, **more}
