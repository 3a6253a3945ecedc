"""Clients that mean no good, or are broken: nothing gets in, and the gateway goes on as before."""

from __future__ import annotations

import asyncio
import contextlib
import json
import random
import socket
import struct
import time
from pathlib import Path
from typing import Any

import aiohttp
import cbor2
import gateways
import pytest
from gateways import Client, Gateway, client, run

MEGABYTE = 1_000_000
# Valid operations, which the malformed ones are made of.
OPERATIONS: tuple[dict[str, Any], ...] = (
    {"op": "advertise", "topic": "/tell", "type": "std_msgs/String"},
    {"op": "publish", "topic": "/tell", "msg": {"data": "x"}},
    {"op": "subscribe", "topic": "/heard", "type": "std_msgs/String", "throttle_rate": 0},
    {"op": "unsubscribe", "topic": "/heard"},
    {"op": "call_service", "service": "/set", "args": {"data": True}},
    {"op": "call_service", "service": "/rosapi/topic_type", "args": {"topic": "/heard"}},
    {"op": "call_service", "service": "/rosapi/get_param", "args": {"name": "/robot:speed"}},
    {"op": "advertise_service", "service": "/x", "type": "std_srvs/Trigger"},
    {"op": "service_response", "service": "/x", "id": "1", "values": {}, "result": True},
    {"op": "advertise_action", "action": "/y", "type": "test_msgs/Fibonacci"},
    {"op": "action_result", "action": "/y", "id": "1", "values": {}, "status": 4},
    {"op": "cancel_action_goal", "action": "/fibonacci", "id": "1"},
    {"op": "fragment", "id": "f", "num": 0, "total": 2, "data": "{"},
    {"op": "set_level", "level": "error"},
    {"op": "auth", "mac": "x"},
)
ODD: tuple[Any, ...] = (
    *(None, True, -1, 0, 1e308, 2**70, "", "/", "\0", "../..", "x" * 1000, [], {}, [[]], {"a": {}}),
    *("std_msgs/msg/String", "os/path", "__import__/msg/system", "/protected", {"op": "publish"}),
)


def malformed(number: int) -> str | bytes:
    """Return a message that is not quite as it should be."""
    chance = random.Random(number)
    message = dict(chance.choice(OPERATIONS))
    for _ in range(chance.randint(1, 3)):
        name = chance.choice([*message, "id", "type", "qos", "compression", "fragment_size"])
        if chance.random() < 0.3:
            message.pop(name, None)
        else:
            message[name] = chance.choice(ODD)
    text = json.dumps(message)
    kind = chance.random()
    if kind < 0.5:
        return text
    if kind < 0.7:
        place = chance.randrange(len(text))
        return text[:place] + chr(chance.randrange(1, 0x300)) + text[place + 1 :]
    if kind < 0.8:
        return text[: chance.randrange(len(text))]
    data = cbor2.dumps(message)
    if kind < 0.9:
        return data
    return bytes(chance.randrange(256) if chance.random() < 0.1 else byte for byte in data)


async def survives(running: Gateway) -> None:
    """Check that a client is served as ever."""
    async with client(running) as page:
        answer = await page.call("/set", {"data": True})
        assert answer["values"] == {"success": True, "message": "from the robot"}


async def admitted(running: Gateway) -> None:
    """Wait until a client is served: the gateway notices a moment later that another one left."""
    for _ in range(100):
        with contextlib.suppress(AssertionError):
            return await survives(running)
        await asyncio.sleep(0.05)
    await survives(running)


def failures(running: Gateway) -> list[str]:
    """Return what the gateway says of its own faults."""
    return [line for line in running.lines if "gateway failed" in line or "Traceback" in line]


async def bombard(running: Gateway, first: int, last: int) -> None:
    """Send malformed messages; each connection that the gateway ends is made anew."""
    number = first
    while number < last:
        async with client(running) as page:
            reading = asyncio.create_task(_read(page))
            try:
                while number < last and not page.socket.closed:
                    message = malformed(number)
                    number += 1
                    if isinstance(message, str):
                        await page.socket.send_str(message)
                    else:
                        await page.socket.send_bytes(message)
            except (ConnectionError, aiohttp.ClientError):
                pass
            await page.socket.close()
            await reading


async def _read(page: Client) -> None:
    async for _ in page.socket:
        pass


def test_malformed_messages(opened: Gateway) -> None:
    run(bombard(opened, 0, 1500), 100)
    run(survives(opened))
    assert not [
        line for line in opened.lines if "the gateway failed" in line or "Traceback" in line
    ]


@pytest.mark.exhaustive
def test_very_many_malformed_messages(opened: Gateway) -> None:
    run(bombard(opened, 1500, 10_000), 600)
    before = opened.memory
    run(bombard(opened, 10_000, 110_000), 3600)
    assert opened.memory - before < 30 * MEGABYTE
    run(survives(opened))
    assert not [
        line for line in opened.lines if "the gateway failed" in line or "Traceback" in line
    ]


