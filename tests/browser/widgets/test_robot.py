"""Robots in a real browser: how they move, and when they stop."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from panel import Panel
from paths import ROOT
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from robot import color, command, expect_power, pose, reading, show_robot
from stage import add, hide_tab, show, stop_clock

from sitegen.config.widgetkeys import ROBOTS, WIDGETS

ROBOT_FILES = ROOT / "sitegen/runtime/widgets/robots"

# The family


def test_every_kind_is_a_file_and_every_option_is_a_key() -> None:
    assert sorted(file.stem for file in ROBOT_FILES.glob("*.js")) == sorted(ROBOTS)
    keys = {key.name for key in WIDGETS["robot"]} - {"kind"}
    assert {key for own in ROBOTS.values() for key in own} == keys


def test_arcs_are_driven_exactly(stage: Tab) -> None:
    ends = stage.evaluate(
        """async () => {
          const { drive } = await import("./runtime/widgets/robots/parts/motion.js");
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


def test_a_differential_drive_goes_where_it_is_told(stage: Tab) -> None:
    panel = show_robot(stage, kind="diffdrive")
    assert pose(panel) == (0, 0, 0)
    stop_clock(stage)
    command(stage, 0.5, 0)
    stage.clock.run_for(600)
    expect(reading(panel, "Speed")).to_have_text("0.50 m/s")
    command(stage, 0, 0)
    stage.clock.run_for(100)
    expect(reading(panel, "Speed")).to_have_text("0.00 m/s")
    x, y, turn = pose(panel)
    assert x == pytest.approx(0.3, abs=0.01)
    assert (y, turn) == (0, 0)
    stage.clock.run_for(200)
    assert pose(panel) == (x, y, turn)

    command(stage, 0, 1)
    stage.clock.run_for(500)
    command(stage, 0, 0)
    stage.clock.run_for(100)
    expect(reading(panel, "Turn")).to_have_text("0.00 rad/s")
    assert pose(panel)[:2] == (x, y)
    assert pose(panel)[2] == pytest.approx(28.6, abs=1)
    panel.get_by_role("button", name="Reset").click()
    stage.clock.run_for(100)
    expect(reading(panel, "Position")).to_have_text("0.00, 0.00 m")
    expect(reading(panel, "Heading")).to_have_text("0°")


def test_a_differential_drive_stands_where_odometry_says(stage: Tab) -> None:
    stage.evaluate(
        """() => {
          ros.types["nav_msgs/msg/Odometry"] = ros.fields("std_msgs/msg/String any");
        }"""
    )
    panel = show_robot(stage, kind="diffdrive", odometry="/odom")
    command(stage, 1, 1)
    stage.evaluate(
        """() => ros.emit("/odom", {
          pose: { pose: { position: { x: 3, y: -2, z: 0 },
            orientation: { x: 0, y: 0, z: Math.SQRT1_2, w: Math.SQRT1_2 } } },
          twist: { twist: { linear: { x: 0.25, y: 0, z: 0 }, angular: { x: 0, y: 0, z: -0.5 } } },
        })"""
    )
    expect(reading(panel, "Position")).to_have_text("3.00, -2.00 m")
    expect(reading(panel, "Heading")).to_have_text("90°")
    expect(reading(panel, "Speed")).to_have_text("0.25 m/s")
    expect(reading(panel, "Turn")).to_have_text("-0.50 rad/s")
    # The view has followed it.
    robot, floor = panel.locator("svg > g > g").bounding_box(), panel.locator("svg").bounding_box()
    assert robot
    assert floor
    assert floor["x"] < robot["x"] < floor["x"] + floor["width"] - robot["width"]
    assert floor["y"] < robot["y"] < floor["y"] + floor["height"] - robot["height"]


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
def test_power_of_the_motors(stage: Tab, x: float, z: float, a: int, b: int) -> None:
    found = stage.evaluate(
        """async ([x, z]) =>
          (await import("./runtime/widgets/robots/vernie.js")).motorPower(x, z)""",
        [x, z],
    )
    assert found == [a, b]


def test_vernie_moves_on_the_page(stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    assert pose(panel) == (0, 0, 90)
    stop_clock(stage)
    command(stage, 1, 0)
    stage.clock.run_for(500)
    expect_power(panel, 100, 100)
    command(stage, 0, -0.5)
    stage.clock.run_for(300)
    expect_power(panel, 50, -50)
    command(stage, 0, 0)
    stage.clock.run_for(100)
    expect_power(panel, 0, 0)
    # Half a second at 0.3 m/s; then its tracks, 0.16 m apart, run against each other at 0.15 m/s.
    x, y, turn = pose(panel)
    assert abs(x) < 1e-6
    assert y == pytest.approx(0.15, abs=0.01)
    assert turn == pytest.approx(90 - 32.2, abs=2)


def test_the_light_of_vernie(stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    light = panel.locator(".ros-light")
    expect(reading(panel, "Light")).to_have_text("off")
    color(stage, "green")
    expect(reading(panel, "Light")).to_have_text("green")
    expect(light).to_have_css("fill", "rgb(43, 201, 95)")
    color(stage, "Light Blue")
    expect(reading(panel, "Light")).to_have_text("lightblue")
    color(stage, "<b>mauve</b>")
    expect(panel.get_by_role("status")).to_contain_text(
        "The light has no colour '<b>mauve</b>'; choose one of off, pink,"
    )
    expect(reading(panel, "Light")).to_have_text("lightblue")
    color(stage, "off")
    expect(reading(panel, "Light")).to_have_text("off")
    expect(panel.get_by_role("status")).not_to_contain_text("no colour")


# When they stop


def test_it_stops_without_commands(stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    stop_clock(stage)
    command(stage, 0.5, 0)
    stage.clock.run_for(700)
    expect_power(panel, 50, 50)
    command(stage, 0.4, 0)
    stage.clock.run_for(980)
    expect_power(panel, 40, 40)
    stage.clock.run_for(40)
    expect(panel.get_by_role("status")).to_have_text("Stopped: no command for a second")
    expect_power(panel, 0, 0)


def test_it_stops_when_nobody_publishes(stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    stop_clock(stage)
    command(stage, 0.5, 0)
    stage.clock.run_for(100)
    expect_power(panel, 50, 50)
    stage.evaluate("ros.graph.remove('/dancer')")
    stage.clock.run_for(20)
    expect(panel.get_by_role("status")).to_have_text("Stopped: no publishers on /cmd_vel any more")
    expect_power(panel, 0, 0)
    expect(panel).to_contain_text("/cmd_vel: no publishers")
    # A command that was still on its way.
    command(stage, 0.5, 0)
    stage.clock.run_for(100)
    expect_power(panel, 0, 0)


def test_it_stops_when_the_page_is_hidden(stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    stop_clock(stage)
    command(stage, 0.5, 0)
    stage.clock.run_for(100)
    expect_power(panel, 50, 50)
    hide_tab(stage, True)
    stage.clock.run_for(20)
    expect(panel.get_by_role("status")).to_have_text("Stopped: the page was hidden")
    command(stage, 0.5, 0)
    stage.clock.run_for(100)
    expect_power(panel, 0, 0)


def test_it_stops_at_what_is_no_number(stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    stop_clock(stage)
    command(stage, 0.5, 0)
    stage.clock.run_for(100)
    expect_power(panel, 50, 50)
    stage.evaluate(
        """ros.emit("/cmd_vel", {
          linear: { x: NaN, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } })"""
    )
    stage.clock.run_for(20)
    expect(panel.get_by_role("status")).to_have_text("Stopped: a command was not a number")
    expect_power(panel, 0, 0)


def test_a_page_without_the_types_says_so(stage: Tab) -> None:
    stage.evaluate("delete ros.types['geometry_msgs/msg/Twist']")
    panel = show_robot(stage, kind="diffdrive")
    expect(panel).to_contain_text(
        "/cmd_vel: no node on this page uses geometry_msgs/msg/Twist, so it cannot be read"
    )


def test_nothing_is_left_after_unmount(stage: Tab) -> None:
    stage.evaluate("ros.types['std_msgs/msg/Float32'] = ros.fields('float32 data')")
    panel = show_robot(stage, kind="vernie")
    command(stage, 0.5, 0)
    stage.evaluate("unmount()")
    assert stage.evaluate("[ros.subscriptions.length, ros.closed]") == [0, 2]
    expect(panel).to_be_empty()


@pytest.mark.parametrize(
    ("without", "note"),
    [
        (
            "delete Navigator.prototype.bluetooth",
            "This browser does not support Web Bluetooth. Chrome and Edge do",
        ),
        (
            "Object.defineProperty(window, 'isSecureContext', { value: false })",
            "Browsers allow Bluetooth only on https:// pages and on this computer.",
        ),
    ],
    ids=["no Bluetooth", "no https"],
)
def test_a_page_that_cannot_reach_a_hub(stage: Tab, without: str, note: str) -> None:
    stage.evaluate(without)
    panel = show_robot(stage, kind="vernie")
    expect(panel.get_by_role("status")).to_contain_text(note)
    expect(panel.get_by_role("button", name="Connect")).to_be_disabled()
    stop_clock(stage)
    command(stage, 0.5, 0)
    stage.clock.run_for(150)
    expect_power(panel, 50, 50)


# The demo


@pytest.mark.firefox
def test_demo04_dances(tab: Tab, built: Built, serve: Serve) -> None:
    tab.goto(f"{serve(built(ROOT))}demo04/")
    robot = tab.get_by_role("region", name="Robot")
    colors, dance = Panel(tab, "colors"), Panel(tab, "dance")
    expect(robot).to_contain_text("/cmd_vel: no publishers")

    colors.start()
    expect(reading(robot, "Light")).to_have_text("red")
    expect(reading(robot, "Light")).to_have_text("yellow")
    dance.start()
    expect_power(robot, 80, 80)
    expect(robot).to_contain_text("/color from /color_publisher · /cmd_vel from /dancer")
    expect_power(robot, 35, 85)

    # It waits for a hand, and goes on.
    robot.get_by_label("Hand in front of it").check()
    dance.wait_for("Something is 0.05 m before me")
    expect_power(robot, 0, 0)
    robot.get_by_label("Hand in front of it").uncheck()
    dance.wait_for("The way is free")
    expect_power(robot, 35, 85)

    dance.stop()
    expect_power(robot, 0, 0)
    expect(robot.get_by_role("status")).to_have_text("Stopped: no publishers on /cmd_vel any more")
    assert pose(robot)[:2] != (0, 0)


@pytest.mark.parametrize("kind", ["vernie", "diffdrive"])
def test_a_robot_says_what_it_waits_for(stage: Tab, kind: str) -> None:
    panel = show(stage, "robot", {"kind": kind, "color": "/color", "twist": "/cmd_vel"})
    waits = panel.get_by_text("The robot moves when a node publishes on /cmd_vel.")
    expect(waits).to_be_visible()
    add(stage, "publisher", "/colors", "/color", "std_msgs/msg/String")
    expect(waits).to_be_visible()
    add(stage, "publisher", "/dancer", "/cmd_vel", "geometry_msgs/msg/Twist")
    expect(waits).to_be_hidden()
    stage.evaluate("ros.graph.remove('/dancer')")
    expect(waits).to_be_visible()
