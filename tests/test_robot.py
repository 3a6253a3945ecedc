"""Robots in a real browser: how they move, when they stop, and what a real one is sent."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from bluetooth import MoveHub, move_hub
from browser import Built, Serve
from panel import Panel
from playwright.sync_api import Browser, Locator, expect
from playwright.sync_api import Page as Tab
from stage import add, hide_tab, show, stop_clock

from sitegen.config.schema import ROBOTS, WIDGETS

ROOT = Path(__file__).parent.parent
ROBOT_FILES = ROOT / "sitegen/runtime/robots"


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
    found = panel.locator("svg > g > g").get_attribute("transform") or ""
    x, y, turn = (float(number) for number in re.findall(r"-?[\d.]+(?:e-?\d+)?", found))
    return x, y, turn


def expect_power(panel: Locator, a: int, b: int) -> None:
    expect(reading(panel, "Motor A")).to_have_text(f"{a} %")
    expect(reading(panel, "Motor B")).to_have_text(f"{b} %")


# The family


def test_every_kind_is_a_file_and_every_option_is_a_key() -> None:
    assert sorted(file.stem for file in ROBOT_FILES.glob("*.js")) == sorted(ROBOTS)
    keys = {key.name for key in WIDGETS["robot"]} - {"kind"}
    assert {key for own in ROBOTS.values() for key in own} == keys


def test_arcs_are_driven_exactly(stage: Tab) -> None:
    ends = stage.evaluate(
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
    expect(reading(panel, "Place")).to_have_text("0.00, 0.00 m")
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
    expect(reading(panel, "Place")).to_have_text("3.00, -2.00 m")
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
          (await import("./runtime/robots/vernie.js")).motorPower(x, z)""",
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
        "Its light has no colour '<b>mauve</b>'; it knows off, pink,"
    )
    expect(reading(panel, "Light")).to_have_text("lightblue")
    color(stage, "off")
    expect(panel.get_by_role("status")).to_have_text("")
    expect(reading(panel, "Light")).to_have_text("off")


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
    expect(panel.get_by_role("status")).to_have_text(
        "Stopped: nobody publishes on /cmd_vel any more"
    )
    expect_power(panel, 0, 0)
    expect(panel).to_contain_text("/cmd_vel: nobody publishes")
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
        "/cmd_vel: no node of this page uses geometry_msgs/msg/Twist, so it cannot be read"
    )


def test_nothing_is_left_after_unmount(stage: Tab) -> None:
    stage.evaluate("ros.types['std_msgs/msg/Float32'] = ros.fields('float32 data')")
    panel = show_robot(stage, kind="vernie")
    command(stage, 0.5, 0)
    stage.evaluate("unmount()")
    assert stage.evaluate("[ros.subscriptions.length, ros.closed]") == [0, 2]
    expect(panel).to_be_empty()


# The real Vernie


def motors(a: int, b: int) -> list[str]:
    """What tells the motors A and B to turn with that power."""
    return [f"08 00 81 {port:02x} 11 51 00 {power & 0xFF:02x}" for port, power in ((0, a), (1, b))]


def light(color: int) -> str:
    return f"08 00 81 32 11 51 00 {color:02x}"


# Battery and button are to be reported, the light takes numbers of colours, and is off at first.
GREETING = ["05 00 01 06 02", "05 00 01 02 02", "0a 00 41 32 00 01 00 00 00 00", light(0)]


@pytest.fixture
def hub(browser: Browser, tab: Tab) -> Iterator[MoveHub]:
    """A Move Hub in reach; it comes before the page that talks to it."""
    hub = move_hub(browser, tab)
    yield hub
    hub.switch_off()


def connect(panel: Locator, hub: MoveHub) -> None:
    panel.get_by_role("button", name="Connect").click()
    expect(panel.get_by_role("button", name="Disconnect")).to_be_visible()
    expect_bytes(hub, GREETING)


def expect_bytes(hub: MoveHub, expected: list[str]) -> None:
    """Expect these messages, and not one more."""
    wait_until(hub, lambda got: len(got) >= len(expected))
    assert hub.take() == expected


def wait_until(hub: MoveHub, enough: Callable[[list[str]], bool]) -> None:
    """Wait until the messages that the hub got are enough."""
    for _ in range(1200):
        if enough(hub.messages):
            return
        hub.tab.wait_for_timeout(50)
    raise AssertionError(f"not enough: {hub.messages}")


