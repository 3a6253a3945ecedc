"""Fetching from servers that are well, slow, broken, or mean."""

from __future__ import annotations

import hashlib
import threading
import time
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from sitegen.cache.fetch import FetchError, Patience, allowed, fetch

DATA = b"an archive of nodes" * 1000
HASH = hashlib.sha256(DATA).hexdigest()
# Enough for any machine, and no time to lose.
SOON = Patience(connection=20, bytes=20, total=60, tries=3, pause=0.01)

Answer = Callable[[BaseHTTPRequestHandler, int], None]
Server = Callable[[Answer], str]


@pytest.fixture
def server() -> Iterator[Server]:
    """A function that serves what an answer says, which is told how often it was asked before."""
    servers: list[ThreadingHTTPServer] = []

    def serve(answer: Answer) -> str:
        asked = iter(range(1000))

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                answer(self, next(asked))

            def log_message(self, *_: object) -> None:
                pass

        servers.append(ThreadingHTTPServer(("127.0.0.1", 0), Handler))
        threading.Thread(target=servers[-1].serve_forever, daemon=True).start()
        return f"http://127.0.0.1:{servers[-1].server_port}/nodes.zip"

    yield serve
    for each in servers:
        each.shutdown()
        each.server_close()


def send(
    handler: BaseHTTPRequestHandler, data: bytes = DATA, status: int = 200, **more: str
) -> None:
    handler.send_response(status)
    for name, value in more.items():
        handler.send_header(name, value)
    handler.send_header("Content-Length", str(len(data)))
    handler.end_headers()
    handler.wfile.write(data)


def get(url: str, tmp_path: Path, *, largest: int = 10**6, patience: Patience = SOON) -> bytes:
    fetch(url, HASH, tmp_path / "got", largest=largest, patience=patience)
    return (tmp_path / "got").read_bytes()


def test_a_file_with_the_right_hash(server: Server, tmp_path: Path) -> None:
    assert get(server(lambda handler, _: send(handler)), tmp_path) == DATA


def test_another_file_is_told_with_its_hash(server: Server, tmp_path: Path) -> None:
    url = server(lambda handler, _: send(handler, b"other"))
    other = hashlib.sha256(b"other").hexdigest()
    with pytest.raises(FetchError) as caught:
        get(url, tmp_path)
    assert str(caught.value) == (
        f"{url} does not have the expected hash; if you trust it, write 'sha256: {other}'"
    )


@pytest.mark.parametrize("status", [429, 500, 503])
def test_what_passes_is_tried_again(status: int, server: Server, tmp_path: Path) -> None:
    asked: list[float] = []

    def answer(handler: BaseHTTPRequestHandler, before: int) -> None:
        asked.append(time.monotonic())
        send(handler, status=200 if before == 2 else status)

    patience = Patience(connection=20, bytes=20, total=60, tries=3, pause=0.2)
    assert get(server(answer), tmp_path, patience=patience) == DATA
    assert asked[1] - asked[0] >= 0.2
    assert asked[2] - asked[1] >= 0.4


def test_a_server_that_stays_broken(server: Server, tmp_path: Path) -> None:
    asked: list[int] = []

    def answer(handler: BaseHTTPRequestHandler, before: int) -> None:
        asked.append(before)
        send(handler, status=500)

    url = server(answer)
    with pytest.raises(FetchError) as caught:
        get(url, tmp_path)
    answered = "the server answered 500 Internal Server Error (tried 3 times)"
    assert str(caught.value) == f"{url}: {answered}; try again later"
    assert asked == [0, 1, 2]


def test_what_is_not_there_is_asked_for_once(server: Server, tmp_path: Path) -> None:
    asked: list[int] = []

    def answer(handler: BaseHTTPRequestHandler, before: int) -> None:
        asked.append(before)
        send(handler, status=404)

    url = server(answer)
    with pytest.raises(FetchError, match="answered 404 Not Found; check the address"):
        get(url, tmp_path)
    assert asked == [0]


