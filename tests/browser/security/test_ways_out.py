"""A node tries every way out of its worker that browsers have."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
from browser import Scripted, Serve
from paths import ROOT, SUPPORT
from playwright.sync_api import Browser

from sitegen.commands.build import build
from sitegen.report import Report

RUNTIME = ROOT / "sitegen/runtime"
# The interfaces of workers that programs do not have.
CLOSED = Path(__file__).with_name("closed.txt")
# Those by which they would get out. Python itself defines some names of the others.
NEVER = [
    *("caches", "indexedDB", "CookieStore", "BroadcastChannel", "importScripts", "Worker"),
    *("SharedWorker", "XMLHttpRequest", "WebSocket", "EventSource", "WebTransport", "FontFace"),
    *("FileSystemHandle", "LockManager", "Notification", "RTCDataChannel", "GPU", "Scheduler"),
]
SITE = """\
site: {title: Ways out}
workspace: .
nodes:
  compiled: {package: cpp_hello, executable: talker}
  script: {ros2wasm: script.js, types: {/chatter: std_msgs/msg/String}}
  python: {package: py_ways, executable: ways}
pages:
  - path: /
    title: Nodes
    content:
      - console: compiled
      - console: script
      - console: python
      - markdown: |
          ```js ros
          console.log("open:");
          ```
"""
PYTHON = """\
import asyncio

import js

OTHER = "<other>"


async def closed(way):
    try:
        await way()
    except Exception as error:
        return True
    return False


async def ways():
    found = [name for name in "<closed>".split() if hasattr(js, name)]
    names = ("storage", "locks", "usb", "serial", "hid", "serviceWorker", "gpu", "permissions")
    found += [f"navigator.{name}" for name in names if hasattr(js.navigator, name)]
    for address in (OTHER, f"{js.origin}/neighbour/python"):
        if not await closed(lambda: js.fetch(address)):
            found.append(f"fetch {address}")
    await js.fetch(f"{js.origin}/site/page.json?guest")
    return found


def main():
    print("open:", *asyncio.run(ways()))
