"""Robots in a real browser: how they move, when they stop, and what their panel says."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

import pytest
from browser import Built, Serve
from panel import Panel
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab

from sitegen.config.schema import ROBOTS, WIDGETS

ROOT = Path(__file__).parent.parent
ROBOT_FILES = ROOT / "sitegen/runtime/robots"


@pytest.fixture
def page(tab: Tab, serve: Serve, tmp_path: Path) -> Tab:
    shutil.copytree(ROOT / "sitegen/runtime", tmp_path / "runtime")
    shutil.copytree(ROOT / "themes/default", tmp_path / "theme")
    shutil.copytree(ROOT / "tests/panels", tmp_path, dirs_exist_ok=True)
    tab.goto(serve(tmp_path))
    tab.wait_for_selector("body[data-ready]")
    return tab


def show(page: Tab, **options: Any) -> Locator:
    defaults = {"color": "/color", "twist": "/cmd_vel", "sensors": "/vernie"}
    page.evaluate("(options) => show('robot', options)", {**defaults, **options})
    panel = page.locator("#panel")
    expect(panel.get_by_role("img")).to_be_visible()
    for name, topic, kind in (
        ("/dancer", "/cmd_vel", "geometry_msgs/msg/Twist"),
        ("/colors", "/color", "std_msgs/msg/String"),
    ):
        page.evaluate("(end) => ros.graph.add('publisher', ...end)", [name, topic, kind])
    return panel


def command(page: Tab, x: float, z: float) -> None:
    page.evaluate(
        """([x, z]) => ros.emit("/cmd_vel", {
          linear: { x, y: 0, z: 0 }, angular: { x: 0, y: 0, z },
        })""",
        [x, z],
    )


def color(page: Tab, name: str) -> None:
    page.evaluate("(data) => ros.emit('/color', { data })", name)


def reading(panel: Locator, name: str) -> Locator:
    return panel.locator("dl > div", has=panel.page.get_by_text(name, exact=True)).locator("dd")


def pose(panel: Locator) -> tuple[float, float, float]:
    """Where it is drawn: metres and degrees."""
    found = panel.locator("svg > g > g").get_attribute("transform") or ""
    x, y, turn = (float(number) for number in re.findall(r"-?[\d.]+(?:e-?\d+)?", found))
    return x, y, turn


def expect_power(panel: Locator, a: int, b: int) -> None:
    expect(reading(panel, "Motor A")).to_have_text(f"{a} %")
    expect(reading(panel, "Motor B")).to_have_text(f"{b} %")


def hide_tab(page: Tab) -> None:
    page.evaluate(
        """() => {
          const hidden = { value: "hidden", configurable: true };
          Object.defineProperty(document, "visibilityState", hidden);
          document.dispatchEvent(new Event("visibilitychange"));
        }"""
    )


# The family


def test_every_kind_is_a_file_and_every_option_is_a_key() -> None:
    assert sorted(file.stem for file in ROBOT_FILES.glob("*.js")) == sorted(ROBOTS)
    keys = {key.name for key in WIDGETS["robot"]} - {"kind"}
    assert {key for own in ROBOTS.values() for key in own} == keys


def test_arcs_are_driven_exactly(page: Tab) -> None:
    ends = page.evaluate(
        """async () => {
          const { drive } = await import("./runtime/robots/parts/motion.js");
          const start = { x: 0, y: 0, heading: 0 };
          const quarter = drive(start, Math.PI / 2, Math.PI / 2, 1);
          let steps = start;
          for (let n = 0; n < 1000; n++) steps = drive(steps, Math.PI / 2, Math.PI / 2, 0.001);
          return [drive(start, 2, 0, 1.5), quarter, steps, drive(start, 0, 1, 1)].map(
            ({ x, y, heading }) => [x, y, heading]);
        }"""
    )
    half_pi = pytest.approx(1.5707963)
    assert ends[0] == [3, 0, 0]
    assert ends[1] == [pytest.approx(1), pytest.approx(1), half_pi]
    assert ends[2] == [pytest.approx(1), pytest.approx(1), half_pi]
    assert ends[3] == [0, 0, 1]


def test_a_differential_drive_goes_where_it_is_told(page: Tab) -> None:
    panel = show(page, kind="diffdrive")
    assert pose(panel) == (0, 0, 0)
    command(page, 0.5, 0)
    expect(reading(panel, "Speed")).to_have_text("0.50 m/s")
    page.wait_for_timeout(600)
    command(page, 0, 0)
    expect(reading(panel, "Speed")).to_have_text("0.00 m/s")
    x, y, turn = pose(panel)
    assert 0.2 < x < 0.5
    assert (y, turn) == (0, 0)
    page.wait_for_timeout(200)
    assert pose(panel) == (x, y, turn)

    command(page, 0, 1)
    page.wait_for_timeout(500)
    command(page, 0, 0)
    expect(reading(panel, "Turn")).to_have_text("0.00 rad/s")
    assert pose(panel)[:2] == (x, y)
    assert 15 < pose(panel)[2] < 60
    panel.get_by_role("button", name="Back to start").click()
    expect(reading(panel, "Place")).to_have_text("0.00, 0.00 m")
    expect(reading(panel, "Heading")).to_have_text("0°")


def test_a_differential_drive_stands_where_odometry_says(page: Tab) -> None:
    page.evaluate(
        """() => {
          ros.types["nav_msgs/msg/Odometry"] = ros.fields("std_msgs/msg/String any");
        }"""
    )
    panel = show(page, kind="diffdrive", odometry="/odom")
    command(page, 1, 1)
    page.evaluate(
        """() => ros.emit("/odom", {
          pose: { pose: { position: { x: 3, y: -2, z: 0 },
            orientation: { x: 0, y: 0, z: Math.SQRT1_2, w: Math.SQRT1_2 } } },
          twist: { twist: { linear: { x: 0.25, y: 0, z: 0 }, angular: { x: 0, y: 0, z: -0.5 } } },
        })"""
    )
    expect(reading(panel, "Place")).to_have_text("3.00, -2.00 m")
    expect(reading(panel, "Heading")).to_have_text("90°")
    expect(reading(panel, "Speed")).to_have_text("0.25 m/s")
    expect(reading(panel, "Turn")).to_have_text("-0.50 rad/s")
    # The view has followed it.
    robot, stage = panel.locator("svg > g > g").bounding_box(), panel.locator("svg").bounding_box()
    assert robot
    assert stage
    assert stage["x"] < robot["x"] < stage["x"] + stage["width"] - robot["width"]
    assert stage["y"] < robot["y"] < stage["y"] + stage["height"] - robot["height"]


# Vernie


@pytest.mark.parametrize(
    ("x", "z", "a", "b"),
    [
        (0.5, 0, 50, 50),
        (-1, 0, -100, -100),
        (0.5, 0.1, 40, 60),
        (0, 0.3, -30, 30),
        (1, 1, 0, 100),
        (1, -1, 100, 0),
        (3, 1, 50, 100),
        (-10, 0, -100, -100),
        (0.5, 1, -33, 100),
    ],
)
def test_power_of_the_motors(page: Tab, x: float, z: float, a: int, b: int) -> None:
    found = page.evaluate(
        """async ([x, z]) =>
          (await import("./runtime/robots/vernie.js")).motorPower(x, z)""",
        [x, z],
    )
    assert found == [a, b]


def test_vernie_moves_on_the_page(page: Tab) -> None:
    panel = show(page, kind="vernie")
    assert pose(panel) == (0, 0, 90)
    command(page, 1, 0)
    expect_power(panel, 100, 100)
    page.wait_for_timeout(500)
    command(page, 0, -0.5)
    expect_power(panel, 50, -50)
    page.wait_for_timeout(300)
    command(page, 0, 0)
    expect_power(panel, 0, 0)
    x, y, turn = pose(panel)
    assert abs(x) < 1e-6
    assert 0.1 < y < 0.3
    assert turn < 70


def test_the_light_of_vernie(page: Tab) -> None:
    panel = show(page, kind="vernie")
    light = panel.locator(".ros-light")
    expect(reading(panel, "Light")).to_have_text("off")
    color(page, "green")
    expect(reading(panel, "Light")).to_have_text("green")
    expect(light).to_have_css("fill", "rgb(43, 201, 95)")
    color(page, "Light Blue")
    expect(reading(panel, "Light")).to_have_text("lightblue")
    color(page, "<b>mauve</b>")
    expect(panel.get_by_role("status")).to_contain_text(
        "Its light has no colour '<b>mauve</b>'; it knows off, pink,"
    )
    expect(reading(panel, "Light")).to_have_text("lightblue")
    color(page, "off")
    expect(panel.get_by_role("status")).to_have_text("")
    expect(reading(panel, "Light")).to_have_text("off")


# When they stop


def test_it_stops_without_commands(page: Tab) -> None:
    panel = show(page, kind="vernie")
    command(page, 0.5, 0)
    expect_power(panel, 50, 50)
    page.wait_for_timeout(700)
    command(page, 0.4, 0)
    page.wait_for_timeout(700)
    expect_power(panel, 40, 40)
    expect(panel.get_by_role("status")).to_have_text("Stopped: no command for a second")
    expect_power(panel, 0, 0)


def test_it_stops_when_nobody_publishes(page: Tab) -> None:
    panel = show(page, kind="vernie")
    command(page, 0.5, 0)
    expect_power(panel, 50, 50)
    page.evaluate("ros.graph.remove('/dancer')")
    expect(panel.get_by_role("status")).to_have_text(
        "Stopped: nobody publishes on /cmd_vel any more", timeout=500
    )
    expect_power(panel, 0, 0)
    expect(panel).to_contain_text("/cmd_vel: nobody publishes")
    # A command that was still on its way.
    command(page, 0.5, 0)
    page.wait_for_timeout(100)
    expect_power(panel, 0, 0)


def test_it_stops_when_the_page_is_hidden(page: Tab) -> None:
    panel = show(page, kind="vernie")
    command(page, 0.5, 0)
    expect_power(panel, 50, 50)
    hide_tab(page)
    expect(panel.get_by_role("status")).to_have_text("Stopped: the page was hidden", timeout=500)
    command(page, 0.5, 0)
    page.wait_for_timeout(100)
    expect_power(panel, 0, 0)


def test_it_stops_at_what_is_no_number(page: Tab) -> None:
    panel = show(page, kind="vernie")
    command(page, 0.5, 0)
    expect_power(panel, 50, 50)
    page.evaluate(
        """ros.emit("/cmd_vel", {
          linear: { x: NaN, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } })"""
    )
    expect(panel.get_by_role("status")).to_have_text("Stopped: a command was not a number")
    expect_power(panel, 0, 0)


def test_a_page_without_the_types_says_so(page: Tab) -> None:
    page.evaluate("delete ros.types['geometry_msgs/msg/Twist']")
    panel = show(page, kind="diffdrive")
    expect(panel).to_contain_text(
        "/cmd_vel: no node of this page uses geometry_msgs/msg/Twist, so it cannot be read"
    )


def test_nothing_is_left_after_unmount(page: Tab) -> None:
    page.evaluate("ros.types['std_msgs/msg/Float32'] = ros.fields('float32 data')")
    panel = show(page, kind="vernie")
    command(page, 0.5, 0)
    page.evaluate("unmount()")
    assert page.evaluate("[ros.subscriptions.length, ros.closed]") == [0, 1]
    expect(panel).to_be_empty()


# The demo


def test_demo04_dances(tab: Tab, built: Built, serve: Serve) -> None:
    tab.goto(f"{serve(built(ROOT))}demo04/")
    robot = tab.get_by_role("region", name="Robot")
    colors, dance = Panel(tab, "colors"), Panel(tab, "dance")
    expect(robot).to_contain_text("/cmd_vel: nobody publishes")

    colors.start()
    expect(reading(robot, "Light")).to_have_text("red")
    expect(reading(robot, "Light")).to_have_text("yellow")
    dance.start()
    expect_power(robot, 80, 80)
    expect(robot).to_contain_text("/color from /color_publisher · /cmd_vel from /dancer")
    expect_power(robot, 35, 85)

    # It waits for a hand, and goes on.
    robot.get_by_label("Hand before it").check()
    dance.wait_for("Something is 0.05 m before me")
    expect_power(robot, 0, 0)
    robot.get_by_label("Hand before it").uncheck()
    dance.wait_for("The way is free")
    expect_power(robot, 35, 85)

    dance.stop()
    expect_power(robot, 0, 0)
    expect(robot.get_by_role("status")).to_have_text(
        "Stopped: nobody publishes on /cmd_vel any more"
    )
    assert pose(robot)[1] > 0.2
