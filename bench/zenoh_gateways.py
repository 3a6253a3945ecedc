"""Measure two gateways that have joined over Zenoh, from a robot of one to a node of the other."""

from __future__ import annotations

import sys
import tempfile
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from bench.counts import Counts
from bench.figure import Figure
from bench.orders import SIZES, Found, delays, give, orders, rate

HERE = Path(__file__).parent
SUPPORT = HERE.parent / "tests" / "support"


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
        natively = start(native.python, "native_listener.py")
        joined = start(native.python, "native_listener.py", apart=True)
        publisher = start(sys.executable, "zenoh_bare.py", "publish", bare)
        publisher.expect("ready")
        plain = start(sys.executable, "zenoh_bare.py", "listen", bare)
        return _measure(natively, joined, publisher, plain, counts)


def _measure(
    natively: Any, joined: Any, publisher: Any, plain: Any, counts: Counts
) -> list[Figure]:
    for listener in (natively, joined, plain):
        listener.expect("ready")

    def run(order: str) -> list[Found]:
        return [give(joined, order), give(plain, order, publisher.say), give(natively, order)]

    figures = []
    for shown, size in SIZES.items():
        paced, burst = orders(size, counts.turns)
        (mine, _), (theirs, _), (native, _) = map(delays, run(paced))
        name = f"robot → node elsewhere, {shown}"
        figures.append(Figure(name, "ms", mine, theirs, detail={"native": native}))
        mine, theirs, native = map(rate, run(burst))
        name = f"messages in a burst, {shown}"
        figures.append(Figure(name, "/s", mine, theirs, detail={"native": native}))
    return figures
