"""One set of scenarios for rowe in Python, JavaScript and C: each as a server, each as a client."""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from itertools import product
from pathlib import Path

import pytest
from paths import ROOT
from roweprograms import PROGRAMS, compiled
from websockets.exceptions import ConnectionClosedError, InvalidHandshake
from websockets.sync.client import ClientConnection, connect

LANGUAGES = ("python", "javascript", "c")
EXPECTED = [
    ["sum", 42],
    ["order", True],
    ["silence", "timeout"],
    ["asked", 21],
    ["expired", 2],
    ["echo", {"text": "ü€😀\n", "deep": [[{"a": None}]], "number": -0.5, "flag": True}],
    ["broadcast", [1, 1]],
    ["threads", 100],
    ["discarded", False],
    "leave",
    ["vanished", "timeout"],
    "return",
    ["returned", 3],
]
VALGRIND = [
    *("valgrind", "-q", "--error-exitcode=9", "--leak-check=full", "--show-leak-kinds=all"),
    f"--suppressions={PROGRAMS / 'valgrind.supp'}",
]


@pytest.fixture(scope="module")
def commands(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[str]]:
    """The beginning of the command line of each language's program."""
    program = compiled(tmp_path_factory.mktemp("rowe"), "program")
    return {
        "python": [sys.executable, str(PROGRAMS / "program.py")],
        "javascript": ["node", str(PROGRAMS / "program.mjs")],
        "c": [str(program)],
    }


@contextmanager
def running(command: list[str], *arguments: object) -> Iterator[subprocess.Popen[str]]:
    process = subprocess.Popen(
        [*command, *map(str, arguments)],
        cwd=ROOT,
        env=None,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        bufsize=1,
    )
    with process:
        try:
            yield process
        finally:
            process.kill()


@contextmanager
def serving(command: list[str], port: int = 0) -> Iterator[tuple[subprocess.Popen[str], int]]:
    with running(command, "serve", port) as server:
        assert server.stdout
        yield server, int(server.stdout.readline())


def play(client_command: list[str], server_command: list[str]) -> tuple[list[object], int]:
    """Return what the client printed, and its exit code. The server leaves, and comes back."""
    found: list[object] = []
    with serving(server_command) as (server, port), running(client_command, "play", port) as client:
        assert client.stdout
        assert client.stdin
        for line in client.stdout:
            found.append(json.loads(line) if line.startswith("[") else line.strip())
            if found[-1] == "leave":
                server.kill()
                server.wait()
                client.stdin.write("\n")
            elif found[-1] == "return":
                break
        with serving(server_command, port):
            found += [json.loads(line) for line in client.stdout]
        return found, client.wait(20)


@pytest.mark.parametrize(("client", "server"), [*product(LANGUAGES, LANGUAGES)])
def test_each_language_with_each(commands: dict[str, list[str]], client: str, server: str) -> None:
    assert play(commands[client], commands[server]) == (EXPECTED, 0)


def test_c_under_valgrind_as_a_client(commands: dict[str, list[str]]) -> None:
    assert play([*VALGRIND, *commands["c"]], commands["python"]) == (EXPECTED, 0)


def odd(socket: ClientConnection) -> None:
    """Send what is not a message of rowe, and then one that is."""
    for text in (
        "x",
        "[]",
        '{"message_id": 1}',
        '{"time_to_live": -1}',
        '{"a": NaN}',
        '{"a": ' + "[" * 200 + "]" * 200 + "}",
        "[" * 100_000,
        b"{}",
        '{"in_reply_to": "nobody"}',
        '{"a": "' + "x" * 1_000_000 + '"}',
    ):
        socket.send(text)
    assert json.loads(socket.recv(20))["a"].startswith("xxx")
    deep = '{"a": ' + "[" * 99 + "]" * 99 + "}"
    socket.send(deep)
    assert json.loads(socket.recv(20)) == json.loads(deep)


def test_c_under_valgrind_as_a_server(commands: dict[str, list[str]]) -> None:
    with serving([*VALGRIND, *commands["c"]]) as (server, port):
        url = f"ws://127.0.0.1:{port}/?name=odd%20one"
        with connect(url) as socket:
            odd(socket)
        with connect(url) as socket, pytest.raises(ConnectionClosedError):
            socket.send('{"a": "' + "x" * 1_100_000 + '"}')
            socket.recv(20)
        with connect(url) as socket:
            socket.send('{"message_id": "1", "do": "add", "a": 38, "b": 4}')
            assert json.loads(socket.recv(20)) == {"in_reply_to": "1", "sum": 42}
            socket.send('{"do": "ask"}')
            socket.recv(20)
        assert server.stdout
        assert server.stdout.readline() == "gone\n"
        with connect(url) as socket:
            socket.send('{"do": "end"}')
            assert server.wait(20) == 0


