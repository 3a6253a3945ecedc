"""Serve a LiveSite on this computer, with live reload."""

from __future__ import annotations

import errno
import hashlib
import re
import sys
import threading
from collections.abc import Iterator
from functools import partial
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Protocol, Self
from urllib.parse import parse_qsl, quote, unquote, urlsplit

from sitegen import pagepath
from sitegen.commands.serve.editor import NoEditorError, open_editor
from sitegen.commands.serve.ranges import asked_part, read_part
from sitegen.errors import SiteError
from sitegen.mediatype import media_type
from sitegen.model import Artifact
from sitegen.shipped import RUNTIME
from sitegen.site import offline

# The folder of the files that the server adds to the site.
PREFIX = "_sitegen/"
HERE = Path(__file__).parent
NEWS = f"{PREFIX}news"
OPEN = f"{PREFIX}open"
OWN = {f"{PREFIX}{name}": HERE / name for name in ("follow.js", "follow.css", "update.js")}
OWN[f"{PREFIX}idiomorph.js"] = RUNTIME / "vendor" / "idiomorph.js"
BUILDS = re.compile(r"[0-9]{1,9}")
# The maximum size of a request for an editor (bytes).
LONGEST = 4096
FOLLOW = '<meta name="sitegen-builds" content="{builds}">'
FOLLOW += f'<script type="module" src="/{PREFIX}follow.js"></script>\n</head>'
WORKER = "sw.js"
# Browsers keep these files and ask whether they have changed: workers fetch modules that their
# page has loaded already. All else is not kept: going back in the history would show it unasked.
KEPT = ("runtime/", "nodes/")
# The number of ports to try, starting at the requested one.
TRIES = 20
# Shown with the problems before the first good build; afterwards, the site is shown.
NOTHING_YET = '<!doctype html><html lang="en" data-nothing-yet><head><title>sitegen</title></head>'
NOTHING_YET += "<body></body></html>"


class Served(Protocol):
    """What a server shows: for `sitegen serve`, a LiveSite."""

    # The folder that its 404.html assumes for the site.
    base: str
    # Whether its pages are isolated.
    isolated: bool

    @property
    def builds(self) -> int:
        """How often it was built."""

    def file(self, path: str) -> Artifact | None:
        """Return the file at `path` of the site."""

    def place(self, text: str) -> tuple[Path, int] | None:
        """Return the file and the line of the problem whose message begins with `text`, if any."""

    def news(self, engine: str, builds: int) -> Iterator[str]:
        """Yield server-sent events after so many builds, for a browser with `engine`."""


