"""Measure the gateway: from a native robot to a client, in each protocol, and to many clients."""

from __future__ import annotations

import asyncio
import base64
import json
import struct
import sys
import tempfile
import time
from collections.abc import AsyncIterator, Callable
from contextlib import AsyncExitStack, asynccontextmanager
from pathlib import Path
from statistics import median
from typing import Any

import aiohttp
import cbor2

from bench.counts import Counts
from bench.figure import Figure

HERE = Path(__file__).parent
SUPPORT = HERE.parent / "tests" / "support"
TOPIC, TYPE = "/bytes", "std_msgs/msg/UInt8MultiArray"
# Layout, offset and length of the type, after the head of CDR.
BEFORE = 4 + 12
HEAD = struct.Struct("<IIIId")
SIZES = {"16 B": 16, "1 KB": 1024, "1 MB": 2**20}
CLIENTS = 100
# Returns the payloads in a WebSocket message.
Payloads = Callable[[aiohttp.WSMessage], list[bytes]]


class Reader:
    """A client, and what it does with what it gets."""

    def __init__(self, socket: aiohttp.ClientWebSocketResponse, payloads: Payloads) -> None:
        self.socket = socket
        self._payloads = payloads

    async def collect(self, count: int, quiet: float) -> list[tuple[int, int]]:
        """Return when messages were sent and received (ns), until none comes for a while (s)."""
        found: list[tuple[int, int]] = []
        while len(found) < count:
            try:
                message = await self.socket.receive(quiet)
            except TimeoutError:
                break
            now = time.monotonic_ns()
            for data in self._payloads(message):
                found.append((struct.unpack_from("<Q", data)[0], now))
            if self.socket.protocol == "sitegen.1" and message.type == aiohttp.WSMsgType.BINARY:
                records = len(self._payloads(message))
                size = len(message.data)
                await self.socket.send_json({"op": "credit", "records": records, "bytes": size})
        return found


def gateway(counts: Counts) -> list[Figure]:
    """Latency and throughput of the protocols beside a bare WebSocket, and of a hundred clients."""
    sys.path.append(str(SUPPORT))
    import gateways
    from native import Native

    native = Native()
    env = gateways.environment(native)
    with tempfile.TemporaryDirectory() as folder:
        limits = "limits: {connections: 300, connections_per_address: 300}\n"
        (Path(folder) / "gateway.yaml").write_text(limits)
        robot = gateways.Process(native.python, HERE / "gateway_robot.py", env=env)
        bare = gateways.Process(sys.executable, HERE / "gateway_bare.py", env=env)
        try:
            robot.expect("ready")
            with gateways.gateway(folder=Path(folder)) as running:
                return asyncio.run(_measure(running.url, bare.expect("ws://"), counts))
        finally:
            bare.process.terminate()
            bare.stop()
            robot.stop()


async def _measure(url: str, bare: str, counts: Counts) -> list[Figure]:
    figures = []
    async with AsyncExitStack() as stack:
        go = await stack.enter_async_context(_driver(url))
        ours = {
            "frames": await stack.enter_async_context(_frames(url)),
            "cbor-raw": await stack.enter_async_context(_rosbridge(url, "cbor-raw")),
            "JSON": await stack.enter_async_context(_rosbridge(url, "none")),
        }
        plain = await stack.enter_async_context(_bare(bare))
        for shown, size in SIZES.items():
            for name in ours:
                await _unsubscribe(ours, name)
                # A megabyte a hundred times in a second is more than two cores encode as JSON.
                count, period = (
                    (5 * counts.turns, 0.1) if size > 10_000 else (50 * counts.turns, 0.01)
                )
                mine = _delays(await _run(ours[name], go, f"{size} {count} {period}", count))
                theirs = _delays(
                    await _run(plain, plain.socket.send_str, f"{size} {count} {period}", count)
                )
                figures.append(Figure(f"robot → client, {shown}, {name}", "ms", mine, theirs))
        for shown, size in SIZES.items():
            for name in ours:
                await _unsubscribe(ours, name)
                count = counts.turns * (50 if size > 10_000 else 500)
                mine = _rate(await _run(ours[name], go, f"{size} {count} 0", count))
                theirs = _rate(await _run(plain, plain.socket.send_str, f"{size} {count} 0", count))
                figures.append(Figure(f"messages in a burst, {shown}, {name}", "/s", mine, theirs))
        await _unsubscribe(ours, "")
    figures.append(await _many(url, counts))
    return figures


async def _run(reader: Reader, go: Any, order: str, count: int) -> list[tuple[int, int]]:
    collecting = asyncio.create_task(reader.collect(count, 2))
    await go(order)
    return await collecting


