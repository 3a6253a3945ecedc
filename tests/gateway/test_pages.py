"""The protocol of pages, spoken by a plain WebSocket to a gateway with a native robot behind it."""

from __future__ import annotations

import asyncio
import itertools
from collections.abc import Iterator

import aiohttp
import pytest
from joined import Gateway, Robot
from native import Native
from pageclient import HEAD, connected, endpoint, record, run, text
from waiting import until


@pytest.fixture(scope="module")
def native() -> Native:
    return Native()


@pytest.fixture(scope="module")
def gateway(native: Native, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    gateway = Gateway(native, tmp_path_factory.mktemp("gateway") / "log")
    gateway.start()
    yield gateway
    gateway.stop()


@pytest.fixture(scope="module")
def robot(native: Native) -> Iterator[Robot]:
    robot = Robot(native)
    yield robot
    robot.stop()


def test_a_reliable_burst_comes_whole_and_in_order(gateway: Gateway, robot: Robot) -> None:
    sent = [f"burst {n}" for n in range(500)]
    robot.publish("/robot/burst", [], 1000)

    async def work() -> None:
        async with connected(gateway) as client:
            await client.until(lambda: "publisher /robot /robot/burst" in client.remote)
            id = client.remote["publisher /robot /robot/burst"]
            await client.say(op="open", id=id)
            async with asyncio.timeout(10):
                while not await asyncio.to_thread(robot.subscriptions, "/robot/burst"):
                    await asyncio.sleep(0.05)
            await asyncio.to_thread(robot.publish, "/robot/burst", sent, 1000)
            await client.until(lambda: len(client.texts.get(id, [])) >= len(sent))
            assert client.texts[id] == sent
            await client.say(op="close", id=id)

    run(work)
    # Nobody looks, so nothing is subscribed.
    until(lambda: robot.subscriptions("/robot/burst") == 0)


def test_a_topic_with_a_rate_comes_at_most_as_often(gateway: Gateway, robot: Robot) -> None:
    async def work() -> None:
        async with connected(gateway) as client:
            await client.until(lambda: "publisher /robot /robot/chatter" in client.remote)
            id = client.remote["publisher /robot /robot/chatter"]
            await client.say(op="open", id=id, rate=4)
            await client.until(lambda: len(client.texts.get(id, [])) >= 5)
            numbers = [int(one.split()[1]) for one in client.texts[id]]
            # The robot sends 20 in a second.
            assert all(b - a >= 3 for a, b in itertools.pairwise(numbers)), numbers

    run(work)


def test_what_does_not_fit_is_refused_with_a_reason(gateway: Gateway) -> None:
    come = [
        endpoint(1, "publisher", "/other", hash=f"RIHS01_{0:064}"),
        endpoint(2, "publisher", "/unknown", "no_msgs/msg/Nothing"),
        endpoint(3, "subscription", "/protected/camera"),
        endpoint(4, "publisher", "/not a name"),
        endpoint(5, "publisher", "/raw/fine"),
    ]

    async def work() -> None:
        async with connected(gateway) as client:
            await client.say(op="graph", come=come, gone=[])
            await client.until(lambda: len(client.reasons()) == 4)
            assert client.reasons() == [
                "'std_msgs/msg/String' differs between the page and the gateway: "
                "rebuild the page with the same version of its package",
                "the type 'no_msgs/msg/Nothing' is not installed beside the gateway",
                "/protected/camera is protected",
                "'/not a name' is not a valid name",
            ]

    run(work)


def test_invalid_messages_are_dropped_and_then_their_sender(gateway: Gateway, robot: Robot) -> None:
    robot.listen("/raw/out", False)
    frames: list[bytes | str] = [
        b"\0",
        HEAD.pack(0, 1, 1, 2**31, 0),
        record(1, b"\0\1\0\0\xff\xff\xff\xff"),
        "{",
        "[]",
        '{"op": "graph", "come": [{}]}',
        '{"op": "open", "id": "one"}',
        '{"op": "graph", "come": 5}',
        '{"op": "credit", "records": -1, "bytes": 0}',
        '{"op": "describe", "types": [5]}',
        "[" * 10_000,
    ]

    async def flood() -> None:
        async with connected(gateway) as client:
            await client.say(op="graph", come=[endpoint(1, "publisher", "/raw/out")], gone=[])
            try:
                for n in range(5000):
                    frame = frames[n % len(frames)]
                    if isinstance(frame, bytes):
                        await client.socket.send_bytes(frame)
                    else:
                        await client.socket.send_str(frame)
            except (ConnectionError, aiohttp.ClientError):
                pass
            while await client.hear():
                pass

    run(flood)
    before = gateway.memory
    lines = len(gateway.log)
    for _ in range(20):
        run(flood)
    new = gateway.log[lines:]
    assert sum("invalid messages, let go" in line for line in new) == 20
    assert sum("it was dropped" in line for line in new) == 20
    assert gateway.memory - before < 20_000_000
    assert robot.texts("/raw/out") == []
    # The robot and its listener are as well as before.
    count = len(robot.texts("/page/chatter"))

    async def work() -> None:
        async with connected(gateway) as client:
            await client.say(op="graph", come=[endpoint(1, "publisher", "/page/chatter")], gone=[])
            await client.socket.send_bytes(record(1, text("alive")))
            async with asyncio.timeout(10):
                while len(await asyncio.to_thread(robot.texts, "/page/chatter")) == count:
                    await asyncio.sleep(0.05)

    run(work)
    assert robot.texts("/page/chatter")[count:] == ["alive"]


def test_a_client_that_does_not_read_delays_no_other_one(gateway: Gateway, robot: Robot) -> None:
    robot.publish("/robot/large", [], 10)
    name = "publisher /robot /robot/large"
    large = ["x" * 200_000]

    async def work() -> None:
        async with connected(gateway) as deaf, connected(gateway) as other:
            await deaf.until(lambda: name in deaf.remote)
            await other.until(lambda: name in other.remote)
            for client in (deaf, other):
                await client.say(op="open", id=client.remote[name])
            async with asyncio.timeout(10):
                while not await asyncio.to_thread(robot.subscriptions, "/robot/large"):
                    await asyncio.sleep(0.05)
            before = gateway.memory
            id = other.remote[name]
            for n in range(300):
                await asyncio.to_thread(robot.publish, "/robot/large", large, 10)
                await other.until(lambda n=n: len(other.texts.get(id, [])) > n)  # type: ignore[misc]
                if n % 10 == 0:
                    # It is there, but takes nothing.
                    await deaf.say(op="ping", id=n, sent=0)
            # 60 MB were sent; what waits for it is bounded.
            assert gateway.memory - before < 40_000_000

    run(work)
