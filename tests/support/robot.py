"""A robot on the stage, as a test commands it and reads it."""

from __future__ import annotations

import re
from typing import Any

from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from stage import add, show


def show_robot(stage: Tab, **options: Any) -> Locator:
    """A robot, and two nodes that publish what it listens to."""
    given = {"color": "/color", "twist": "/cmd_vel", "sensors": "/vernie", **options}
    panel = show(stage, "robot", given)
    expect(panel.get_by_role("img")).to_be_visible()
    add(stage, "publisher", "/dancer", "/cmd_vel", "geometry_msgs/msg/Twist")
    add(stage, "publisher", "/colors", "/color", "std_msgs/msg/String")
    return panel


def command(stage: Tab, x: float, z: float) -> None:
    stage.evaluate(
        """([x, z]) => ros.emit("/cmd_vel", {
          linear: { x, y: 0, z: 0 }, angular: { x: 0, y: 0, z },
        })""",
        [x, z],
    )


def color(stage: Tab, name: str) -> None:
    stage.evaluate("(data) => ros.emit('/color', { data })", name)


def reading(panel: Locator, name: str) -> Locator:
    return panel.locator("dl > div", has=panel.page.get_by_text(name, exact=True)).locator("dd")


def pose(panel: Locator) -> tuple[float, float, float]:
    """Where it is drawn: metres and degrees."""
    drawn = panel.locator("svg > g > g")
    expect(drawn).to_have_attribute("transform", re.compile("."))
    found = drawn.get_attribute("transform") or ""
    x, y, turn = (float(number) for number in re.findall(r"-?[\d.]+(?:e-?\d+)?", found))
    return x, y, turn


def expect_power(panel: Locator, a: int, b: int) -> None:
    expect(reading(panel, "Motor A")).to_have_text(f"{a} %")
    expect(reading(panel, "Motor B")).to_have_text(f"{b} %")
