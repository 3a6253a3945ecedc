"""Pages that share memory with their nodes, and Python in browsers without JSPI."""

from __future__ import annotations

import io
import shutil
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import WITHOUT_JSPI, Serve, serving
from native import Native
from panel import Panel, expect_nothing_left
from playwright.sync_api import Browser, Page, expect
from webkit import Window, WindowPanel

from sitegen.commands.build import build
from sitegen.commands.serve.live import LiveSite
from sitegen.commands.serve.server import Server
from sitegen.report import Report
from tests.native.test_rclpy import SITE, printed, run, run_both
from tests.site.test_offline import READY, until

PROMPT = """
  - path: prompt/
    title: Prompt
    nodes: {shell: {package: sitegen, executable: prompt}}
    content: [{prompt: shell}]
"""
# Notes how often a page is loaded, and what it says before it is loaded once more.
LISTEN = """if (window === top) {
  sessionStorage.setItem("loads", 1 + Number(sessionStorage.getItem("loads")));
  new MutationObserver(() => {
    const word = document.querySelector(".ros-word");
    if (word) sessionStorage.setItem("said", word.textContent);
  }).observe(document, { subtree: true, childList: true });
}"""


def make(folder: Path, keys: str) -> Path:
    """Build the site of test_rclpy.py with more keys, and return where it is."""
    shutil.copytree(SITE, folder)
    config = folder / "site.yaml"
    config.write_text(config.read_text().replace("site:\n", f"site:\n  {keys}\n", 1) + PROMPT)
    build(folder, output=folder / "dist", report=Report(io.StringIO()))
    return folder / "dist"


@pytest.fixture(scope="module")
def isolated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make(tmp_path_factory.mktemp("isolated") / "site", "isolate: true")


