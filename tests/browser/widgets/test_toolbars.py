"""Tools of panels: in one row at each width, and those that do not fit in a menu."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Locator, ViewportSize, expect
from playwright.sync_api import Page as Tab
from scenes import view
from stage import add, show

IMAGE = "sensor_msgs/msg/Image"
PHONE: ViewportSize = {"width": 390, "height": 844}
DESKTOP: ViewportSize = {"width": 1280, "height": 800}
# What is in the row: its name or its label, and how its middle and its right edge lie in the panel.
ROW = """(bar) => [...bar.children].filter((one) => one.offsetWidth && !one.popover).map((one) => {
  const { top, bottom, right } = one.getBoundingClientRect();
  const panel = bar.closest("#panel").getBoundingClientRect();
  return [one.innerText.trim(), (top + bottom) / 2 - panel.top, panel.right - right];
})"""
# Each with the tools that visitors look for.
PANELS: list[tuple[str, dict[str, Any], list[str]]] = [
    (
        "plot",
        {"title": "Where the robot is"},
        ["Pause", "Zoom in", "Fit", "Points", "CSV", "Clear"],
    ),
    ("image", {"topic": "/camera/image_raw"}, ["Zoom in", "Zoom out", "Fit", "Save"]),
    ("graph", {}, ["Zoom in", "Zoom out", "Fit"]),
    ("tf", {}, ["Zoom in", "Zoom out", "Fit"]),
    ("3d", {}, ["Top", "Fit", "Goal", "Estimate", "Point", "Measure", "Picture"]),
]


def panel_of(stage: Tab, kind: str, options: dict[str, Any]) -> Locator:
    return view(stage, **options) if kind == "3d" else show(stage, kind, options)


def row(panel: Locator) -> list[str]:
    """Return the names in the row, which is one row inside of the panel."""
    found = panel.locator(".ros-toolbar").evaluate(ROW)
    middles = [middle for _, middle, _ in found]
    assert max(middles) - min(middles) <= 1, found
    assert all(space >= 0 for _, _, space in found), found
    return [name for name, _, _ in found]


def more(panel: Locator) -> Locator:
    return panel.get_by_role("button", name="More", exact=True)


@pytest.mark.parametrize(("kind", "options", "tools"), PANELS, ids=[kind for kind, *_ in PANELS])
def test_all_tools_are_in_one_row_or_in_its_menu(
    stage: Tab, kind: str, options: dict[str, Any], tools: list[str]
) -> None:
    stage.set_viewport_size(DESKTOP)
    panel = panel_of(stage, kind, options)
    expect(more(panel)).to_be_hidden()
    assert set(row(panel)) >= {*tools, "Full screen"}
    stage.set_viewport_size({"width": 260, "height": 844})
    expect(more(panel)).to_be_visible()
    assert {"More", "Full screen"} <= set(row(panel))
    more(panel).click()
    menu = panel.locator(".ros-tool-menu")
    expect(menu).to_be_visible()
    for name in tools:
        expect(panel.get_by_role("button", name=name, exact=True)).to_be_in_viewport(ratio=1)
    box = menu.bounding_box()
    assert box
    assert box["x"] >= 0
    assert box["x"] + box["width"] <= 260
    stage.set_viewport_size(DESKTOP)
    expect(more(panel)).to_be_hidden()
    assert set(row(panel)) >= {*tools, "Full screen"}


def test_a_tool_in_the_menu_works_and_closes_it(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/v", "geometry_msgs/msg/Vector3")
    stage.set_viewport_size({"width": 260, "height": 844})
    panel = show(stage, "plot", {"series": ["/v.x"]})
    more(panel).click()
    points = panel.get_by_role("button", name="Points", exact=True)
    expect(points).to_have_attribute("aria-pressed", "false")
    points.click()
    expect(points).to_be_hidden()
    # A field stays open until one presses elsewhere.
    more(panel).click()
    expect(points).to_have_attribute("aria-pressed", "true")
    panel.get_by_role("textbox", name="seconds").fill("5")
    panel.get_by_role("textbox", name="seconds").press("Tab")
    expect(points).to_be_visible()
    stage.keyboard.press("Escape")
    expect(points).to_be_hidden()
    expect(more(panel)).to_be_focused()


def test_the_focus_stays_when_tools_move(stage: Tab) -> None:
    stage.set_viewport_size(DESKTOP)
    panel = show(stage, "plot")
    clear = panel.get_by_role("button", name="Clear", exact=True)
    clear.focus()
    stage.set_viewport_size({"width": 260, "height": 844})
    expect(more(panel)).to_be_focused()
    panel.get_by_role("button", name="Full screen").focus()
    stage.set_viewport_size(DESKTOP)
    expect(panel.get_by_role("button", name="Full screen")).to_be_focused()


def test_an_open_menu_goes_when_all_tools_fit(stage: Tab) -> None:
    stage.set_viewport_size({"width": 260, "height": 844})
    panel = show(stage, "plot")
    more(panel).click()
    menu = panel.locator(".ros-tool-menu")
    expect(menu).to_be_visible()
    stage.set_viewport_size(DESKTOP)
    expect(menu).to_be_hidden()
    expect(panel.get_by_role("button", name="Pause")).to_be_focused()


def test_a_field_that_comes_finds_room(stage: Tab) -> None:
    """An image of depths has a range to choose, which others have not."""
    stage.set_viewport_size({"width": 330, "height": 844})
    add(stage, "publisher", "/camera", "/i", IMAGE)
    stage.evaluate("(type) => void (ros.types[type] = ros.fields(''))", IMAGE)
    panel = show(stage, "image", {"topic": "/i"})
    expect(more(panel)).to_be_hidden()
    stage.evaluate(
        """async () => {
          ros.emit("/i", { header: {}, width: 2, height: 1, encoding: "16UC1", is_bigendian: 0,
            step: 4, data: new Uint8Array(4) });
          await frames(3);
        }"""
    )
    expect(more(panel)).to_be_visible()
    row(panel)
    more(panel).click()
    expect(panel.get_by_label("depth that is black")).to_be_visible()


def test_tools_of_a_view_lie_over_it(stage: Tab) -> None:
    stage.set_viewport_size(PHONE)
    panel = view(stage)
    canvas, tools = (
        panel.locator("canvas").bounding_box(),
        panel.locator(".ros-toolbar").bounding_box(),
    )
    assert canvas
    assert tools
    assert canvas["y"] <= tools["y"]
    assert tools["y"] + tools["height"] < canvas["y"] + canvas["height"] / 4
    # What is between them belongs to the view.
    panel.locator("canvas").click(
        position={"x": canvas["width"] / 2, "y": canvas["height"] / 2}, trial=True
    )


def test_keys_of_a_terminal_are_drawn(stage: Tab) -> None:
    stage.set_viewport_size(PHONE)
    panel = show(stage, "terminal")
    names = ["Earlier line", "Later line", "Cursor left", "Cursor right"]
    keys = [panel.get_by_role("button", name=name, exact=True) for name in names]
    drawings = set()
    for key in keys:
        drawings.add(key.locator("svg").inner_html())
        box = key.bounding_box()
        assert box
        assert box["height"] >= 44
    # Each has its own drawing.
    assert len(drawings) == len(names)
    assert not set("\u2190\u2191\u2192\u2193") & set(panel.locator(".ros-keys").inner_text())


def test_tools_say_what_they_do(stage: Tab) -> None:
    panel = view(stage)
    goal = panel.get_by_role("button", name="Goal", exact=True)
    expect(goal).to_have_attribute(
        "title", "Goal: Drag from the goal in the direction to face (/goal_pose)"
    )
    # Drawings, which each browser has, and no letters of its fonts.
    expect(goal.locator("svg")).to_have_attribute("aria-hidden", "true")


# The middles of what is in the bar of the log, the fields among them.
BAR = """(bar) => [...bar.querySelectorAll(".ros-title, select, input, button")]
  .filter((one) => one.offsetWidth)
  .map((one) => one.getBoundingClientRect())
  .map(({ top, bottom, left, right }) => [(top + bottom) / 2, left, right])"""


def rows(panel: Locator, width: int) -> int:
    """Return how many rows the bar of the log has, in which nothing is cut off."""
    found = panel.locator(".ros-bar").evaluate(BAR)
    left = panel.bounding_box()
    assert left
    assert all(left["x"] <= start < end <= left["x"] + width for _, start, end in found), found
    return len({round(middle) for middle, _, _ in found})


@pytest.mark.parametrize("width", [260, 330, 390])
def test_filters_of_a_narrow_log_open_from_a_tool(stage: Tab, width: int) -> None:
    stage.set_viewport_size({"width": width, "height": 844})
    panel = show(stage, "log")
    press = panel.get_by_role("button", name="Filters")
    severity = panel.get_by_label("severity")
    expect(severity).to_be_hidden()
    assert rows(panel, width) == 1
    press.click()
    expect(press).to_have_attribute("aria-expanded", "true")
    panel.get_by_label("text").fill("word")
    assert rows(panel, width) in (3, 4)
    # A filter that is not seen is told.
    press.click()
    expect(severity).to_be_hidden()
    expect(panel.get_by_role("button", name="Filters (active)")).to_be_visible()
    press.click()
    panel.get_by_label("text").fill("")
    expect(panel.get_by_role("button", name="Filters", exact=True)).to_be_visible()


@pytest.mark.parametrize("width", [560, 800, 1280])
def test_filters_of_a_wide_log_are_in_its_row(stage: Tab, width: int) -> None:
    stage.set_viewport_size({"width": width, "height": 800})
    panel = show(stage, "log")
    expect(panel.get_by_label("severity")).to_be_visible()
    expect(panel.get_by_role("button", name="Filters")).to_be_hidden()
    assert rows(panel, width) == 1
