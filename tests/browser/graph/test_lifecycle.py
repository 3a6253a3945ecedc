"""Pages that are left, frozen, restored and reloaded, at any moment of a node's life."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import FLAGS, WHOLE_CHROMIUM, Built, Serve
from panel import Panel, expect_nothing_left, numbers
from paths import ROOT
from playwright.sync_api import Browser, Page, expect

DEMOS = ROOT / "demos"
RELOADS = 20


@pytest.fixture
def restoring(browser: Browser) -> Iterator[Page]:
    """A tab of a browser that keeps pages which were left, as those of visitors do."""
    kept = browser.browser_type.launch(
        executable_path=WHOLE_CHROMIUM,
        args=FLAGS,
        ignore_default_args=["--disable-back-forward-cache"],
    )
    yield kept.new_page()
    kept.close()


@pytest.mark.chromium
def test_a_page_that_was_left_goes_on_where_it_was(
    restoring: Page, serve: Serve, built: Built
) -> None:
    page = restoring
    faults: list[str] = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.on("console", lambda line: faults.append(line.text) if line.type == "error" else None)
    url = serve(built(DEMOS / "demo03"))
    page.goto(url)
    talker, listener = Panel(page, "talker"), Panel(page, "listener")
    listener.start()
    listener.expect_state("running")
    talker.start()
    listener.wait_for("Hello, world! 2")
    page.evaluate("addEventListener('pageshow', (event) => { window.restored = event.persisted; })")
    for _ in range(3):
        page.goto("about:blank")
        page.wait_for_timeout(2000)
        page.go_back(wait_until="commit")  # it is there at once: nothing loads
        page.wait_for_function("() => window.restored")
        listener.wait_for(f"Hello, world! {numbers(listener, 'I heard')[-1] + 3}")
    heard = numbers(listener, "I heard")
    # Nothing is missed and nothing repeated.
    assert heard == list(range(heard[0], heard[0] + len(heard)))
    talker.stop()
    listener.stop()
    assert faults == []


def test_a_page_is_reloaded_while_its_nodes_start(tab: Page, serve: Serve, built: Built) -> None:
    """Whatever moment that is, the console stays clean and the next page works."""
    url = serve(built(DEMOS / "demo03"))
    moment = random.Random(1)
    tab.add_init_script("""
      addEventListener("DOMContentLoaded", async () => {
        if (!document.getElementById("ros-page")) return;
        const { ros } = await import(document.querySelector("script[type=module]").src);
        for (const node of ros.nodes.values()) node.start();
      });
    """)
    for turn in range(RELOADS):
        tab.goto(f"{url}?{turn}" if turn % 2 else "about:blank", wait_until="commit")
        tab.wait_for_timeout(moment.random() * 400)
    tab.goto(url)
    talker, listener = Panel(tab, "talker"), Panel(tab, "listener")
    listener.wait_for("Hello, world! ")
    talker.stop()
    listener.stop()
    expect_nothing_left(tab)


def test_widgets_end_with_their_page(tab: Page, serve: Serve, tmp_path: Path) -> None:
    """A page in the back/forward cache keeps its widgets: it may be shown again."""
    (tmp_path / "runtime").symlink_to(ROOT / "sitegen/runtime")
    widgets: list[dict[str, object]] = [
        {"kind": "log", "element": name, "target": "", "options": {}} for name in ("one", "two")
    ]
    (tmp_path / "page.json").write_text(json.dumps({"nodes": {}, "widgets": widgets, "types": {}}))
    (tmp_path / "index.html").write_text(
        '<!doctype html><link rel="icon" href="data:,"><link id="ros-page" href="page.json">'
        '<div id="one"></div><div id="two"></div>'
        '<script type="module" src="runtime/rosMain.js"></script>'
    )
    tab.goto(serve(tmp_path))
    one, two = tab.locator("#one > *"), tab.locator("#two > *")
    hide = "(persisted) => dispatchEvent(new PageTransitionEvent('pagehide', { persisted }))"
    expect(two).to_have_count(3)
    tab.evaluate(hide, True)
    expect(one).to_have_count(3)
    tab.evaluate("async () => (await import('./runtime/rosMain.js')).ros.unmount('one')")
    expect(one).to_have_count(0)
    expect(two).to_have_count(3)
    tab.evaluate(hide, False)
    expect(two).to_have_count(0)


@pytest.mark.chromium
def test_a_line_has_one_time(tab: Page, serve: Serve, built: Built) -> None:
    """The console and /rosout agree on when a line was logged, in Python and in C++."""
    tab.goto(serve(built(DEMOS / "demo06")))
    printed, logged = tab.evaluate(
        r"""async () => {
          const { ros } = await import(document.querySelector('script[src$="rosMain.js"]').src);
          const printed = [], logged = [];
          for (const node of ros.nodes.values()) {
            node.addEventListener("lines", ({ detail }) => {
              for (const { text } of detail) {
                const [, at] = /^\[INFO\] \[([\d.]+)\]/.exec(text) ?? [];
                if (at) printed.push(at);
              }
            });
          }
          const qos = { depth: 1000, reliable: true, transientLocal: true };
          const seen = new Set();
          ros.subscribe("/rosout", "rcl_interfaces/msg/Log", ({ stamp, name }) => {
            seen.add(name);
            logged.push(`${stamp.sec}.${String(stamp.nanosec).padStart(9, "0")}`);
          }, qos);
          for (const node of ros.nodes.values()) node.start();
          const end = Date.now() + 60_000;
          const agreed = () => logged.slice(0, 6).every((at) => printed.includes(at));
          while ((seen.size < 2 || logged.length < 6 || !agreed()) && Date.now() < end) {
            await new Promise((done) => setTimeout(done, 50));
          }
          return [printed, logged];
        }"""
    )
    assert len(logged) >= 6
    assert set(logged[:6]) <= set(printed)
