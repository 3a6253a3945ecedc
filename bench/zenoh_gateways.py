"""Measure two gateways that have joined over Zenoh, from a robot of one to a node of the other."""

from __future__ import annotations

import json
import sys
import tempfile
import time
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
    from native import Native

    native = Native()
    port, bare = str(gateways.free_port()), str(gateways.free_port())
    environments = [gateways.environment(native, apart=apart) for apart in (False, True)]
    with tempfile.TemporaryDirectory() as folder:
        near, far = Path(folder, "near"), Path(folder, "far")
        near.mkdir()
        far.mkdir()
        running = [gateways.Process(native.python, HERE / "gateway_robot.py", env=environments[0])]
        running[0].expect("ready")
        joining = ["--zenoh", f"localhost:{port}", "--zenoh-port", "0"]
        try:
            with (
                gateways.gateway("--zenoh", "--zenoh-port", port, folder=near),
                gateways.gateway(*joining, folder=far, apart=True),
            ):
                listener = HERE / "zenoh_listener.py"
                running += [gateways.Process(native.python, listener, env=e) for e in environments]
                publisher = gateways.Process(
                    sys.executable, HERE / "zenoh_bare.py", "publish", bare, env=environments[0]
                )
                publisher.expect("ready")
                running += [publisher]
                running += [
                    gateways.Process(
                        sys.executable, HERE / "zenoh_bare.py", "listen", bare, env=environments[0]
                    )
                ]
                return _measure(running[1], running[2], publisher, running[4], counts)
        finally:
            for process in reversed(running):
                process.stop()


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