"""
# Driven by WebDriver, Firefox loses a worker of a worker now and then. WebKitGTK runs no Python
# in a plain page.
NODES = {
    "chromium": ["compiled", "script", "python"],
    "firefox": ["compiled", "python"],
    "webkit": ["compiled", "script"],
}
# Start nodes, and return what their consoles say is open.
RUN = """async (names) => {
  const main = await import(document.querySelector("script[type=module][src*=rosMain]").src);
  const found = () => names.map((name) =>
    document.querySelector(`[role=log][aria-label="${name}"]`));
  while (!main.ros || found().includes(null)) {
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  const { ros } = main;
  const consoles = found();
  for (const name of names) ros.nodes.get(name).start();
  const said = () => consoles.map((one) => one.textContent.match(/open:[^\\[\\n]*/)?.[0]);
  for (let tries = 0; tries < 600 && said().includes(undefined); tries += 1) {
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  return said().map((open, at) => open?.trim() ?? consoles[at].textContent);
}"""

# Run a text as a cell does, and return what it says is open.
RUN_CELL = """async (text) => {
  const { ros } = await import(document.querySelector("script[type=module][src*=rosMain]").src);
  const { widgets } = await (await fetch("page.json")).json();
  const { interfaces } = widgets.find(({ kind }) => kind === "javascript").options;
  const javascript = { text, imports: [], interfaces: new URL(interfaces, document.baseURI).href };
  const entry = { package: "sitegen", executable: "javascript", arguments: [], foreign: true };
  const cell = ros.run({ ...entry, javascript }, { name: "cell" });
  return new Promise((resolve) => {
    cell.addEventListener("state", () => cell.state === "failed" && resolve("failed"));
    const said = ({ detail }) => resolve(detail.map(({ text }) => text).join(" ").trim());
    cell.addEventListener("lines", said);
  });
}"""


@pytest.fixture
def page(browser_name: str, request: pytest.FixtureRequest) -> Iterator[Scripted]:
    """A page of any browser, whose console may show what was refused."""
    if browser_name == "webkit":
        yield request.getfixturevalue("window")
        return
    browser: Browser = request.getfixturevalue("browser")
    context = browser.new_context()
    yield context.new_page()
    context.close()


def listed() -> tuple[list[str], list[str]]:
    """Return the global names, and those of the navigator, that confine.js leaves to programs."""
    script = (RUNTIME / "workers/confine.js").read_text()
    globals_, navigators = (
        found.split() for found in re.findall(r"new Set\(`(.*?)`", script, re.S)
    )
    return globals_, navigators


def declared() -> set[str]:
    """Return the global names of workers that TypeScript knows, from the browsers' own lists."""
    (library,) = (ROOT / "node_modules/@typescript").glob("*/lib/lib.webworker.d.ts")
    text = library.read_text(encoding="utf-8")
    return set(re.findall(r"^declare (?:var|let|const|function) (\w+)", text, re.M))


def test_each_interface_of_the_platform_is_open_or_closed_on_purpose() -> None:
    """A new one is closed by confine.js; closed.txt says that somebody has looked at it."""
    left, _ = listed()
    closed = set(CLOSED.read_text().split())
    assert closed == declared() - set(left)


class Home:
    """The server of the site, below /site/, with what visitors' programs ask it for."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        # The address and the cookies of each request.
        self.asked: list[tuple[str, str]] = []

    @contextmanager
    def serving(self) -> Iterator[str]:
        asked, folder = self.asked, str(self.folder)

        class Handler(SimpleHTTPRequestHandler):
            extensions_map = {  # noqa: RUF012
                **SimpleHTTPRequestHandler.extensions_map,
                ".js": "text/javascript",
                ".wasm": "application/wasm",
            }

            def __init__(self, *args: Any) -> None:
                super().__init__(*args, directory=folder)

            def translate_path(self, path: str) -> str:
                return super().translate_path(path.removeprefix("/site"))

            def do_GET(self) -> None:
                asked.append((self.path, self.headers.get("Cookie", "")))
                super().do_GET()

            def do_POST(self) -> None:
                asked.append((self.path, self.headers.get("Cookie", "")))
                self.send_error(405)

            def log_message(self, format: str, *args: object) -> None:
                pass

        with _running(Handler) as port:
            yield f"http://127.0.0.1:{port}/site/"


class Elsewhere:
    """A server of somebody else, which lets every page read it."""

    def __init__(self) -> None:
        self.asked: list[str] = []

    @contextmanager
    def serving(self) -> Iterator[str]:
        asked = self.asked

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                asked.append(self.path)
                self.send_response(200)
                self.send_header("Access-Control-Allow-Origin", "*")
                self.send_header("Content-Type", "text/javascript")
                self.end_headers()

            do_POST = do_OPTIONS = do_GET

            def log_message(self, format: str, *args: object) -> None:
                pass

        with _running(Handler) as port:
            yield f"http://127.0.0.1:{port}/"


@contextmanager
def _running(handler: type[BaseHTTPRequestHandler]) -> Iterator[int]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    # A browser may keep its connections.
    server.block_on_close = False
    thread = Thread(target=server.serve_forever)
    thread.start()
    try:
        yield server.server_port
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


def ways_out(other: str) -> str:
    """Return the script that tries every way, for a server of somebody else."""
    script = (SUPPORT / "peers/waysOut.js").read_text().replace("<other>", other)
    # A classic script has its own functions among the global names, and may load others.
    own = ["answered", "importScripts", "left", "opened", "tryAll"]
    return script.replace("<left>", " ".join([*listed()[0], *listed()[1], *own]))


def hostile(folder: Path, other: str) -> Path:
    """Build a site whose nodes are written to get out to another server, and return it."""
    shutil.copytree(ROOT / "demos/demo01/src", folder / "src")
    ways = ways_out(other)
    package = folder / "src/py_ways"
    package.mkdir(parents=True)
    (package / "py_ways").mkdir()
    (package / "py_ways/__init__.py").write_text("")
    program = PYTHON.replace("<other>", other).replace("<closed>", " ".join(NEVER))
    (package / "py_ways/ways.py").write_text(program)
    (package / "package.xml").write_text(
        "<package format='3'><name>py_ways</name><version>1.0.0</version><description/>"
        "<maintainer email='a@b.c'>a</maintainer><license>Apache-2.0</license>"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    (package / "setup.py").write_text(
        "from setuptools import setup\n"
        "setup(name='py_ways', version='1.0.0', packages=['py_ways'],\n"
        "      entry_points={'console_scripts': ['ways = py_ways.ways:main']})\n"
    )
    (package / "setup.cfg").write_text("")
    (folder / "script.js").write_text(
        f"{ways}\ntryAll().then((open) => postMessage({{ command: 'console', message: open }}));\n"
    )
    (folder / "site.yaml").write_text(SITE)
    dist = folder / "dist"
    build(folder, output=dist, report=Report())
    # Somebody compiled it elsewhere, and put this into its script.
    says = "postMessage({ op: 'lines', lines: [{ severity: 'stdout', text: open }] })"
    for glue in (dist / "nodes").glob("**/talker.*.js"):
        glue.write_text(f"{ways}\ntryAll().then((open) => {says});\n{glue.read_text()}")
    return dist


@pytest.mark.firefox(always=True)
@pytest.mark.webkit(always=True)
def test_no_program_reaches_another_server_or_the_storage_of_the_site(
    page: Scripted, tmp_path: Path, browser_name: str
) -> None:
    names = NODES[browser_name]
    elsewhere = Elsewhere()
    with elsewhere.serving() as other:
        home = Home(hostile(tmp_path / "site", other))
        with home.serving() as url:
            page.goto(url)
            page.evaluate("() => { document.cookie = 'visitor=1; path=/'; }")
            page.goto(f"{url}?again")
            found = page.evaluate(RUN, names)
            script = f"{ways_out(other)}\ntryAll().then((open) => console.log(open));"
            found.append(page.evaluate(RUN_CELL, script))
    assert found == ["open:"] * (len(names) + 1)
    assert elsewhere.asked == []
    # A program reads files of its site, not in the name of the visitor, and nothing beside it.
    assert {cookies for path, cookies in home.asked if path.endswith("?guest")} == {""}
    assert any("visitor=1" in cookies for _, cookies in home.asked)
    outside = [path for path, _ in home.asked if not path.startswith("/site/")]
    assert [path for path in outside if path != "/favicon.ico"] == []
    assert [path for path, _ in home.asked if "change" in path or "socket" in path] == []


@pytest.mark.chromium
def test_the_list_of_ways_is_real(page: Scripted, serve: Serve, tmp_path: Path) -> None:
    """In a worker without a policy and with all of the browser, most of these ways are open."""
    elsewhere = Elsewhere()
    with elsewhere.serving() as other:
        ways = ways_out(other)
        (tmp_path / "worker.js").write_text(f"{ways}\ntryAll().then((open) => postMessage(open));")
        (tmp_path / "index.html").write_text("<!DOCTYPE html><link rel=icon href=data:,>")
        page.goto(serve(tmp_path))
        found = page.evaluate(
            """() => new Promise((resolve) => {
              new Worker("worker.js", { type: "module" }).onmessage = ({ data }) => resolve(data);
            })"""
        )
    names = set(found.removeprefix("open: ").split())
    assert {"fetch", "import", "xhr", "worker", "indexedDB", "BroadcastChannel"} <= names, found
    assert elsewhere.asked != [], json.dumps(found)
