"""Measure the gateway: between a robot and its clients, in each protocol, and to many of them."""

from __future__ import annotations

import asyncio
import os
import sys
import tempfile
import time
from collections.abc import AsyncIterator, Callable
from contextlib import AsyncExitStack, ExitStack, asynccontextmanager
from pathlib import Path
from typing import Any

from bench.counts import Counts
from bench.figure import Figure, Target
from bench.gateway_clients import (
    BYTES,
    NUMBERS,
    Order,
    Reader,
    Topic,
    bare,
    driver,
    frames,
    rosbridge,
)
from bench.gateway_page import between_page_and_robot
from bench.orders import SIZES, Found, delays, give, orders, rate

HERE = Path(__file__).parent
SUPPORT = HERE.parent / "tests" / "support"
CLIENTS, NODES = 100, 40
# How many times as many large messages frames carry as JSON.
LEAST = 5
LIMITS = "limits: {connections: 300, connections_per_address: 300}\n"


def gateway(counts: Counts) -> list[Figure]:
    """Latency and throughput beside a bare WebSocket, and beside ROS without a gateway."""
    sys.path.append(str(SUPPORT))
    import gateways
    from native import Native

    native = Native()
    env = gateways.environment(native)
    with tempfile.TemporaryDirectory() as folder, ExitStack() as stack:
        (Path(folder) / "gateway.yaml").write_text(LIMITS)

        def start(python: str | Path, file: str, *arguments: str) -> Any:
            running = gateways.Process(python, HERE / file, *arguments, env=env)
            stack.callback(running.stop)
            return running

        robot = start(native.python, "gateway_robot.py")
        robot.expect("ready")
        listener = start(native.python, "native_listener.py")
        listener.expect("ready")
        figures, natively = _natively(listener, counts)
        listener.stop()
        plain = start(sys.executable, "gateway_bare.py")
        address = plain.expect("ws://")
        running = stack.enter_context(gateways.gateway(folder=Path(folder)))
        figures += between_page_and_robot(running.port, address, robot, plain, natively, counts)
        figures += asyncio.run(_to_clients(running.url, address, counts))
        pid = running.process.pid
        for name, opened in (("pages", frames), ("rosbridge clients", _raw)):
            figures += asyncio.run(_to_many(running.url, name, opened, pid, counts))
        start(native.python, "gateway_crowd.py", str(NODES)).expect("ready")
        return figures + asyncio.run(_among_many(running.url, pid, counts))


def _natively(listener: Any, counts: Counts) -> tuple[list[Figure], dict[str, float]]:
    """From the robot to a native node in Python; also return the medians, by size (ms)."""
    figures, middles = [], {}
    for shown, size in SIZES.items():
        paced, burst = orders(size, counts.turns)
        middles[shown], high = delays(give(listener, paced))
        figures += [
            Figure(f"robot → native node, {shown}, p50", "ms", middles[shown]),
            Figure(f"robot → native node, {shown}, p99", "ms", high),
            Figure(f"robot → native node in a burst, {shown}", "/s", rate(give(listener, burst))),
        ]
    return figures, middles


async def _to_clients(url: str, address: str, counts: Counts) -> list[Figure]:
    """From the robot to a client in Python, in each protocol."""
    figures = []
    async with AsyncExitStack() as stack:
        go = await stack.enter_async_context(driver(url))
        plain = await stack.enter_async_context(bare(address))
        ours = await _opened(stack, url, BYTES)
        ours["cbor-raw"] = await stack.enter_async_context(_raw(url))
        for shown, size in SIZES.items():
            paced, burst = orders(size, counts.turns)
            for name, reader in ours.items():
                async with _listening(reader):
                    mine = delays(await _run(reader, go, paced))[0]
                    theirs = delays(await _run(plain, plain.socket.send_str, paced))[0]
                    many = rate(await _run(reader, go, burst))
                    most = rate(await _run(plain, plain.socket.send_str, burst))
                title = f"messages in a burst, {shown}, {name}"
                figures += [
                    Figure(f"robot → client, {shown}, {name}", "ms", mine, theirs),
                    Figure(title, "/s", many, most),
                ]
        go = await stack.enter_async_context(driver(url, NUMBERS))
        rates = {}
        for name, reader in (await _opened(stack, url, NUMBERS)).items():
            async with _listening(reader):
                rates[name] = rate(await _run(reader, go, orders(SIZES["1 MB"], counts.turns)[1]))
        title = "messages in a burst, 1 MB of float64, frames (bare: JSON)"
        target = Target("ratio", "≥", LEAST)
        figures.append(Figure(title, "/s", rates["frames"], rates["JSON"], target))
    return figures


async def _opened(stack: AsyncExitStack, url: str, topic: Topic) -> dict[str, Reader]:
    """Return a client for frames and one for JSON."""
    return {
        "frames": await stack.enter_async_context(frames(url, topic)),
        "JSON": await stack.enter_async_context(rosbridge(url, "none", topic)),
    }


@asynccontextmanager
async def _listening(reader: Reader) -> AsyncIterator[None]:
    """Let only this client listen: others would take the time of the gateway."""
    await reader.listen(True)
    await asyncio.sleep(0.5)
    yield
    await reader.listen(False)
    await asyncio.sleep(0.5)


async def _among_many(url: str, gateway: int, counts: Counts) -> list[Figure]:
    """Messages to one client in a graph of many nodes, which the gateway reads again and again."""
    paced = f"16 {125 * counts.turns} 0.01"
    async with driver(url) as go, frames(url) as reader, _listening(reader):
        before, begun = _processor(gateway), time.monotonic()
        middle, high = delays(await _run(reader, go, paced))
        taken = (_processor(gateway) - before) / (time.monotonic() - begun)
    title = f"robot → client among {NODES} nodes, 16 B"
    return [
        Figure(f"{title}, p50", "ms", middle),
        Figure(f"{title}, p99", "ms", high),
        Figure(f"{title}: share of a core", "%", 100 * taken),
    ]


async def _to_many(
    url: str, name: str, opened: Callable[[str], Any], gateway: int, counts: Counts
) -> list[Figure]:
    """Messages of 1 KB at 100 Hz that reach a hundred clients, all of them together."""
    count = 50 * counts.turns
    async with AsyncExitStack() as stack:
        go = await stack.enter_async_context(driver(url))
        readers: list[Reader] = [
            await stack.enter_async_context(opened(url)) for _ in range(CLIENTS)
        ]
        for reader in readers:
            await reader.listen(True)
        await asyncio.sleep(1)
        before = _processor(gateway)
        work = [asyncio.create_task(reader.collect(count, 5)) for reader in readers]
        await go(f"1024 {count} 0.01")
        found = [each for one in await asyncio.gather(*work) for each in one]
        taken = _processor(gateway) - before
    title = f"robot → {CLIENTS} {name}, 1 KB at 100 Hz"
    delivered = {"delivered": len(found) / CLIENTS / count}
    share = 100 * taken / (count * 0.01)
    target = Target("figure", "≤", 100)
    return [
        Figure(f"{title}, p50", "ms", delays(found)[0], detail=delivered),
        Figure(f"{title}: share of a core", "%", share, target=target),
    ]


async def _run(reader: Reader, go: Order, order: str) -> Found:
    collecting = asyncio.create_task(reader.collect(int(order.split()[1]), 2))
    await go(order)
    return await collecting


def _raw(url: str) -> Any:
    return rosbridge(url, "cbor-raw")


def _processor(pid: int) -> float:
    """Return the time that a process has computed (s)."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
