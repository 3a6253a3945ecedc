"""The tools for the lines of a console: find, copy, save, fold; with a C++ node and many lines."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import Browser, BrowserContext, Locator, expect
from playwright.sync_api import Page as Tab
from stage import WIDER, show

MORE = "Tools for the lines of {}"


@pytest.fixture
def allowed(browser: Browser, serve: Serve) -> Iterator[BrowserContext]:
    """A browser whose pages may write to the clipboard."""
    context = browser.new_context(permissions=["clipboard-read", "clipboard-write"])
    yield context
    context.close()


@pytest.fixture
def console(allowed: BrowserContext, serve: Serve, built: Built) -> Locator:
    """The console of a node that has ended."""
    tab = allowed.new_page()
    tab.goto(serve(built(SITES / "forms")))
    panel = Panel(tab, "plain")
    panel.start()
    panel.expect_state("stopped")
    return tab.locator("#widget-console-plain")


def seen(console: Locator) -> list[str]:
    return console.locator(".ros-lines > :not([hidden])").all_text_contents()


def test_lines_are_found_copied_and_saved(console: Locator, tmp_path: Path) -> None:
    tab = console.page
    everything = seen(console)
    console.get_by_role("button", name=MORE.format("plain")).click()
    find = console.get_by_role("searchbox", name="Find in the lines of plain")
    expect(find).to_be_focused()
    word = everything[2].rpartition(" ")[2]
    find.fill(word.upper())
    matching = [line for line in everything if word.lower() in line.lower()]
    assert 0 < len(matching) < len(everything)
    assert seen(console) == matching
    expect(console.get_by_role("status")).to_have_text(f"{len(matching)} of {len(everything)}")
    console.get_by_role("button", name="Copy").click()
    expect(console.get_by_role("button", name="Copied")).to_be_visible()
    copied = tab.evaluate("navigator.clipboard.readText()")
    assert copied.replace("\r", "") == "".join(f"{line}\n" for line in matching)
    find.press("Escape")
    assert seen(console) == everything
    with tab.expect_download() as download:
        console.get_by_role("button", name="Save").click()
    assert download.value.suggested_filename.startswith("plain-20")
    download.value.save_as(tmp_path / "lines.txt")
    assert (tmp_path / "lines.txt").read_text() == "".join(f"{line}\n" for line in everything)
    find.press("Escape")
    expect(find).to_have_count(0)
    expect(console.get_by_role("button", name=MORE.format("plain"))).to_be_focused()


def test_folded_lines_are_restored_by_a_link(console: Locator) -> None:
    tab = console.page
    console.get_by_role("button", name=MORE.format("plain")).click()
    console.get_by_role("searchbox").fill("nowhere")
    console.get_by_role("button", name="Hide lines").click()
    expect(console.get_by_role("log", include_hidden=True)).to_be_hidden()
    link = tab.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          return ros.link();
        }"""
    )
    url = tab.url
    tab.goto("about:blank")
    tab.goto(url + link)
    expect(console.get_by_role("button", name="Show lines")).to_be_visible()
    expect(console.get_by_role("searchbox")).to_have_value("nowhere")
    console.get_by_role("button", name="Show lines").click()
    expect(console.get_by_role("log")).to_be_visible()


def test_lines_that_come_later_are_filtered_too(stage: Tab) -> None:
    stage.evaluate(
        """() => {
          const node = Object.assign(new EventTarget(), { name: "talker", state: "running" });
          window.print = async (texts) => {
            const detail = texts.map((text) => ({ severity: "info", text }));
            node.dispatchEvent(new CustomEvent("lines", { detail }));
            await frames();
          };
          window.clear = () => node.dispatchEvent(new Event("clear"));
          ros.nodes.set("talker", node);
        }"""
    )
    panel = show(stage, "console", {"node": "talker", "lines": 50})
    more = panel.get_by_role("button", name=MORE.format("talker"))
    expect(more).to_be_hidden()
    stage.evaluate("print(['odd <b>1</b>'])")
    more.click()
    panel.get_by_role("searchbox").fill("odd")
    stage.evaluate("print(Array.from({length: 99}, (_, n) => n % 2 ? `odd ${n}` : `even ${n}`))")
    expect(panel.get_by_role("status")).to_have_text("25 of 50")
    assert seen(panel)[-1] == "odd 97"
    stage.set_viewport_size({"width": 390, "height": 800})
    assert stage.evaluate(WIDER) <= 0
    stage.evaluate("clear()")
    expect(panel.get_by_role("status")).to_have_text("0 of 0")
    expect(panel.get_by_role("searchbox")).to_be_visible()
    panel.get_by_role("button", name="Close").click()
    expect(more).to_be_hidden()