@pytest.mark.parametrize("language", LANGUAGES)
def test_bad_input_is_dropped(commands: dict[str, list[str]], language: str) -> None:
    with serving(commands[language]) as (_, port):
        url = f"ws://127.0.0.1:{port}"
        # What no URL has may be refused, but ends no program.
        for path in ("//", "/?name=%zz&name"):
            with suppress(InvalidHandshake), connect(url + path):
                pass
        with connect(f"{url}/") as socket:
            odd(socket)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_peer_that_vanishes_ends_the_call_to_it(
    commands: dict[str, list[str]], language: str
) -> None:
    with serving(commands[language]) as (server, port):
        assert server.stdout
        with connect(f"ws://127.0.0.1:{port}/") as socket:
            socket.send('{"do": "ask"}')
            assert json.loads(socket.recv(5))["number"] == 20
        assert server.stdout.readline() == "gone\n"


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_peer_that_never_reads_takes_no_memory(
    commands: dict[str, list[str]], language: str
) -> None:
    """It is sent 300 MB in parts of a megabyte; its queue holds 64 of them."""
    with serving(commands[language]) as (server, port):
        url = f"ws://127.0.0.1:{port}/"
        with connect(url, max_queue=1) as deaf, connect(url) as other:
            for _ in range(300):
                deaf.send('{"a": "' + "x" * 1_000_000 + '"}')
            other.send('{"message_id": "1", "do": "add", "a": 38, "b": 4}')
            assert json.loads(other.recv(20))["sum"] == 42
            status = Path(f"/proc/{server.pid}/status").read_text()
            resident = next(line for line in status.splitlines() if line.startswith("VmHWM"))
            assert int(resident.split()[1]) < 400_000


def test_the_queue_in_c(tmp_path: Path) -> None:
    program = str(compiled(tmp_path, "queue_test"))
    found = subprocess.run([program], check=True, stdout=subprocess.PIPE).stdout
    agrees, expires, few, many = json.loads(found)
    assert agrees
    assert expires
    # A million items do not fit into the caches of a processor, ten thousand do.
    assert many < 6 * few, f"{few:.3f} µs and {many:.3f} µs"
    subprocess.run([*VALGRIND, program, "few"], check=True, stdout=subprocess.DEVNULL)


QUEUE = """
import { ExpiringQueue } from "./sitegen/clients/rowe/expiringQueue.js";
function microseconds(count) {
  const queue = new ExpiringQueue(() => {}, count + 1);
  for (let number = 0; number < count; number += 1) queue.put(number, 100 + (number % 1000));
  let best = Infinity;
  for (let turn = 0; turn < 30; turn += 1) {
    const begun = performance.now();
    for (let number = 0; number < 1000; number += 1) {
      queue.put(number, 100 + number);
      queue.take();
    }
    best = Math.min(best, (performance.now() - begun) / 2);
  }
  return best;
}
microseconds(10_000);
console.log(JSON.stringify([microseconds(10_000), microseconds(1_000_000)]));
"""


def test_the_queue_in_javascript() -> None:
    node = ["node", "--input-type=module", "--eval", QUEUE]
    found = subprocess.run(node, cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout
    few, many = json.loads(found)
    assert many < 6 * few, f"{few:.3f} µs and {many:.3f} µs"


@pytest.mark.parametrize("language", ["python", "c"])
def test_more_than_a_queue_holds_waits_in_the_socket(
    commands: dict[str, list[str]], language: str
) -> None:
    """The program rests while twice as many requests arrive as its queue holds."""
    count = 20_000
    with serving(commands[language]) as (_, port), connect(f"ws://127.0.0.1:{port}/") as socket:
        socket.send('{"do": "rest", "seconds": 1}')

        def send() -> None:
            for number in range(count):
                request = {"message_id": str(number), "do": "add", "a": number, "b": 0}
                socket.send(json.dumps(request))

        sending = threading.Thread(target=send)
        sending.start()
        sums = [json.loads(socket.recv(30))["sum"] for _ in range(count)]
        sending.join()
        assert sums == list(range(count))
