"""What `sitegen serve` answers, and to whom."""

from __future__ import annotations

import json
import os
import signal
import socket
import struct
import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Callable
from http import HTTPStatus
from pathlib import Path

import pytest
from browser import Built, own_serving
from panel import Panel
from paths import ROOT
from playwright.sync_api import Page
from served import TEXT, Serving, edited_site

from sitegen.__main__ import main
from sitegen.commands.serve.server import _Handler
from sitegen.mediatype import media_type


def test_nobody_else_can_open_an_editor_or_read_the_site(
    site: Path, serving: Callable[[Path], Serving], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SITEGEN_EDITOR", "false")
    (site / "site.yaml").write_text("site: {}\n")
    served = serving(site)
    place = b"site.yaml:1"
    here = served.url.rstrip("/")
    for origin, body, status in (
        ("http://example.org", place, 403),
        (here, b"index.md:1", 404),
        (here, b"/etc/passwd:1", 404),
        (here, place * 1000, 403),
    ):
        headers = {"Origin": origin}
        request = urllib.request.Request(f"{served.url}_sitegen/open", body, headers)
        with pytest.raises(urllib.error.HTTPError, match=str(status)):
            urllib.request.urlopen(request)
    # Another name for this computer is one that another site has given it.
    request = urllib.request.Request(served.url, headers={"Host": "example.org"})
    with pytest.raises(urllib.error.HTTPError, match="421"):
        urllib.request.urlopen(request)


def test_a_folder_without_a_site_is_not_served(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["serve", str(tmp_path)]) == 1
    said = capsys.readouterr()
    assert "'sitegen init' for a workspace, 'sitegen new my_robot' to begin with" in said.err
    assert "http" not in said.out


def test_no_module_is_sent_twice_and_none_that_has_not_changed(
    tab: Page,
    tmp_path: Path,
    serving: Callable[[Path], Serving],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    answers: list[tuple[str, int]] = []

    def note(handler: _Handler, code: int, _: object = "-") -> None:
        answers.append((handler.path, code))

    monkeypatch.setattr(_Handler, "log_request", note)
    page = edited_site(tmp_path) / "page.md"
    page.write_text(TEXT.replace("- buttons: talker\n", ""))
    served = serving(page.parent)
    # The node starts by itself: the page preloads the modules that its worker imports.
    tab.goto(served.url)
    Panel(tab, "talker").wait_for("Hello, world! 1'")
    sent = [path for path, code in answers if code == HTTPStatus.OK]
    assert {path for path in sent if path.startswith(("/runtime/", "/nodes/"))}
    assert [path for path in set(sent) if sent.count(path) > 1 and path.endswith(".js")] == []
    answers.clear()
    tab.reload()
    Panel(tab, "talker").wait_for("Hello, world! 1'")
    again = {path for path, code in answers if code == HTTPStatus.OK}
    assert not {path for path in again if path.startswith(("/runtime/", "/nodes/"))}


def test_a_closed_tab_prints_nothing(
    site: Path, serving: Callable[[Path], Serving], capfd: pytest.CaptureFixture[str]
) -> None:
    served = serving(site)
    for _ in range(20):
        with socket.create_connection(("127.0.0.1", served.server.port)) as connection:
            connection.sendall(b"GET /index.html HTTP/1.1\r\nHost: localhost\r\n\r\nGET / HT")
            # Closing with this option resets the connection, as a browser that quits does.
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    with urllib.request.urlopen(served.url) as page:
        page.read()
    assert capfd.readouterr().err == ""


def test_every_file_is_sent_as_what_it_is(built: Built) -> None:
    suffixes = {file.suffix for file in built(ROOT).rglob("*") if file.is_file()} - {""}
    types = {suffix: media_type(f"file{suffix}") for suffix in suffixes}
    assert "application/octet-stream" not in types.values()
    assert {types[suffix] for suffix in (".js", ".mjs")} == {"text/javascript; charset=utf-8"}
    assert types[".wasm"] == "application/wasm"


@pytest.mark.parametrize(
    ("asked", "status", "content", "told"),
    [
        ("bytes=2-4", 206, b"cde", "bytes 2-4/10"),
        ("bytes=7-", 206, b"hij", "bytes 7-9/10"),
        ("bytes=8-99", 206, b"ij", "bytes 8-9/10"),
        ("bytes=0-0", 206, b"a", "bytes 0-0/10"),
        # What a server may ignore.
        *((asked, 200, b"abcdefghij", None) for asked in ("bytes=10-", "bytes=4-2", "bytes=-3")),
        *(
            (asked, 200, b"abcdefghij", None)
            for asked in ("bytes=1-2,4-5", "lines=1-2", "bytes=a-b")
        ),
    ],
)
def test_a_part_of_a_file_is_sent_on_request(
    tmp_path: Path, asked: str, status: int, content: bytes, told: str | None
) -> None:
    (tmp_path / "drive.mcap").write_bytes(b"abcdefghij")
    with own_serving(tmp_path) as url:
        request = urllib.request.Request(f"{url}drive.mcap", headers={"Range": asked})
        with urllib.request.urlopen(request) as answer:
            assert (answer.status, answer.read()) == (status, content)
            assert answer.headers["Content-Range"] == told


def test_a_port_in_use_is_left_to_who_has_it(site: Path) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with subprocess.Popen(
            [sys.executable, "-m", "sitegen", "serve", site, "--port", str(port)],
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | {"PYTHONUNBUFFERED": "1"},
        ) as process:
            assert process.stdout
            lines = []
            for line in process.stdout:
                lines.append(line)
                if "Ctrl-C" in line:
                    break
            assert f"port {port} is in use\n" in lines
            url = lines[-1].split()[0]
            assert url != f"http://localhost:{port}/"
            with urllib.request.urlopen(url) as page:
                assert b"The first text." in page.read()
            process.send_signal(signal.SIGINT)
            assert process.wait(10) == 0
    assert not (site / "dist").exists()


def test_nothing_outside_of_the_site_is_served(
    site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    for path in (
        "../site.yaml",
        "%2e%2e/site.yaml",
        "site.yaml",
        "_sitegen/server.py",
        "/etc/passwd",
    ):
        with pytest.raises(urllib.error.HTTPError, match="404"):
            urllib.request.urlopen(served.url + path)
    assert json.dumps(served.live.file("../site.yaml")) == "null"
