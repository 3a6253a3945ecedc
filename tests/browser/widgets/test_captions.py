"""What nodes print, over the view of what they move."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from robot import show_robot
from scenes import view
from stage import stop_clock

SAYS = """([name, severity, text]) => ros.nodes.get(name).dispatchEvent(
  new CustomEvent("lines", { detail: [{ severity, text }, { severity: "stdout", text: " " }] }))"""


@pytest.mark.parametrize("kind", ["robot", "3d"])
def test_the_newest_line_shows_for_a_while(stage: Tab, kind: str) -> None:
    for name in ("dance", "colors"):
        stage.evaluate("(name) => void ros.addNode(name, 'cpp_vernie', name)", name)
    options = {"captions": ["dance", "colors", "gone"]}
    robot = kind == "robot"
    panel = show_robot(stage, kind="vernie", **options) if robot else view(stage, **options)
    caption = panel.locator(".ros-caption")
    expect(caption).to_be_hidden()
    stop_clock(stage)
    stage.evaluate(SAYS, ["dance", "info", "[INFO] [1795413035.366799805] [dancer]: Now <b>back"])
    expect(caption).to_have_text("[INFO] [1795413035.366799805] [dancer]: Now <b>back")
    # The prefix is shown as the name, as in consoles.
    expect(caption.locator(".ros-prefix")).to_have_attribute("data-rest", "dancer: ")
    expect(caption.locator(".ros-prefix")).to_have_css("font-size", "0px")
    stage.clock.run_for(5000)
    stage.evaluate(SAYS, ["colors", "error", "no light"])
    expect(caption).to_have_text("no light")
    expect(caption).to_have_attribute("data-severity", "error")
    # What the visitor types is not said by the node.
    stage.evaluate(SAYS, ["dance", "typed", "hello"])
    expect(caption).to_have_text("no light")
    stage.clock.run_for(5000)
    expect(caption).to_be_visible()
    stage.clock.run_for(3500)
    expect(caption).to_be_hidden()
    stage.evaluate(SAYS, ["dance", "stdout", "again"])
    expect(caption).to_be_visible()
    stage.evaluate("void ros.nodes.get('dance').dispatchEvent(new Event('clear'))")
    expect(caption).to_be_hidden()