@pytest.fixture(scope="module")
def hidden(isolated: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same, with JSPI hidden from its workers."""
    folder = tmp_path_factory.mktemp("hidden") / "dist"
    shutil.copytree(isolated, folder)
    for worker in (folder / "runtime" / "workers" / "python").glob("python*.js"):
        worker.write_text(WITHOUT_JSPI + worker.read_text())
    return folder


@pytest.fixture
def tab(browser: Browser) -> Iterator[Page]:
    """A tab of a new visitor."""
    context = browser.new_context()
    yield context.new_page()
    context.close()


def visit(tab: Page, url: str) -> None:
    """Go to a page until it is isolated."""
    tab.goto(url)
    until(tab, "() => crossOriginIsolated && document.readyState === 'complete'")
    tab.wait_for_selector(".ros-console, .ros-prompt")


def noted(tab: Page, name: str) -> str:
    return str(tab.evaluate("(name) => sessionStorage.getItem(name)", name))


@pytest.mark.firefox
def test_the_first_visit_loads_a_page_twice_and_says_so(
    isolated: Path, tab: Page, serve: Serve
) -> None:
    url = serve(isolated, "/robot/")
    tab.add_init_script(LISTEN)
    visit(tab, url)
    assert noted(tab, "said") == "This page reloads once to enable shared memory."
    assert run(tab, "greeter")[0] == "stopped"
    assert noted(tab, "loads") == "2"
    tab.reload()
    until(tab, "() => crossOriginIsolated")
    assert run(tab, "greeter")[0] == "stopped"
    assert noted(tab, "loads") == "3"


def test_a_page_that_cannot_be_isolated_says_why(
    hidden: Path, tab: Page, serve: Serve, tmp_path: Path
) -> None:
    tab.add_init_script(WITHOUT_JSPI)
    tab.context.route("**/sw.js", lambda route: route.fulfill(content_type="text/javascript"))
    tab.add_init_script(LISTEN)
    url = serve(hidden)
    tab.goto(url)
    until(
        tab, "() => sessionStorage.getItem('loads') === '2' && document.readyState === 'complete'"
    )
    state, lines = run(tab, "greeter")
    assert state == "failed"
    assert "reloading did not isolate this page; close its other tabs" in lines[0][1]
    assert noted(tab, "loads") == "2"
    # A frame of another page has to be opened by itself.
    (tmp_path / "index.html").write_text(f'<iframe src="{url}?embed"></iframe>')
    tab.goto(serve(tmp_path))
    inner = tab.frame_locator("iframe").get_by_role("region", name="greeter", exact=True)
    inner.get_by_role("button", name="Start").click()
    expect(inner.get_by_role("log")).to_contain_text("embedded in another page")


def test_an_isolated_page_without_shared_memory_says_so(
    hidden: Path, tab: Page, serve: Serve
) -> None:
    tab.add_init_script(f"{WITHOUT_JSPI} delete globalThis.SharedArrayBuffer;")
    visit(tab, serve(hidden))
    state, [(_, text)] = run(tab, "greeter")
    assert state == "failed"
    assert text.endswith("; it does not support shared memory either")


@pytest.mark.exhaustive
@pytest.mark.chromium
def test_without_jspi_programs_print_what_native_rclpy_prints(
    hidden: Path, tab: Page, serve: Serve
) -> None:
    tab.add_init_script(WITHOUT_JSPI)
    visit(tab, serve(hidden))
    native = Native()
    installed = hidden.parent / "installed"
    shutil.unpack_archive(hidden / "nodes" / "tutorials" / "python.zip", installed)
    programs = ("pubsub", "policies", "loops", "lifecycle", "graph", "introspection")
    for program in (*programs, "observers", "overrides", "spinning"):
        state, lines, expected = run_both(tab, native, program, installed)
        assert printed(lines) == expected.stdout.splitlines(), (program, lines)
        assert state == "stopped"
    state, lines = run(tab, "packing")
    assert printed(lines) == ["msgpack._cmsgpack {'speeds': [0.5, -1], 'name': 'left'}"], lines
    # A callback of an executor with threads runs while another waits for it; threads do not.
    state, lines = run(tab, "executors")
    assert state == "failed"
    assert printed(lines)[:2] == ["added again: False", "answer within a callback: yes"]
    state, lines = run(tab, "threads")
    assert state == "failed"
    assert printed(lines, "stderr")[-1].startswith(
        "RuntimeError: can't start new thread: this browser does not support JavaScript Promise "
        "Integration"
    )
    stopping = Panel(tab, "stopping")
    stopping.start()
    stopping.wait_for("spinning")
    stopping.stop()
    stopping.wait_for("finally")
    assert stopping.lines()[-2:] == ["interrupted, ok: False", "finally"]
    expect_nothing_left(tab)


@pytest.mark.firefox
def test_what_computes_without_a_pause_is_interrupted(
    isolated: Path, tab: Page, serve: Serve
) -> None:
    url = serve(isolated)
    visit(tab, url)
    _interrupt_busy(tab)
    tab.goto(f"{url}prompt/")
    tab.get_by_role("button", name="Start").click()
    line, log = tab.get_by_role("textbox"), tab.get_by_role("log")
    line.fill(r"exec('import time; print(6 * 6); time.sleep(0.1)\nwhile True: pass')")
    line.press("Enter")
    expect(log).to_contain_text("36")
    tab.get_by_role("button", name="Interrupt").click()
    expect(log).to_contain_text("KeyboardInterrupt")
    line.fill("6 * 7")
    line.press("Enter")
    expect(log).to_contain_text("42")


def test_and_so_it_is_without_jspi(hidden: Path, tab: Page, serve: Serve) -> None:
    tab.add_init_script(WITHOUT_JSPI)
    visit(tab, serve(hidden))
    _interrupt_busy(tab)


def _interrupt_busy(tab: Page) -> None:
    # The last one computes in the layer below rclpy, which must not be suspended.
    for name, first in (("busy", ["ready"]), ("busy", ["ready"]), ("serializing", [])):
        panel = Panel(tab, name)
        panel.start()
        panel.wait_for("computing")
        panel.stop()
        panel.wait_for("finally")
        assert panel.lines() == [*first, "computing", "interrupted, ok: False", "finally"]
        panel.button("Clear").click()


def test_it_works_without_a_network_too(
    tmp_path: Path, tab: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    dist = make(tmp_path / "site", "isolate: true\n  offline: true")
    with serving(dist, "/robot/") as url:
        visit(tab, url)
        until(tab, READY)
        until(tab, "async () => !!(await caches.match('nodes/tutorials/python.zip'))")
        until(tab, "async () => !!(await caches.match('runtime/vendor/pyodide/pyodide.asm.wasm'))")
        until(tab, "async () => !!(await caches.match('nodes/ros.zip'))")
    tab.reload()
    until(tab, "() => crossOriginIsolated")
    state, lines = run(tab, "greeter")
    assert (state, printed(lines)) == ("stopped", ["Good morning, World greeter.py True"])


def test_a_site_can_take_it_back(tmp_path: Path) -> None:
    dist = make(tmp_path / "site", "isolate: false")
    assert "unregister" in (dist / "sw.js").read_text()
    assert "isolate" not in (dist / "page.json").read_text()


def test_an_author_who_edits_has_isolated_pages(isolated: Path) -> None:
    live = LiveSite(isolated.parent, Report(io.StringIO()))
    live.rebuild()
    with Server(live, 0) as server, urllib.request.urlopen(server.url) as answer:
        assert answer.headers["Cross-Origin-Opener-Policy"] == "same-origin"
        assert answer.headers["Cross-Origin-Embedder-Policy"] == "require-corp"


@pytest.mark.exhaustive
def test_webkit_runs_python_in_shared_memory(window: Window, isolated: Path, serve: Serve) -> None:
    window.goto(serve(isolated))
    window.wait_until(lambda: window.evaluate("() => crossOriginIsolated"))
    node = WindowPanel(window, "pubsub")
    node.start()
    node.wait_for("ok False")
    # A second worker: WebKit asks whether the first one's program is still right.
    busy = WindowPanel(window, "busy")
    busy.start()
    busy.wait_for("computing")
    busy.stop()
    busy.wait_for("finally")
    assert busy.lines() == ["ready", "computing", "interrupted, ok: False", "finally"]
