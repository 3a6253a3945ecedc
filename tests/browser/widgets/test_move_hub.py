"""The real Vernie over Bluetooth: what its hub is sent, what it says, and when it stops."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from bluetooth import MoveHub, move_hub
from browser import Built, Serve
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, Locator, expect
from playwright.sync_api import Page as Tab
from robot import color, command, expect_power, reading, show_robot
from stage import hide_tab, stop_clock

# No other browser has Web Bluetooth.
pytestmark = pytest.mark.chromium


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
    expect(reading(panel, "Robot")).to_have_text("simulated")
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
    hand = panel.get_by_label("Hand in front of it")
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
        "The connection was lost: the hub is off or too far away. Connect again."
    )
    expect(reading(panel, "Robot")).to_have_text("simulated")
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
