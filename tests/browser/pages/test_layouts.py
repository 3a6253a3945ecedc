"""Columns, tabs and stages, as a visitor uses them."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from browser import Serve
from panel import Panel
from paths import DEMOS
from playwright.sync_api import Page, expect

from sitegen.commands.build import build
from sitegen.report import Report

SITE = """\
site: {title: Layouts}
workspace: .
nodes:
  talker: {package: cpp_pubsub, executable: talker}
  listener: {package: cpp_pubsub, executable: listener}
pages:
  - path: /
    title: Layouts
    content:
      - stage:
          show: {topics: {echo: /chatter}}
          nodes: [talker]
      - tabs:
          Listen: [{buttons: listener}, {console: listener}]
          Look: {columns: [{graph: }, {size: 2, content: [{markdown: "## Nodes"}, {nodes: }]}]}
"""


@pytest.fixture
def url(tmp_path: Path, serve: Serve) -> str:
    folder = tmp_path / "site"
    shutil.copytree(DEMOS / "demo03" / "src", folder / "src")
    (folder / "site.yaml").write_text(SITE)
    build(folder, output=tmp_path / "dist", report=Report())
    return serve(tmp_path / "dist")


@pytest.mark.firefox
def test_button_and_effect_are_seen_together(tab: Page, url: str) -> None:
    tab.set_viewport_size({"width": 390, "height": 844})
    tab.goto(url)
    talker = Panel(tab, "talker")
    talker.start()
    topics = tab.get_by_role("region", name="Topics")
    expect(topics).to_contain_text("data: Hello, world! 1")
    expect(talker.button("Stop")).to_be_in_viewport()
    expect(topics.locator(".ros-table")).to_be_in_viewport()
    assert tab.evaluate("document.documentElement.scrollWidth") == 390
    # What the node prints is folded.
    expect(talker.console).to_be_hidden()
    tab.get_by_text("Console output").click()
    expect(talker.console).to_be_visible()
    talker.wait_for("Hello, world! 2")
    talker.stop()
    consoles = tab.get_by_role("region", name="talker: Console output")
    consoles.get_by_role("button", name="Clear").click()
    expect(talker.console).to_be_empty()


def test_a_chosen_tab_travels_in_links(tab: Page, url: str) -> None:
    tab.goto(url)
    graph = tab.get_by_role("region", name="Graph")
    expect(graph).to_be_hidden()
    tab.get_by_text("Look", exact=True).click()
    graph.scroll_into_view_if_needed()
    expect(tab.get_by_role("heading", name="Nodes")).to_be_visible()
    Panel(tab, "talker").start()
    graph.scroll_into_view_if_needed()
    expect(graph).to_contain_text("/minimal_publisher")
    link = tab.evaluate(
        "async () => (await import(document.querySelector('script[src*=rosMain]').src)).ros.link()"
    )
    other = tab.context.new_page()
    other.goto(url + link)
    other.locator(".ros-word").get_by_role("button", name="Start").click()
    graph = other.get_by_role("region", name="Graph")
    graph.scroll_into_view_if_needed()
    expect(graph).to_contain_text("/minimal_publisher")
    expect(Panel(other, "listener").button("Start")).to_be_hidden()


def test_tabs_are_tabs_for_keyboards_and_screen_readers(tab: Page, url: str) -> None:
    tab.goto(url)
    listen, look = tab.get_by_role("tab").all()
    expect(listen).to_have_attribute("aria-selected", "true")
    expect(tab.get_by_role("tabpanel", name="Listen")).to_be_visible()
    expect(tab.get_by_role("radio")).to_have_count(0)
    listen.focus()
    tab.keyboard.press("ArrowRight")
    expect(look).to_be_focused()
    expect(look).to_have_attribute("aria-selected", "true")
    expect(listen).to_have_attribute("tabindex", "-1")
    expect(tab.get_by_role("tabpanel", name="Look")).to_be_visible()
    # The ring is on the tab, not on the row.
    expect(look).to_have_css("outline-style", "solid")
    expect(tab.get_by_role("tablist")).to_have_css("outline-style", "none")
    tab.keyboard.press("ArrowRight")
    expect(listen).to_be_focused()
    tab.keyboard.press("End")
    expect(look).to_be_focused()
    tab.keyboard.press("Tab")
    expect(tab.get_by_role("tabpanel", name="Look").locator(":focus")).to_have_count(1)
    listen.click()
    expect(listen).to_have_attribute("aria-selected", "true")
    # A link chooses one, too.
    look.click()
    link = tab.evaluate(
        "async () => (await import(document.querySelector('script[src*=rosMain]').src)).ros.link()"
    )
    other = tab.context.new_page()
    other.goto(url + link)
    expect(other.get_by_role("tab", name="Look")).to_have_attribute("aria-selected", "true")
    expect(other.get_by_role("tab", name="Listen")).to_have_attribute("aria-selected", "false")


def test_panels_below_the_fold_have_their_content_before_one_scrolls(tab: Page, url: str) -> None:
    tab.set_viewport_size({"width": 1280, "height": 500})
    tab.goto(url)
    tab.get_by_role("tab", name="Look").dispatch_event("click")
    tab.evaluate("scrollTo(0, 0)")
    graph = tab.get_by_role("region", name="Graph")
    expect(graph).not_to_be_in_viewport()
    Panel(tab, "talker").button("Start").dispatch_event("click")
    expect(graph).to_contain_text("/minimal_publisher")
    assert tab.evaluate("scrollY") == 0