def _delays(found: list[tuple[int, int]]) -> float:
    return median(received - sent for sent, received in found) / 1e6


def _rate(found: list[tuple[int, int]]) -> float:
    return (len(found) - 1) / (found[-1][1] - found[0][0]) * 1e9


async def _many(url: str, counts: Counts) -> Figure:
    """Messages of 1 KB that reach a hundred clients, all of them together."""
    count = 20 * counts.turns
    async with AsyncExitStack() as stack:
        go = await stack.enter_async_context(_driver(url))
        opened = [_rosbridge(url, "cbor-raw") for _ in range(CLIENTS)]
        readers = [await stack.enter_async_context(each) for each in opened]
        for reader in readers:
            await _listen(reader, True)
        await asyncio.sleep(1)
        work = [asyncio.create_task(reader.collect(count, 5)) for reader in readers]
        await go(f"1024 {count} 0.02")
        found = [each for one in await asyncio.gather(*work) for each in one]
    delivered = len(found) / CLIENTS / count
    delay = _delays(found)
    return Figure(
        f"robot → {CLIENTS} clients, 1 KB at 50 Hz", "ms", delay, detail={"delivered": delivered}
    )


async def _unsubscribe(readers: dict[str, Reader], keep: str) -> None:
    """Let only one client listen: the others would take the time of the gateway."""
    for name, reader in readers.items():
        await _listen(reader, name == keep)
    await asyncio.sleep(0.5)


async def _listen(reader: Reader, listens: bool) -> None:
    socket = reader.socket
    if socket.protocol == "sitegen.1":
        await socket.send_json({"op": "open" if listens else "close", "id": _remote[socket]})
    elif listens:
        await socket.send_json({"op": "subscribe", "topic": TOPIC, "type": TYPE, **_how[socket]})
    else:
        await socket.send_json({"op": "unsubscribe", "topic": TOPIC})


# By connection: the id of the robot's publisher, and the options of a subscription.
_remote: dict[aiohttp.ClientWebSocketResponse, int] = {}
_how: dict[aiohttp.ClientWebSocketResponse, dict[str, Any]] = {}


@asynccontextmanager
async def _connected(url: str, *protocols: str) -> AsyncIterator[aiohttp.ClientWebSocketResponse]:
    async with (
        aiohttp.ClientSession() as session,
        session.ws_connect(url, protocols=protocols, max_msg_size=0) as socket,
    ):
        yield socket


@asynccontextmanager
async def _driver(url: str) -> AsyncIterator[Callable[[str], Any]]:
    async with _connected(url) as socket:
        about = {"topic": "/go", "type": "std_msgs/String"}
        await socket.send_json({"op": "advertise", **about})

        async def go(order: str) -> None:
            await socket.send_json({"op": "publish", "topic": "/go", "msg": {"data": order}})

        yield go


@asynccontextmanager
async def _rosbridge(url: str, compression: str) -> AsyncIterator[Reader]:
    def json_payloads(message: aiohttp.WSMessage) -> list[bytes]:
        said = json.loads(message.data)
        return [base64.b64decode(said["msg"]["data"])] if said["op"] == "publish" else []

    def raw_payloads(message: aiohttp.WSMessage) -> list[bytes]:
        return [cbor2.loads(message.data)["msg"]["bytes"][BEFORE:]]

    async with _connected(url) as socket:
        _how[socket] = {"compression": compression, "queue_length": 1000}
        yield Reader(socket, json_payloads if compression == "none" else raw_payloads)


@asynccontextmanager
async def _frames(url: str) -> AsyncIterator[Reader]:
    def payloads(message: aiohttp.WSMessage) -> list[bytes]:
        if message.type != aiohttp.WSMsgType.BINARY:
            return []
        found, at = [], 0
        while at < len(message.data):
            _, _, _, size, _ = HEAD.unpack_from(message.data, at)
            found.append(message.data[at + HEAD.size + BEFORE : at + HEAD.size + size])
            at += HEAD.size + (size + 7 & ~7)
        return found

    async with _connected(url, "sitegen.1") as socket:
        await socket.send_json({"op": "hello", "version": 1, "page": "bench"})
        while socket not in _remote:
            said = json.loads((await socket.receive(20)).data)
            for one in said["come"] if said["op"] == "graph" else []:
                if one["kind"] == "publisher" and one["name"] == TOPIC:
                    _remote[socket] = one["id"]
        yield Reader(socket, payloads)


@asynccontextmanager
async def _bare(url: str) -> AsyncIterator[Reader]:
    async with _connected(url) as socket:
        yield Reader(socket, lambda message: [message.data])
