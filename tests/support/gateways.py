"""Gateways for tests: each is `sitegen gateway` beside native ROS 2, with a robot behind it."""

from __future__ import annotations

import asyncio
import json
import os
import re
import signal
import socket
import subprocess
import threading
from collections.abc import AsyncIterator, Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager, contextmanager, suppress
from pathlib import Path
from typing import Any, TypeVar

import aiohttp
from native import HERE, Native

from sitegen.gateway.keys import signed

Result = TypeVar("Result")

ADDRESS = re.compile(r"(wss?)://localhost:(\d+)/")


class Process:
    """A process, and what it has printed."""

    def __init__(self, *command: str | Path, env: dict[str, str], cwd: Path | None = None) -> None:
        self.lines: list[str] = []
        self._news = threading.Condition()
        self.process = subprocess.Popen(
            command,
            env=env,
            cwd=cwd,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stdout
        for line in self.process.stdout:
            with self._news:
                self.lines.append(line.rstrip("\n"))
                self._news.notify_all()
        with self._news:
            self.lines.append("(ended)")
            self._news.notify_all()

    def expect(self, text: str, start: int = 0) -> str:
        """Return the first line from `start` on that contains `text`, once it is printed."""

        def found() -> list[str]:
            return [line for line in self.lines[start:] if text in line or line == "(ended)"]

        with self._news:
            assert self._news.wait_for(found, 60), self.lines
            line = found()[0]
        assert text in line, self.lines
        return line

    def say(self, line: str) -> None:
        """Write a line to its standard input."""
        assert self.process.stdin
        self.process.stdin.write(f"{line}\n")
        self.process.stdin.flush()

    def stop(self) -> None:
        """End it with SIGINT."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(20)
            except subprocess.TimeoutExpired:
                self.process.kill()
                raise
        self._reader.join()
        assert self.process.stdout
        assert self.process.stdin
        self.process.stdout.close()
        self.process.stdin.close()


def free_port() -> int:
    """Return a port that nobody listens at."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port: int = free.getsockname()[1]
        return port


def environment(native: Native, *, apart: bool = False) -> dict[str, str]:
    """Return the variables for native processes of this test run.

    Those that are `apart` find one another and nobody else, though they are in the same domain.
    """
    found = native.environment | {"PYTHONUNBUFFERED": "1"}
    # Other ports.
    profiles = {"FASTDDS_DEFAULT_PROFILES_FILE": str(HERE / "apart.xml")} if apart else {}
    return found | profiles


class Gateway(Process):
    """A gateway that listens."""

    def __init__(self, *options: str | Path, folder: Path, apart: bool = False) -> None:
        native = Native()
        command = [native.python, "-m", "sitegen", "gateway", "--port", "0", *options]
        super().__init__(*command, env=environment(native, apart=apart), cwd=folder)
        match = ADDRESS.search(self.expect("localhost"))
        assert match
        self.port = int(match[2])
        self.url = match[0]

    @property
    def memory(self) -> int:
        """The memory that it has (bytes)."""
        text = Path(f"/proc/{self.process.pid}/statm").read_text()
        return int(text.split()[1]) * os.sysconf("SC_PAGE_SIZE")


@contextmanager
def gateway(*options: str | Path, folder: Path, apart: bool = False) -> Iterator[Gateway]:
    """Run a gateway."""
    running = Gateway(*options, folder=folder, apart=apart)
    try:
        yield running
    except BaseException:
        # pytest shows it beside what failed.
        print("the gateway printed:", *running.lines, sep="\n")
        raise
    finally:
        running.stop()


@contextmanager
def robot() -> Iterator[Process]:
    """Run the robot of ros2/robot.py."""
    native = Native()
    running = Process(native.python, HERE / "robot.py", env=environment(native))
    try:
        running.expect("ready")
        yield running
    finally:
        running.stop()


class Client:
    """A raw client of rosbridge."""

    def __init__(self, socket: aiohttp.ClientWebSocketResponse) -> None:
        self.socket = socket
        self.passed: list[dict[str, Any]] = []

    async def send(self, **message: Any) -> None:
        """Send an operation."""
        await self.socket.send_str(json.dumps(message))

    async def next(self) -> dict[str, Any]:
        """Return the next message; what is no JSON is {"op": "binary"} or {"op": "closed"}."""
        message = await self.socket.receive(timeout=30)
        if message.type == aiohttp.WSMsgType.TEXT:
            found: dict[str, Any] = json.loads(message.data)
            return found
        if message.type == aiohttp.WSMsgType.BINARY:
            return {"op": "binary", "data": message.data}
        return {"op": "closed", "code": self.socket.close_code, "reason": message.extra}

    async def until(self, op: str, **fields: Any) -> dict[str, Any]:
        """Return the next message of an operation with these fields; others are passed."""
        while True:
            try:
                message = await self.next()
            except asyncio.CancelledError:
                print(f"no {op} with {fields} after", *self.passed[-5:], sep="\n")
                raise
            if message["op"] == op and all(message.get(k) == v for k, v in fields.items()):
                return message
            assert message["op"] != "closed", (message, self.passed[-5:])
            self.passed.append(message)

    async def settle(self) -> None:
        """Wait until the robot hears this client and is heard: "/tell" comes back as "/heard"."""
        await self.send(op="subscribe", topic="/heard", type="std_msgs/String")
        await self.send(op="advertise", topic="/tell", type="std_msgs/msg/String")
        for number in range(100):
            await self.send(op="publish", topic="/tell", msg={"data": f"settled {number}"})
            with suppress(TimeoutError):
                async with asyncio.timeout(0.2):
                    await self.until("publish", topic="/heard", msg={"data": f"settled {number}"})
                    return
        raise AssertionError("the robot does not answer")

    async def call(self, service: str, args: Any = None, **more: Any) -> dict[str, Any]:
        """Call a service and return its response."""
        identity = f"call {service} {len(self.passed)}"
        await self.send(op="call_service", service=service, args=args or {}, id=identity, **more)
        return await self.until("service_response", id=identity)


@asynccontextmanager
async def client(running: Gateway, **options: Any) -> AsyncIterator[Client]:
    """Connect a raw client."""
    async with (
        aiohttp.ClientSession() as session,
        session.ws_connect(running.url, max_msg_size=0, **options) as socket,
    ):
        yield Client(socket)


def key(folder: Path, name: str = "Ada", seconds: float = 60) -> str:
    """Return a signed key."""
    secret = (folder / "gateway.secret").read_text().strip().encode()
    return signed(name, seconds, secret)


async def enter(page: Client, given: str) -> dict[str, Any]:
    """Give a key and return the answer."""
    await page.send(op="auth", key=given, id="auth")
    return await page.until("status", id="auth")


def run(work: Coroutine[Any, Any, Result], limit: float = 20) -> Result:
    """Run a coroutine within `limit` seconds, in a thread: Playwright's loop runs in this one."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, asyncio.wait_for(work, limit)).result()
