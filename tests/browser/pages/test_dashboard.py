"""A page whose panels fill the window, and panels that fill the screen."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from browser import Serve
from panel import Panel
from paths import DEMOS
from playwright.sync_api import Page, expect

from sitegen.build import make, write
from sitegen.options import Options
from sitegen.report import Report

SITE = """\
site: {title: Room}
nodes:
  talker: {package: cpp_pubsub, executable: talker}
  listener: {package: cpp_pubsub, executable: listener}
pages:
  - path: /
    title: Control room
    layout: dashboard
    content:
      - columns:
          - size: 2
            content:
              - rows:
                  - {size: 2, content: {graph: }}
                  - columns: [{log: }, {plot: }]
          - rows:
              - [{buttons: talker}, {console: talker}]
              - tabs: {Topics: {topics: }, Services: {services: }, Listener: [{console: listener}]}
  - path: grid/
    title: Grid
    layout: dashboard
    content:
      - markdown: "Some *text*."
      - grid: [{topics: }, {nodes: }, {tf: }, {parameters: }, {diagnostics: }, {actions: }]
"""
# What does not lie in the window as a whole, and what is cut off without a way to scroll to it.
OUTSIDE = """() => [...document.querySelectorAll(".ros-panel")]
  .filter((panel) => panel.checkVisibility())
  .filter((panel) => {
    const { left, top, right, bottom, width, height } = panel.getBoundingClientRect();
    return left < 0 || top < 0 || right > innerWidth + 1 || bottom > innerHeight + 1
      || width < 150 || height < 60;
  }).map((panel) => panel.getAttribute("aria-label"))"""
SCROLLS = """[document.documentElement.scrollHeight - innerHeight,
  document.documentElement.scrollWidth - innerWidth]"""


@pytest.fixture
def url(tmp_path: Path, serve: Serve) -> str:
    folder = tmp_path / "site"
    shutil.copytree(DEMOS / "demo03" / "src", folder / "src")
    (folder / "site.yaml").write_text(SITE)
    options = Options(draft=True, engines=("jspi",))
    write(make(folder, Report(), options=options).artifacts, tmp_path / "dist")
    return serve(tmp_path / "dist")


@pytest.mark.firefox
@pytest.mark.parametrize("page", ["", "grid/"])
@pytest.mark.parametrize("size", [(1280, 800), (1920, 1080), (960, 560)])
def test_panels_fill_the_window(tab: Page, url: str, page: str, size: tuple[int, int]) -> None:
    tab.set_viewport_size({"width": size[0], "height": size[1]})
    tab.goto(url + page)
    expect(tab.locator(".ros-panel .ros-bar").first).to_be_visible()
    if not page:
        Panel(tab, "talker").start()
        Panel(tab, "talker").wait_for("Hello, world! 3")
    for label in [None, *tab.locator(".tabbed-labels label").all()]:
        if label:
            label.click()
        assert tab.evaluate(OUTSIDE) == []
        assert tab.evaluate(SCROLLS) == [0, 0]
    if not page:
        graph = tab.get_by_role("region", name="Graph").bounding_box()
        log = tab.get_by_role("region", name="Log").bounding_box()
        talker = tab.get_by_role("region", name="talker").bounding_box()
        assert graph and log and talker
        assert graph["height"] / log["height"] == pytest.approx(2, abs=0.15)
        assert graph["width"] / talker["width"] == pytest.approx(2, abs=0.15)


def test_it_is_one_column_on_a_phone(tab: Page, url: str) -> None:
    tab.set_viewport_size({"width": 390, "height": 844})
    tab.goto(url)
    expect(tab.locator(".ros-panel .ros-bar").first).to_be_visible()
    boxes = [panel.bounding_box() for panel in tab.locator(".ros-panel:visible").all()]
    assert len({box["x"] for box in boxes if box}) == 1
    tops = [box["y"] for box in boxes if box]
    assert tops == sorted(tops)
    assert tab.evaluate(SCROLLS)[1] == 0


def test_the_menu_is_a_sheet(tab: Page, url: str) -> None:
    tab.set_viewport_size({"width": 1280, "height": 800})
    tab.goto(url)
    menu = tab.get_by_role("navigation", name="Pages")
    expect(menu).to_be_hidden()
    tab.get_by_role("button", name="Pages").click()
    menu.get_by_role("link", name="Grid").click()
    expect(tab.get_by_role("heading", name="Grid")).to_be_visible()


def test_every_panel_fills_the_screen(tab: Page, url: str) -> None:
    tab.set_viewport_size({"width": 1280, "height": 800})
    tab.goto(f"{url}grid/")
    for name in ("Topics", "Nodes", "Tf", "Parameters", "Diagnostics", "Actions"):
        panel = tab.get_by_role("region", name=name)
        panel.get_by_role("button", name="Full screen").click()
        expect(tab.locator(".ros-panel:fullscreen")).to_have_count(1)
        box = panel.bounding_box()
        assert box and (box["width"], box["height"]) == (1280, 800)
        panel.get_by_role("button", name="Full screen").click()
        expect(tab.locator(".ros-panel:fullscreen")).to_have_count(0)
