"""The panels of the log and of the graph in a real browser."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from stage import add, chatter, hide_tab, show

pytestmark = pytest.mark.firefox

# What stands where there is no rate.
NONE = "\u2013"


def log(stage: Tab, *entries: tuple[int, str, str, float]) -> None:
    stage.evaluate(
        """async (entries) => {
          for (const [level, name, msg, at] of entries) {
            const stamp = { sec: Math.floor(at), nanosec: Math.round((at % 1) * 1e9) };
            ros.emit("/rosout", { stamp, level, name, msg, file: "", function: "", line: 1 });
          }
          await frames();
        }""",
        [list(entry) for entry in entries],
    )


def logged(panel: Locator) -> list[str]:
    panel.page.evaluate("frames()")
    return [
        row.split(" ", 1)[1] for row in panel.get_by_role("log").locator("> *").all_inner_texts()
    ]


def test_the_log_is_filtered(stage: Tab) -> None:
    panel = show(stage, "log")
    expect(panel.get_by_text("Nothing logged yet")).to_be_visible()
    log(stage, (20, "talker", "Hello", 1.0), (10, "talker", "detail", 2.0),
        (40, "arm", "<b>Broken</b>", 4.0), (30, "arm", "warm", 3.0))  # fmt: skip
    assert logged(panel) == ["INFO talker: Hello", "WARN arm: warm", "ERROR arm: <b>Broken</b>"]
    panel.get_by_label("severity").select_option("debug")
    assert len(logged(panel)) == 4
    panel.get_by_label("node", exact=True).select_option("arm")
    assert logged(panel) == ["WARN arm: warm", "ERROR arm: <b>Broken</b>"]
    panel.get_by_label("text").fill("broken")
    assert logged(panel) == ["ERROR arm: <b>Broken</b>"]
    panel.get_by_label("text").fill("nowhere")
    expect(panel.get_by_text("No lines match the filters")).to_be_visible()


def test_what_nodes_keep_is_shown_once(stage: Tab) -> None:
    panel = show(stage, "log", {"lines": 3})
    kept = [(20, "talker", f"line {number}", float(number)) for number in range(5)]
    log(stage, *kept)
    assert logged(panel) == [f"INFO talker: line {number}" for number in (2, 3, 4)]
    hide_tab(stage, True)
    hide_tab(stage, False)
    log(stage, *kept, (20, "talker", "new", 9.0))
    assert logged(panel) == ["INFO talker: line 3", "INFO talker: line 4", "INFO talker: new"]
    panel.get_by_role("button", name="Clear").click()
    log(stage, *kept)
    assert logged(panel) == []


def drawn(panel: Locator) -> list[str]:
    return panel.locator("svg text").all_text_contents()


def test_the_graph_is_drawn_and_follows(stage: Tab) -> None:
    panel = show(stage, "graph")
    expect(panel.get_by_text("No nodes now")).to_be_visible()
    add(stage, "node", "/talker", "", "")
    chatter(stage)
    add(stage, "publisher", "/talker", "/rosout", "rcl_interfaces/msg/Log")
    add(stage, "subscription", "/_page", "/chatter", "std_msgs/msg/String")
    add(stage, "node", "/alone", "", "")
    picture = panel.get_by_role("img")
    expect(picture).to_have_attribute(
        "aria-label",
        "/talker publishes /chatter; /listener subscribes to /chatter; /alone has no connections",
    )
    assert sorted(drawn(panel)) == ["/alone", "/chatter", "/listener", "/talker"]
    # From left to right, as messages go, and each name inside its box.
    boxes = panel.locator("svg g > g").evaluate_all(
        """(groups) => Object.fromEntries(groups.map((group) => {
          const [box, text] = [...group.children].map((one) => one.getBoundingClientRect());
          return [group.textContent, [box.x, box.x + box.width, box.width - text.width]];
        }))"""
    )
    assert boxes["/talker"][1] < boxes["/chatter"][0]
    assert boxes["/chatter"][1] < boxes["/listener"][0]
    assert min(free for _, _, free in boxes.values()) > 8
    assert panel.locator(".ros-arrow").count() == 2
    panel.get_by_label("Show hidden").check()
    assert {"/rosout", "/_page"} < set(drawn(panel))
    stage.evaluate("ros.graph.remove('/talker')")
    assert "/talker" not in drawn(panel)


def test_the_graph_has_services_that_differ_from_topics(stage: Tab) -> None:
    panel = show(stage, "graph")
    chatter(stage)
    add(stage, "service", "/server", "/add", "tutorial_interfaces/srv/AddTwoInts")
    add(stage, "client", "/caller", "/add", "tutorial_interfaces/srv/AddTwoInts")
    add(stage, "service", "/server", "/server/get_parameters", "rcl_interfaces/srv/GetParameters")
    expect(panel.get_by_role("img")).to_have_attribute(
        "aria-label",
        "/talker publishes /chatter; /listener subscribes to /chatter; "
        "/caller calls /add; /server serves /add",
    )
    assert "/server/get_parameters" not in drawn(panel)
    assert panel.locator(".ros-service-box").all_text_contents() == ["/add"]
    dashed = "(e) => getComputedStyle(e).strokeDasharray"
    assert panel.locator(".ros-service-box rect").evaluate(dashed) != "none"
    assert panel.locator(".ros-topic-box rect").evaluate(dashed) == "none"
    expect(panel.locator(".ros-call-arrow")).to_have_count(2)
    expect(panel.locator(".ros-arrow")).to_have_count(4)
    assert panel.locator(".ros-legend").inner_text().split() == ["node", "topic", "service"]


def test_the_graph_is_moved_and_zoomed(stage: Tab) -> None:
    chatter(stage)
    panel = show(stage, "graph")
    picture = panel.get_by_role("img")

    def view() -> list[float]:
        text = panel.locator("svg > g").get_attribute("transform") or ""
        return [float(number) for number in re.findall(r"-?[\d.]+(?:e-?\d+)?", text)]

    x, y, scale = view()
    assert scale == 1
    picture.focus()
    stage.keyboard.press("+")
    assert view()[2] == pytest.approx(1.3)
    stage.keyboard.press("-")
    stage.keyboard.press("ArrowRight")
    assert view() == pytest.approx([x - 48, y, 1])
    stage.keyboard.press("0")
    assert view() == pytest.approx([x, y, 1])
    panel.get_by_role("button", name="Zoom in").click()
    panel.get_by_role("button", name="Fit").click()
    assert view() == pytest.approx([x, y, 1])

    # The wheel scrolls the page until the drawing is chosen; then the point under it stays.
    picture.hover(position={"x": 100, "y": 50})
    stage.mouse.wheel(0, -100)
    assert view()[2] == 1
    picture.focus()
    stage.mouse.wheel(0, -100)
    stage.wait_for_function(
        "() => document.querySelector('svg > g').getAttribute('transform').length > 30"
    )
    zoomed = view()
    assert zoomed[2] > 1
    assert (100 - zoomed[0]) / zoomed[2] == pytest.approx(100 - x, abs=1)

    stage.keyboard.press("0")
    box = picture.bounding_box()
    assert box
    stage.mouse.move(box["x"] + 20, box["y"] + 20)
    stage.mouse.down()
    stage.mouse.move(box["x"] + 60, box["y"] + 30)
    stage.mouse.up()
    stage.mouse.move(box["x"] + 90, box["y"] + 90)
    assert view() == pytest.approx([x + 40, y + 10, 1])


def test_two_fingers_zoom_the_graph(stage: Tab) -> None:
    chatter(stage)
    panel = show(stage, "graph")
    stage.evaluate(
        """() => {
          const svg = document.querySelector("#panel .ros-drawing svg");
          svg.setPointerCapture = () => {};
          const { left, top } = svg.getBoundingClientRect();
          const send = (kind, pointerId, x) => svg.dispatchEvent(new PointerEvent(kind, {
            pointerId, clientX: left + x, clientY: top + 50, bubbles: true }));
          send("pointerdown", 1, 100);
          send("pointerdown", 2, 200);
          send("pointermove", 2, 300);
          send("pointerup", 1, 100);
          send("pointerup", 2, 300);
        }"""
    )
    expect(panel.locator("svg > g")).to_have_attribute("transform", re.compile(r"scale\(2\)"))
