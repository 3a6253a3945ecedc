"""Measure two gateways that have joined over Zenoh, from a robot of one to a node of the other."""

from __future__ import annotations

import json
import sys
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path
from statistics import median
from typing import Any

from bench.counts import Counts
from bench.figure import Figure

HERE = Path(__file__).parent
SUPPORT = HERE.parent / "tests" / "support"
SIZES = {"16 B": 16, "1 KB": 1024, "1 MB": 2**20}
# When messages were sent and received (ns).
Found = list[tuple[int, int]]


def zenoh(counts: Counts) -> list[Figure]:
    """Latency and throughput beside bare Zenoh between two processes; natively in the details."""
    sys.path.append(str(SUPPORT))
    import gateways
    from gateways import Process
    from native import Native

    native = Native()
    port, bare = str(gateways.free_port()), str(gateways.free_port())
    with tempfile.TemporaryDirectory() as folder, ExitStack() as stack:

        def start(python: str | Path, *command: str, apart: bool = False) -> Process:
            env = gateways.environment(native, apart=apart)
            running = Process(python, HERE / command[0], *command[1:], env=env)
            stack.callback(running.stop)
            return running

        def join(*options: str, apart: bool = False) -> None:
            own = Path(tempfile.mkdtemp(dir=folder))
            stack.enter_context(gateways.gateway("--zenoh", *options, folder=own, apart=apart))

        start(native.python, "gateway_robot.py").expect("ready")
        join("--zenoh-port", port)
        join(f"localhost:{port}", "--zenoh-port", "0", apart=True)
        natively = start(native.python, "zenoh_listener.py")
        joined = start(native.python, "zenoh_listener.py", apart=True)
        publisher = start(sys.executable, "zenoh_bare.py", "publish", bare)
        publisher.expect("ready")
        plain = start(sys.executable, "zenoh_bare.py", "listen", bare)
        return _measure(natively, joined, publisher, plain, counts)


def _measure(
    natively: Any, joined: Any, publisher: Any, plain: Any, counts: Counts
) -> list[Figure]:
    for listener in (natively, joined, plain):
        listener.expect("ready")
    figures = []
    for bursts in (False, True):
        for shown, size in SIZES.items():
            count, period = (5, 0.1) if size > 10_000 else (50, 0.01)
            if bursts:
                count, period = 10 * count, 0
            order = f"{size} {count * counts.turns} {period}"
            ours = _run(joined, joined, order)
            bare = _run(plain, publisher, order)
            alone = _run(natively, natively, order)
            name, unit = (
                ("messages in a burst", "/s") if bursts else ("robot → node elsewhere", "ms")
            )
            mine, theirs, native = map(_rate if bursts else _delay, (ours, bare, alone))
            detail = {"native": native}
            figures.append(Figure(f"{name}, {shown}", unit, mine, theirs, detail=detail))
    return figures


def _run(listener: Any, driver: Any, order: str) -> Found:
    """Give an order, and return what the listener has got for it."""
    start = len(listener.lines)
    listener.say(order)
    if driver is not listener:
        listener.expect("listening", start)
        driver.say(order)
    found: Found = json.loads(listener.expect("[[", start))
    # Whatever is still on its way.
    time.sleep(0.5)
    return found


def _delay(found: Found) -> float:
    return median(received - sent for sent, received in found) / 1e6


def _rate(found: Found) -> float:
    return (len(found) - 1) / (found[-1][1] - found[0][0]) * 1e9
