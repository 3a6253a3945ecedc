"""Two network namespaces, as two computers whose cable can be pulled."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass

import pytest

only_root = pytest.mark.skipif(
    os.geteuid() != 0 or not shutil.which("ip"), reason="only root makes networks, with iproute2"
)


@dataclass(frozen=True)
class Network:
    """A network namespace, which is connected with one other."""

    name: str
    address: str

    @property
    def inside(self) -> list[str]:
        """What runs the command after it in this network."""
        return ["ip", "netns", "exec", self.name]

    def set(self, state: str) -> None:
        """Cut its connection ("down"), or restore it ("up")."""
        _ip("-n", self.name, "link", "set", "out", state)


@contextmanager
def networks() -> Iterator[tuple[Network, Network]]:
    """Make two networks that nobody else reaches."""
    base = f"sitegen-{os.getpid()}"
    pair = Network(f"{base}-a", "192.0.2.1"), Network(f"{base}-b", "192.0.2.2")
    with ExitStack() as stack:
        for one in pair:
            _ip("netns", "add", one.name)
            stack.callback(_ip, "netns", "delete", one.name)
            _ip("-n", one.name, "link", "set", "lo", "up")
        peer = ["peer", "name", "out", "netns", pair[1].name]
        _ip("link", "add", "out", "netns", pair[0].name, "type", "veth", *peer)
        for one in pair:
            _ip("-n", one.name, "address", "add", f"{one.address}/24", "dev", "out")
            one.set("up")
        yield pair


def _ip(*arguments: str) -> None:
    subprocess.run(["ip", *arguments], check=True)