class Server:
    """A server on this computer that runs in threads of its own while its context is entered."""

    def __init__(self, live: Served, port: int) -> None:
        self._http = _listen(partial(_Handler, live), port)
        self.port = self._http.server_port
        self.url = f"http://localhost:{self.port}/"

    def __enter__(self) -> Self:
        threading.Thread(target=self._http.serve_forever, args=(0.05,), daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        self._http.shutdown()
        self._http.server_close()


class _Http(ThreadingHTTPServer):
    # A page requests more files at once than the default queue of five holds.
    request_queue_size = 128
    # Pages that wait for events do not keep the program running.
    daemon_threads = True
    # Otherwise a second server could use the same port, and one would hide the other.
    allow_reuse_port = False

    def handle_error(self, request: object, client_address: object) -> None:
        """Print the traceback of an error, unless a browser merely closed its connection."""
        if not isinstance(sys.exception(), (ConnectionError, TimeoutError)):
            super().handle_error(request, client_address)  # type: ignore[arg-type]


def _listen(handler: partial[_Handler], wanted: int) -> _Http:
    for port in range(wanted, wanted + TRIES):
        try:
            return _Http(("127.0.0.1", port), handler)
        except OSError as error:
            if error.errno != errno.EADDRINUSE:
                raise
    last = wanted + TRIES - 1
    raise SiteError([f"ports {wanted} to {last} are all in use; choose another with --port"])


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    # A connection on which nothing arrives is closed after this time (s).
    timeout = 30

    def __init__(self, live: Served, *args: object) -> None:
        self._live = live
        self._builds = 0
        super().__init__(*args)  # type: ignore[arg-type]

    def do_GET(self) -> None:
        if not _is_this_computer(self.headers.get("Host", "")):
            self.send_error(HTTPStatus.MISDIRECTED_REQUEST)
            return
        path = unquote(urlsplit(self.path).path)
        if self._live.base != "/" and path.startswith(self._live.base):
            self._redirect("/" + path.removeprefix(self._live.base))
            return
        path = path.removeprefix("/")
        # Before the file is read: of a build meanwhile, the page is told.
        self._builds = self._live.builds
        if path == NEWS:
            self._send_news(dict(parse_qsl(urlsplit(self.path).query)))
        elif path in OWN:
            self._send(path, OWN[path].read_bytes())
        else:
            self._send_file(path)

    def do_POST(self) -> None:
        """Open the author's editor at a problem that the page shows, and nowhere else."""
        host = self.headers.get("Host", "")
        ours = _is_this_computer(host) and self.headers.get("Origin") == f"http://{host}"
        length = self.headers.get("Content-Length", "")
        if not ours or self.path != f"/{OPEN}" or not length.isdecimal() or int(length) > LONGEST:
            self.close_connection = True
            self.send_error(HTTPStatus.FORBIDDEN)
            return
        asked = self.rfile.read(int(length)).decode(errors="replace")
        place = self._live.place(asked)
        try:
            if place is None:
                raise NoEditorError(f"{asked} is not a problem of this site")
            open_editor(*place)
        except NoEditorError as error:
            self._send("error.txt", str(error).encode(), HTTPStatus.NOT_FOUND)
        else:
            self._send("opened.txt", b"")

    def _send_file(self, path: str) -> None:
        path = pagepath.file_of(path)
        file = self._live.file(path)
        if file and isinstance(file.source, Path) and self._send_part(path, file.source):
            return
        if file:
            self._send(path, _bytes(file))
        elif path == WORKER:
            # Removes the service worker of a site that used this port before, which would serve its
            # pages.
            self._send(path, offline.RETIRED)
        elif self._live.file(pagepath.file_of(f"{path}/")):
            self._redirect(f"/{path}/")
        else:
            missing = self._live.file("404.html")
            content = _bytes(missing) if missing else NOTHING_YET.encode()
            self._send("404.html", content, HTTPStatus.NOT_FOUND)

    def _send_part(self, path: str, file: Path) -> bool:
        """Send the bytes of a file that the browser asks for; return whether it asks for some."""
        size = file.stat().st_size
        part = asked_part(self.headers.get("Range", ""), size)
        if part is None:
            return False
        content = read_part(file, part)
        self.send_response(HTTPStatus.PARTIAL_CONTENT)
        self.send_header("Content-Type", media_type(path))
        self.send_header("Content-Length", str(len(content)))
        self.send_header("Content-Range", f"bytes {part.start}-{part.stop - 1}/{size}")
        self.send_header("Cache-Control", "no-store")
        self._end_headers()
        self.wfile.write(content)
        return True

    def _redirect(self, path: str) -> None:
        self.send_response(HTTPStatus.FOUND)
        self.send_header("Location", quote(f"/{path.lstrip('/')}"))
        self.send_header("Content-Length", "0")
        self.end_headers()

    def _send(self, path: str, content: bytes, status: HTTPStatus = HTTPStatus.OK) -> None:
        suffix = Path(path).suffix
        if suffix == ".html":
            follow = FOLLOW.replace("{builds}", str(self._builds))
            content = content.replace(b"</head>", follow.encode(), 1)
        tag = self._tag(content) if status == HTTPStatus.OK and path.startswith(KEPT) else ""
        unchanged = tag and self.headers.get("If-None-Match") == tag
        self.send_response(HTTPStatus.NOT_MODIFIED if unchanged else status)
        self.send_header("Content-Type", media_type(path))
        self.send_header("Content-Length", str(len(content)))
        if tag:
            self.send_header("ETag", tag)
        self.send_header("Cache-Control", "no-cache" if tag else "no-store")
        self._end_headers()
        if not unchanged:
            self.wfile.write(content)

    def _end_headers(self) -> None:
        if self._live.isolated:
            self.send_header("Cross-Origin-Opener-Policy", "same-origin")
            self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        self.end_headers()

    def _tag(self, content: bytes) -> str:
        """Return a strong ETag; whether pages are isolated is part of the answer, too."""
        digest = hashlib.sha256(content).hexdigest()
        return f'"{digest}{"-isolated" if self._live.isolated else ""}"'

    def _send_news(self, asked: dict[str, str]) -> None:
        builds = asked.get("builds", "")
        after = int(builds) if BUILDS.fullmatch(builds) else self._live.builds
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", "text/event-stream")
        self.send_header("Cache-Control", "no-store")
        self.send_header("Connection", "close")
        self.end_headers()
        self.close_connection = True
        try:
            for event in self._live.news(asked.get("engine", ""), after):
                self.wfile.write(event.encode())
        except OSError:
            pass  # the page was closed

    def log_message(self, format: str, *args: object) -> None:
        pass


def _is_this_computer(host: str) -> bool:
    """Return whether a request names this computer as its host.

    Otherwise a page of another site could read drafts by resolving its own name to 127.0.0.1.
    """
    try:
        return urlsplit(f"//{host}").hostname in ("localhost", "127.0.0.1", "::1")
    except ValueError:
        return False


def _bytes(artifact: Artifact) -> bytes:
    source = artifact.source
    return source if isinstance(source, bytes) else source.read_bytes()
