"""Two gateways in two networks, of which one is cut off for a while."""

from __future__ import annotations

import os
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import gateways
import pytest
from gateways import Process
from native import HERE, Native
from waiting import until

pytestmark = pytest.mark.skipif(
    os.geteuid() != 0 or not shutil.which("ip"), reason="only root makes networks, with iproute2"
)
# How many messages are sent while the network is cut, and how often (s).
CUT, PERIOD = 40, 0.05


@dataclass(frozen=True)
class Network:
    """A network namespace, which is connected with one other."""

    name: str
    address: str
    # So that DDS does not join the two by itself, with multicast.
    apart: bool

    def run(self, *command: str | Path, folder: Path) -> Process:
        """Run a program in it."""
        inside = ["ip", "netns", "exec", self.name, Native().python, *command]
        environment = gateways.environment(Native(), apart=self.apart)
        return Process(*inside, env=environment, cwd=folder)

    def set(self, state: str) -> None:
        """Cut its connection, or restore it."""
        ip("-n", self.name, "link", "set", "out", state)


def ip(*arguments: str) -> None:
    subprocess.run(["ip", *arguments], check=True)


@pytest.fixture
def networks() -> Iterator[tuple[Network, Network]]:
    """Two networks; nobody else reaches them."""
    base = f"sitegen-{os.getpid()}"
    first = Network(f"{base}-a", "192.0.2.1", apart=False)
    pair = first, Network(f"{base}-b", "192.0.2.2", apart=True)
    with ExitStack() as stack:
        for one in pair:
            ip("netns", "add", one.name)
            stack.callback(ip, "netns", "delete", one.name)
            ip("-n", one.name, "link", "set", "lo", "up")
        peer = ["peer", "name", "out", "netns", pair[1].name]
        ip("link", "add", "out", "netns", pair[0].name, "type", "veth", *peer)
        for one in pair:
            ip("-n", one.name, "address", "add", f"{one.address}/24", "dev", "out")
            one.set("up")
        yield pair


def test_nothing_is_lost_when_the_network_is_cut_for_a_while(
    networks: tuple[Network, Network], tmp_path: Path
) -> None:
    first, second = networks
    gateway = ["-m", "sitegen", "gateway", "--port", "0", "--zenoh"]
    with ExitStack() as stack:

        def start(network: Network, *command: str | Path, expect: str = "") -> Process:
            running = network.run(*command, folder=tmp_path)
            stack.callback(running.stop)
            if expect:
                running.expect(expect)
            return running

        start(first, HERE / "robot.py", expect="ready")
        here = start(first, *gateway, "--bind", first.address, expect="for other gateways")
        start(second, *gateway, first.address, "--zenoh-port", "0", expect="ws:")
        talk = start(second, HERE / "talk.py")
        say = talk.say
        number = 0

        def answered() -> bool:
            say("settled")
            return "settled" in talk.lines

        until(answered)
        first.set("down")
        for number in range(CUT):
            say(str(number))
            time.sleep(PERIOD)
        assert "0" not in talk.lines
        first.set("up")
        talk.expect(str(CUT - 1))
        heard = [line for line in talk.lines if line != "settled"]
        assert heard == [str(number) for number in range(CUT)]
        assert "left" not in "\n".join(here.lines)
