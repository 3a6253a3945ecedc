"""Open a built site in Chromium from a plain local server."""

from __future__ import annotations

import gzip
import os
import sys
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache, partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from playwright.sync_api import Browser, sync_playwright

from sitegen.commands.build import build
from sitegen.commands.serve.ranges import asked_part, read_part
from sitegen.report import Report, Style

CHROMIUM = os.environ.get("CHROMIUM", "/usr/bin/chromium")
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
# The page's own part of the measurements, served below /bench/.
PARTS = Path(__file__).parent / "page"
ISOLATION = {
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Embedder-Policy": "require-corp",
}


class Progress(Report):
    """Says only what is compiled, and that beside the figures."""

    def __init__(self) -> None:
        super().__init__(sys.stderr)

    def say(self, line: str, style: Style = "") -> None:
        """Leave the summary of a build out."""


@contextmanager
def chromium() -> Iterator[Browser]:
    """Run Chromium without a window."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        try:
            yield browser
        finally:
            browser.close()


@contextmanager
def serving_site(folder: Path, *, isolated: bool = False, hosted: bool = False) -> Iterator[str]:
    """Build the site of `folder`, with the nodes that are compiled already, and serve it."""
    with tempfile.TemporaryDirectory() as temporary:
        output = Path(temporary) / "dist"
        build(folder, output=output, report=Progress())
        with serving(output, isolated=isolated, hosted=hosted) as url:
            yield url


@contextmanager
def serving(
    folder: Path,
    *,
    isolated: bool = False,
    hosted: bool = False,
    asked: set[str] | None = None,
) -> Iterator[str]:
    """Serve `folder`, and PARTS below /bench/; note in `asked` the paths that are asked for.

    An `isolated` page has a clock of 5 µs; that of other pages steps by 100 µs. A `hosted` one is
    served as by GitHub Pages: compressed, to be kept for ten minutes.
    """
    headers = ISOLATION if isolated else {}
    handler = partial(_Handler, headers=headers, hosted=hosted, asked=asked, directory=str(folder))
    server = _Server(("127.0.0.1", 0), handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.05,))
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


class _Server(ThreadingHTTPServer):
    # A page asks for more files at once than the five that may wait by default.
    request_queue_size = 128


class _Handler(SimpleHTTPRequestHandler):
    # Connections stay open, as those of any real server do.
    protocol_version = "HTTP/1.1"
    # The machine's own table may call these text/plain, and browsers refuse such modules.
    extensions_map = {  # noqa: RUF012
        **SimpleHTTPRequestHandler.extensions_map,
        ".js": "text/javascript",
        ".wasm": "application/wasm",
        ".svg": "image/svg+xml",
    }

    def __init__(
        self,
        *args: object,
        headers: dict[str, str],
        hosted: bool,
        asked: set[str] | None,
        directory: str,
    ) -> None:
        self._headers = headers
        self._hosted = hosted
        self._asked = asked
        super().__init__(*args, directory=directory)  # type: ignore[arg-type]

    def translate_path(self, path: str) -> str:
        if self._asked is not None:
            self._asked.add(path.partition("?")[0])
        name = path.removeprefix("/bench/")
        return str(PARTS / name) if name != path else super().translate_path(path)

    def do_GET(self) -> None:
        file = Path(self.translate_path(self.path))
        file = file / "index.html" if self.path.endswith("/") else file
        size = file.stat().st_size if file.is_file() else 0
        if part := asked_part(self.headers.get("Range", ""), size):
            self.send_response(HTTPStatus.PARTIAL_CONTENT)
            self.send_header("Content-Range", f"bytes {part.start}-{part.stop - 1}/{size}")
            self.send_header("Content-Length", str(len(part)))
            self.end_headers()
            self.wfile.write(read_part(file, part))
            return
        if not self._hosted or not file.is_file():
            super().do_GET()
            return
        content = _zipped(file)
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", self.guess_type(str(file)))
        self.send_header("Content-Encoding", "gzip")
        self.send_header("Content-Length", str(len(content)))
        self.send_header("Cache-Control", "max-age=600")
        self.end_headers()
        self.wfile.write(content)

    def end_headers(self) -> None:
        for name, value in self._headers.items():
            self.send_header(name, value)
        super().end_headers()

    def log_message(self, format: str, *args: object) -> None:
        pass


@cache
def _zipped(file: Path) -> bytes:
    return gzip.compress(file.read_bytes())