def test_malformed_frames_and_requests(opened: Gateway) -> None:
    upgrade = (
        b"GET / HTTP/1.1\r\nHost: x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        b"Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n\r\n"
    )
    frames = [
        b"\xff" * 100,
        # A message of 2^63 - 1 bytes, a control frame of 1000, an unknown opcode, no mask.
        b"\x82\xff" + struct.pack(">Q", 2**63 - 1) + b"\0\0\0\0",
        b"\x89\xfe\x03\xe8\0\0\0\0" + b"x" * 1000,
        b"\x83\x80\0\0\0\0",
        b"\x81\x05hello",
        # Text that is not UTF-8, and a continuation of nothing.
        b"\x81\x82\0\0\0\0\xff\xff",
        b"\x80\x80\0\0\0\0",
    ]
    requests = [b"\0" * 1000, b"GET / HTTP/9\r\n\r\n", b"GET /" + b"a" * 100_000, b"\r\n" * 1000]
    for data in (*requests, *(upgrade + frame for frame in frames)):
        with socket.create_connection(("127.0.0.1", opened.port)) as raw:
            raw.settimeout(30)
            try:
                raw.sendall(data)
                raw.shutdown(socket.SHUT_WR)
                while raw.recv(65536):
                    pass
            except ConnectionError:
                pass
    run(survives(opened))


def test_a_client_that_never_reads(opened: Gateway) -> None:
    """It is sent 20 MB in a second, and the gateway keeps none of that for it."""

    async def work() -> None:
        async with client(opened) as page:
            # Without being read, its buffers fill up.
            transport = page.socket._response.connection.transport  # type: ignore[union-attr]
            assert transport
            transport.pause_reading()
            await page.send(op="subscribe", topic="/flood")
            await asyncio.sleep(2)
            before = opened.memory
            await asyncio.sleep(6)
            assert opened.memory - before < 10 * MEGABYTE
            await survives(opened)
            transport.abort()

    run(work())


def test_answers_that_are_not_read_do_not_pile_up(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            transport = page.socket._response.connection.transport  # type: ignore[union-attr]
            assert transport
            transport.pause_reading()
            before = opened.memory
            # Each answer is a hundred times as large as its question.
            question = {"op": "call_service", "service": "/rosapi/interfaces"}
            sent = 0
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(6):
                    while sent < 100_000:
                        await page.send(**question)
                        sent += 1
            assert sent > 100
            assert opened.memory - before < 15 * MEGABYTE
            await survives(opened)
            transport.abort()

    run(work())


def test_a_client_that_floods_has_to_wait(robot: gateways.Process, tmp_path: Path) -> None:
    (tmp_path / "gateway.yaml").write_text("limits: {messages_per_second: 200}\n")

    async def work(running: Gateway) -> None:
        async with client(running) as page:
            await page.settle()
            start = time.monotonic()
            for number in range(1000):
                await page.send(op="publish", topic="/tell", msg={"data": str(number)})
            # Meanwhile others are served.
            await survives(running)
            await page.until("publish", msg={"data": "999"})
            # A burst of two seconds, and 600 more.
            assert time.monotonic() - start > 2.5

    with gateways.gateway(folder=tmp_path) as running:
        run(work(running))
        assert len([line for line in running.lines if "faster than the limit" in line]) == 1


def test_connections_are_limited(robot: gateways.Process, tmp_path: Path) -> None:
    rules = "limits: {connections: 6, connections_per_address: 4, handshake: 1}\n"
    (tmp_path / "gateway.yaml").write_text(rules)

    async def work(running: Gateway) -> None:
        pages = []
        async with aiohttp.ClientSession() as session:
            for _ in range(4):
                pages.append(Client(await session.ws_connect(running.url)))
                await pages[-1].send(op="set_level", level="info")
            fifth = Client(await session.ws_connect(running.url))
            closed = await fifth.next()
            assert closed["code"] == 1008
            assert closed["reason"] == "4 connections from one address are the limit"
            await pages.pop().socket.close()
            await admitted(running)
            # One that says nothing is not waited for.
            reader, writer = await asyncio.open_connection("127.0.0.1", running.port)
            assert await asyncio.wait_for(reader.read(), 5) == b""
            writer.close()

    with gateways.gateway(folder=tmp_path) as running:
        run(work(running))


def test_clients_are_told_when_the_gateway_stops(robot: gateways.Process, tmp_path: Path) -> None:
    async def work(running: Gateway) -> None:
        async with client(running) as page:
            await page.settle()
            stopping = asyncio.create_task(asyncio.to_thread(running.stop))
            while (message := await page.next())["op"] != "closed":
                page.passed.append(message)
            assert message["reason"] == "the gateway is stopping"
            await stopping

    with gateways.gateway(folder=tmp_path) as running:
        run(work(running))
        assert running.process.returncode == 0
        assert not [line for line in running.lines if "Traceback" in line]
