"""Open built pages in real browsers: a plain web server, and what Playwright drives."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, Protocol

from playwright.sync_api import Browser, ConsoleMessage, Page, sync_playwright

from sitegen.commands.serve.server import Server
from sitegen.model import Artifact

# What the fixture `serve` is: it takes a folder and a prefix, and gives the URL.
Serve = Callable[..., str]
# What the fixture `built` is: it takes the folder of a site and gives that of the built one.
Built = Callable[[Path], Path]


class Scripted(Protocol):
    """A tab or a window of any browser: it goes to pages and runs scripts there."""

    def goto(self, url: str) -> object: ...

    def evaluate(self, expression: str, argument: Any = None, /) -> Any: ...


# A slow machine is no fault of what is tested: what is waited for may take its time (ms).
TIMEOUT = 60_000
# A browser that lacks JSPI gets the other build of each node.
WITHOUT_JSPI = "delete WebAssembly.Suspending; delete WebAssembly.promising;\n"
CHROMIUM = os.environ.get("CHROMIUM", "/usr/bin/chromium-headless-shell")
# All of it: without its window, it keeps no pages that were left.
WHOLE_CHROMIUM = "/usr/bin/chromium"
FIREFOX = os.environ.get("FIREFOX", "/usr/bin/firefox-esr")
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    # Linux is where it has to be asked for.
    "--enable-blink-features=WebBluetooth",
]


@contextmanager
def running(name: str) -> Iterator[Browser]:
    """Run Chromium or Firefox without a window."""
    with sync_playwright() as playwright:
        if name == "firefox":
            # This channel is the stock Firefox, driven by WebDriver BiDi.
            browser = playwright.firefox.launch(executable_path=FIREFOX, channel="moz-firefox")
        else:
            browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        with _patient(browser):
            yield browser


@contextmanager
def resolving(browser: Browser, name: str) -> Iterator[Browser]:
    """Run Chromium beside the one that runs, and let it find this computer by a name of its own."""
    flag = f"--host-resolver-rules=MAP {name} 127.0.0.1"
    found = browser.browser_type.launch(executable_path=CHROMIUM, args=[*FLAGS, flag])
    with _patient(found):
        yield found


@contextmanager
def _patient(browser: Browser) -> Iterator[None]:
    """Let each page wait as long as `expect` does, twice the default; in the end, close all."""

    def patient(create: Callable[..., Any]) -> Callable[..., Any]:
        def created(*args: object, **options: object) -> Any:
            made = create(*args, **options)
            made.set_default_timeout(TIMEOUT)
            return made

        return created

    browser.new_context = patient(browser.new_context)  # type: ignore[method-assign]
    browser.new_page = patient(browser.new_page)  # type: ignore[method-assign]
    try:
        yield
    finally:
        browser.close()


@contextmanager
def whole(browser: Browser) -> Iterator[Browser]:
    """Run all of Chromium beside the one without its window; another browser is all there is.

    Without the window, a program that reads outside of its memory ends its page.
    """
    if browser.browser_type.name != "chromium":
        yield browser
        return
    found = browser.browser_type.launch(executable_path=WHOLE_CHROMIUM, args=FLAGS)
    with _patient(found):
        yield found


@contextmanager
def opened(browser: Browser) -> Iterator[Page]:
    """Open an empty tab; at the end, its console must not have shown an error."""
    context = browser.new_context()
    errors: list[str] = []
    tab = context.new_page()

    def note(message: ConsoleMessage) -> None:
        if message.type == "error":
            errors.append(message.text)

    tab.on("console", note)
    tab.on("pageerror", lambda error: errors.append(str(error)))
    yield tab
    context.close()
    assert errors == []


@contextmanager
def serving(
    folder: Path, prefix: str = "/", port: int = 0, *, asked: list[str] | None = None
) -> Iterator[str]:
    """Serve `folder` below `prefix` as GitHub Pages would, without special headers.

    With `asked`, which gets the path of each request, browsers may keep files for ten minutes.
    """
    handler = partial(_Handler, prefix=prefix, asked=asked, directory=str(folder))
    server = _Server(("127.0.0.1", port), handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.05,))
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}{prefix}"
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


@contextmanager
def own_serving(folder: Path, prefix: str = "/") -> Iterator[str]:
    """Serve `folder` with the server of `sitegen serve`."""
    with Server(_Folder(folder), 0) as server:
        yield f"http://127.0.0.1:{server.port}{prefix}"


class _Folder:
    """A built site, which does not change."""

    base = "/"
    isolated = False
    builds = 1

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def file(self, path: str) -> Artifact | None:
        file = self._folder / path
        return Artifact(path, file) if file.is_file() else None

    def place(self, text: str) -> tuple[Path, int] | None:
        return None

    def news(self, engine: str, builds: int) -> Iterator[str]:
        # There is none, which is waited for as long as the page is open.
        while True:
            yield ":\n\n"
            time.sleep(1)


class _Server(ThreadingHTTPServer):
    # A page asks for more files at once than the five that may wait by default.
    request_queue_size = 128


class _Handler(SimpleHTTPRequestHandler):
    # The machine's own table may call these text/plain, and browsers refuse such modules.
    extensions_map = {  # noqa: RUF012
        **SimpleHTTPRequestHandler.extensions_map,
        ".js": "text/javascript",
        ".wasm": "application/wasm",
        ".svg": "image/svg+xml",
    }

    def __init__(self, *args: object, prefix: str, asked: list[str] | None, directory: str) -> None:
        self._prefix = prefix
        self._asked = asked
        super().__init__(*args, directory=directory)  # type: ignore[arg-type]

    def end_headers(self) -> None:
        if self._asked is not None:
            self._asked.append(self.path.removeprefix(self._prefix))
            self.send_header("Cache-Control", "max-age=600")
        super().end_headers()

    def translate_path(self, path: str) -> str:
        # Nothing lies outside the prefix, so links that leave it are found.
        inside = path.startswith(self._prefix)
        return super().translate_path(path[len(self._prefix) :] if inside else "/outside/prefix")

    def send_error(self, code: int, *rest: str | None) -> None:
        missing = Path(self.directory, "404.html")
        if code != HTTPStatus.NOT_FOUND or not missing.is_file():
            super().send_error(code, *rest)
            return
        self.send_response(code)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        self.wfile.write(missing.read_bytes())

    def log_message(self, format: str, *args: object) -> None:
        pass