def test_a_connection_that_breaks_is_made_anew(server: Server, tmp_path: Path) -> None:
    def answer(handler: BaseHTTPRequestHandler, before: int) -> None:
        if before == 0:
            handler.send_response(200)
            handler.send_header("Content-Length", str(len(DATA)))
            handler.end_headers()
            handler.wfile.write(DATA[:100])
        else:
            send(handler)

    assert get(server(answer), tmp_path) == DATA


def test_no_server_at_all(tmp_path: Path) -> None:
    idle = ThreadingHTTPServer(("127.0.0.1", 0), BaseHTTPRequestHandler)
    idle.server_close()
    with pytest.raises(FetchError, match=r"\(tried 3 times\); try again later"):
        get(f"http://127.0.0.1:{idle.server_port}/", tmp_path)


@pytest.mark.parametrize("honest", [True, False])
def test_more_than_expected(honest: bool, server: Server, tmp_path: Path) -> None:
    sent = [0]

    def answer(handler: BaseHTTPRequestHandler, _: int) -> None:
        handler.send_response(200)
        if honest:
            handler.send_header("Content-Length", str(10**9))
        handler.end_headers()
        try:
            while sent[0] < 10**9:
                sent[0] += handler.wfile.write(bytes(100_000))
        except OSError:
            pass

    with pytest.raises(FetchError, match="has more than 1,000,000 bytes; check the address"):
        get(server(answer), tmp_path)
    assert sent[0] < 10**9


def test_a_server_that_says_nothing(server: Server, tmp_path: Path) -> None:
    over = threading.Event()

    def answer(*_: object) -> None:
        over.wait(60)

    patience = Patience(connection=20, bytes=0.2, total=60, tries=2, pause=0.01)
    try:
        with pytest.raises(
            FetchError, match=r"the server did not answer in time \(tried 2 times\)"
        ):
            get(server(answer), tmp_path, patience=patience)
    finally:
        over.set()


def test_a_server_that_never_ends(server: Server, tmp_path: Path) -> None:
    over = threading.Event()

    def answer(handler: BaseHTTPRequestHandler, _: int) -> None:
        handler.send_response(200)
        handler.end_headers()
        try:
            while not over.wait(0.05):
                handler.wfile.write(b".")
        except OSError:
            pass

    patience = Patience(connection=20, bytes=20, total=0.5, tries=3, pause=0.01)
    try:
        with pytest.raises(FetchError, match=r"too slow, .* bytes in 0\.5 s"):
            get(server(answer), tmp_path, patience=patience)
    finally:
        over.set()


def leads(to: str) -> Answer:
    return lambda handler, _: send(handler, b"", 302, Location=to)


def test_redirections_stay_where_they_may(server: Server, tmp_path: Path) -> None:
    url = server(lambda handler, _: send(handler))
    assert get(server(leads(url)), tmp_path) == DATA
    with pytest.raises(
        FetchError, match=r"leads to http://example\.org/a; only https addresses are followed"
    ):
        get(server(leads("http://example.org/a")), tmp_path)
    with pytest.raises(FetchError):
        get(server(leads("file:///etc/passwd")), tmp_path)
    with pytest.raises(FetchError, match="redirects more than 5 times"):
        get(server(leads("/again")), tmp_path)


@pytest.mark.parametrize(
    ("url", "expected"),
    [
        ("https://example.org/a.zip", True),
        ("https://10.example.org/a.zip", True),
        ("http://localhost:8000/a.zip", True),
        ("http://127.0.0.1/a.zip", True),
        ("http://[::1]:1/a.zip", True),
        ("http://example.org/a.zip", False),
        ("http://127.0.0.1.example.org/a.zip", False),
        ("http://localhost@example.org/a.zip", False),
        ("http://192.168.0.1/a.zip", False),
        ("ftp://example.org/a.zip", False),
        ("file:///a.zip", False),
        ("https://", False),
        ("https://[", False),
    ],
)
def test_where_from(url: str, expected: bool) -> None:
    assert allowed(url) is expected
