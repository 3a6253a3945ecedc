"""A gateway as a process, and a native robot beside it."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from native import Native
from paths import SUPPORT
from waiting import until

ROBOT = SUPPORT / "ros2" / "gateway_robot.py"
# The gateway, whose clock is some seconds ahead.
AHEAD = (
    "import sys, time; real = time.time; time.time = lambda: real() + {}; "
    "from sitegen.__main__ import main; sys.exit(main(sys.argv[1:]))"
)


class Gateway:
    """`sitegen gateway`, which can be killed and started again on its port."""

    def __init__(self, native: Native, log: Path, site: Path | None = None) -> None:
        self._native = native
        self._log = log
        self._site = site
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port: int = free.getsockname()[1]
        self._process: subprocess.Popen[bytes] | None = None

    def start(self, *, ahead: float = 0, config: Path | None = None) -> None:
        """Start it, with a clock that is `ahead` by some seconds, or by a gateway.yaml."""
        how = ["-c", AHEAD.format(ahead)] if ahead else ["-m", "sitegen"]
        site = ["--site", str(self._site)] if self._site else []
        given = ["--config", str(config)] if config else []
        command: list[str | Path] = [self._native.python, *how]
        command += ["gateway", "--port", str(self.port), *site, *given]
        with self._log.open("ab") as log:
            self._process = subprocess.Popen(
                command, env=self._native.environment, stdout=log, stderr=log
            )
        until(self._listens)

    def _listens(self) -> bool:
        assert self._process and self._process.poll() is None, self.log
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", self.port)) == 0

    def stop(self, number: int = signal.SIGTERM) -> None:
        """End it, as Ctrl-C does or without a chance to say good-bye."""
        if self._process:
            self._process.send_signal(number)
            self._process.wait(20)
            self._process = None

    def pause(self, yes: bool) -> None:
        """Let it stand still, as a cut cable lets it appear, or go on."""
        assert self._process
        self._process.send_signal(signal.SIGSTOP if yes else signal.SIGCONT)

    @property
    def memory(self) -> int:
        """Its resident memory in bytes."""
        assert self._process
        fields = Path(f"/proc/{self._process.pid}/statm").read_text().split()
        return int(fields[1]) * os.sysconf("SC_PAGESIZE")

    @property
    def log(self) -> list[str]:
        """The lines that it has written."""
        return self._log.read_text("utf-8").splitlines()

    @property
    def http(self) -> str:
        """The address of the site that it serves."""
        return f"http://127.0.0.1:{self.port}/"


class Robot:
    """A native node; its methods are those of tests/support/ros2/gateway_robot.py."""

    def __init__(self, native: Native, inside: Sequence[str] = ()) -> None:
        """Start it; `inside` is what runs the command after it elsewhere."""
        self._process = subprocess.Popen(
            [*inside, native.python, ROBOT],
            env=native.environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self._read()

    def __getattr__(self, name: str) -> Callable[..., Any]:
        def call(*arguments: object) -> Any:
            assert self._process.stdin
            self._process.stdin.write(json.dumps([name, *arguments]) + "\n")
            self._process.stdin.flush()
            return self._read()

        return call

    def _read(self) -> Any:
        assert self._process.stdout
        return json.loads(self._process.stdout.readline())

    def stop(self) -> None:
        """End it."""
        self._process.kill()
        self._process.communicate()