def halted(got: list[str]) -> bool:
    """Whether the last that each motor was told is to stop."""
    last = {message[:-3]: message for message in got}
    return set(motors(0, 0)) <= set(last.values())


def test_the_hub_is_sent_colors_and_power(hub: MoveHub, stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    expect(reading(panel, "Robot")).to_have_text("simulated here")
    connect(panel, hub)
    expect(reading(panel, "Robot")).to_have_text("Move Hub")
    stop_clock(stage)
    color(stage, "red")
    expect_bytes(hub, [light(9)])
    color(stage, "mauve")
    color(stage, "blue")
    expect_bytes(hub, [light(3)])
    command(stage, 0.5, 0.1)
    stage.clock.run_for(50)
    expect_bytes(hub, motors(40, 60))
    command(stage, 0.5, -0.1)
    stage.clock.run_for(50)
    expect_bytes(hub, motors(60, 40))
    # Only what changes is sent.
    command(stage, 0.5, -0.1)
    command(stage, 0.4, 0)
    stage.clock.run_for(50)
    expect_bytes(hub, motors(40, 40)[:1])
    command(stage, -1, 1)
    stage.clock.run_for(50)
    expect_bytes(hub, motors(-100, 0))
    command(stage, 0, 0)
    stage.clock.run_for(50)
    expect_bytes(hub, motors(0, 0)[:1])


def test_what_comes_too_fast_is_not_queued(hub: MoveHub, stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    connect(panel, hub)
    stop_clock(stage)
    for hundredth in range(1, 101):
        command(stage, hundredth / 100, 0)
        stage.clock.run_for(10)
    stage.clock.run_for(50)
    wait_until(hub, lambda got: got[-2:] == motors(100, 100))
    # Of this second both motors are written every 50 ms.
    assert len(hub.take()) <= 2 * 21
    # Faster than any node: of 1000 commands in one go only the last is sent.
    stage.evaluate(
        """() => {
          for (let n = 1; n <= 1000; n++) {
            ros.emit("/cmd_vel", {
              linear: { x: -n / 1000, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } });
          }
        }"""
    )
    stage.clock.run_for(50)
    expect_bytes(hub, motors(-100, -100))


def test_the_hub_stops_without_commands(hub: MoveHub, stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    connect(panel, hub)
    commanded: float = stage.evaluate("performance.now()")
    command(stage, 0.5, 0)
    wait_until(hub, halted)
    got = hub.take()
    assert got[:2] == motors(50, 50)
    assert sorted(set(got[2:])) == motors(0, 0)
    stopped = next(time for time, message in hub.written() if message in motors(0, 0))
    assert stopped - commanded >= 1000


@pytest.mark.parametrize("end", ["publisher", "hidden", "closed", "disconnect", "unmount"])
def test_the_hub_stops_at_once(hub: MoveHub, stage: Tab, end: str) -> None:
    panel = show_robot(stage, kind="vernie")
    connect(panel, hub)
    stop_clock(stage)
    command(stage, 0.5, 0.2)
    stage.clock.run_for(50)
    expect_bytes(hub, motors(30, 70))
    if end == "publisher":
        stage.evaluate("ros.graph.remove('/dancer')")
    elif end == "hidden":
        hide_tab(stage, True)
    elif end == "closed":
        stage.goto("about:blank")
    elif end == "disconnect":
        panel.get_by_role("button", name="Disconnect").click()
    else:
        stage.evaluate("unmount()")
    wait_until(hub, halted)
    assert sorted(set(hub.take())) == motors(0, 0)
    # What comes late moves nothing, nor is there more than the stop, which is told twice.
    if end in ("publisher", "hidden"):
        command(stage, 1, 0)
        stage.clock.run_for(150)
    stage.wait_for_timeout(150)
    assert set(hub.take()) <= set(motors(0, 0))


def test_what_the_hub_senses_is_shown_and_published(hub: MoveHub, stage: Tab) -> None:
    stage.evaluate(
        """() => {
          ros.types["std_msgs/msg/Float32"] = ros.fields("float32 data");
          ros.types["std_msgs/msg/Bool"] = ros.fields("bool data");
        }"""
    )
    panel = show_robot(stage, kind="vernie")
    hand = panel.get_by_label("Hand before it")
    expect(hand).to_be_visible()
    connect(panel, hub)
    expect(hand).to_be_hidden()
    hub.say("06 00 01 06 06 57")
    expect(reading(panel, "Battery")).to_have_text("87 %")
    hub.say("06 00 01 02 06 01")
    expect(reading(panel, "Button")).to_have_text("pressed")
    # The sensors say where they are, and are asked to report.
    hub.say("0f 00 04 02 01 25 00 00 00 00 10 00 00 00 10")
    hub.say("0f 00 04 3a 01 28 00 00 00 00 10 00 00 00 02")
    expect_bytes(hub, ["0a 00 41 02 08 01 00 00 00 01", "0a 00 41 3a 00 01 00 00 00 01"])
    hub.say("08 00 45 02 ff 04 00 02")
    expect(reading(panel, "Distance")).to_have_text("0.09 m")
    hub.say("08 00 45 02 ff 0a 00 00")
    expect(reading(panel, "Distance")).to_have_text("free")
    hub.say("06 00 45 3a f6 2d")
    expect(reading(panel, "Tilt")).to_have_text("-10°, 45°")
    published = stage.evaluate("ros.published.map(({ topic, message }) => [topic, message])")
    assert published == [
        ["/vernie/button", {"data": True}],
        ["/vernie/distance", {"data": pytest.approx(0.0943)}],
        ["/vernie/distance", {"data": float("inf")}],
        [
            "/vernie/tilt",
            {"x": pytest.approx(-0.1745, 1e-3), "y": pytest.approx(0.7854, 1e-3), "z": 0},
        ],
    ]


def test_a_connection_that_is_lost(hub: MoveHub, stage: Tab) -> None:
    panel = show_robot(stage, kind="vernie")
    connect(panel, hub)
    stop_clock(stage)
    command(stage, 0.5, 0)
    stage.clock.run_for(50)
    expect_bytes(hub, motors(50, 50))
    hub.disappear()
    expect(panel.get_by_role("button", name="Connect", exact=True)).to_be_enabled()
    stage.clock.run_for(150)
    expect(panel.get_by_role("status")).to_have_text(
        "The connection was lost: the hub is off, or too far away. Connect again."
    )
    expect(reading(panel, "Robot")).to_have_text("simulated here")
    command(stage, 0.4, 0)
    stage.clock.run_for(150)
    expect_power(panel, 40, 40)
    assert hub.take() == []


def test_a_hub_that_is_not_chosen(hub: MoveHub, stage: Tab) -> None:
    hub.chosen = False
    panel = show_robot(stage, kind="vernie")
    panel.get_by_role("button", name="Connect").click()
    expect(panel.get_by_role("status")).to_contain_text("No hub was chosen. Press the green button")
    hub.chosen = True
    connect(panel, hub)
    expect(panel.get_by_role("status")).to_have_text("")


def test_a_hub_that_does_not_answer(hub: MoveHub, stage: Tab) -> None:
    hub.answers = False
    panel = show_robot(stage, kind="vernie")
    panel.get_by_role("button", name="Connect").click()
    expect(panel.get_by_role("status")).to_contain_text("The hub does not answer. Is it on, near,")
    expect(panel.get_by_role("button", name="Connect")).to_be_enabled()


@pytest.mark.parametrize(
    ("without", "note"),
    [
        (
            "delete Navigator.prototype.bluetooth",
            "This browser has no Web Bluetooth. Chrome and Edge have it",
        ),
        (
            "Object.defineProperty(window, 'isSecureContext', { value: false })",
            "Browsers allow Bluetooth on pages from https:// and from this computer only.",
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


def test_demo04_reaches_the_hub(hub: MoveHub, tab: Tab, built: Built, serve: Serve) -> None:
    tab.goto(f"{serve(built(ROOT))}demo04/")
    robot = tab.get_by_role("region", name="Robot")
    connect(robot, hub)
    colors, dance = Panel(tab, "colors"), Panel(tab, "dance")
    colors.start()
    wait_until(hub, lambda got: len(got) >= 2)
    assert hub.messages[:2] == [light(9), light(7)]
    colors.stop()
    hub.take()
    # Its steps come again and again.
    dance.start()
    wait_until(hub, lambda got: {*motors(80, 80), *motors(35, 85)} <= set(got))
    dance.stop()
    expect_power(robot, 0, 0)
    wait_until(hub, halted)


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
    assert pose(robot)[:2] != (0, 0)
