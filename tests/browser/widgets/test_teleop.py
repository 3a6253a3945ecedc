"""A stick, keys and a gamepad drive a robot, and let it stand when they are released."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import hide_tab, show

pytestmark = pytest.mark.firefox

PAD = """(held) => {
  navigator.getGamepads = () => [null, {
    connected: true, axes: [-0.5, -1, 0.05],
    buttons: [4, 0, 0, 0, held].map((one) => ({ pressed: Boolean(one) })),
  }];
}"""  # fmt: skip


def commands(stage: Tab, topic: str = "/cmd_vel") -> list[tuple[float, float]]:
    """The speeds that were published, each once."""
    found = stage.evaluate(
        """(topic) => ros.published.filter((each) => each.topic === topic).map(({ message }) => {
          const { linear, angular } = message.twist ?? message;
          return [Number(linear.x.toFixed(2)), Number(angular.z.toFixed(2))];
        })""",
        topic,
    )
    return [
        (x, z) for index, (x, z) in enumerate(found) if index == 0 or found[index - 1] != [x, z]
    ]


def test_the_stick_drives_while_it_is_held(stage: Tab) -> None:
    panel = show(stage, "teleop", {"linear": "0.4", "angular": "2"})
    box = panel.locator(".ros-stick").bounding_box()
    assert box
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    assert commands(stage) == []
    stage.mouse.move(*middle)
    stage.mouse.down()
    stage.mouse.move(middle[0], box["y"] - 50)
    expect(panel.get_by_text("0.40 m/s, 0.00 rad/s")).to_be_visible()
    stage.mouse.move(box["x"], middle[1])
    expect(panel.get_by_text("0.00 m/s, 2.00 rad/s")).to_be_visible()
    count = stage.evaluate("ros.published.length")
    stage.wait_for_function("(count) => ros.published.length > count + 2", arg=count)
    stage.mouse.up()
    driven = commands(stage)
    assert driven[-3:] == [(0.4, 0), (0, 2), (0, 0)]
    # Zero is published once.
    count = stage.evaluate("ros.published.length")
    stage.wait_for_timeout(350)
    assert stage.evaluate("ros.published.length") == count


def test_keys_drive_while_the_stick_has_the_focus(stage: Tab) -> None:
    panel = show(stage, "teleop")
    panel.locator(".ros-stick").focus()
    stage.keyboard.down("ArrowUp")
    stage.keyboard.down("a")
    stage.keyboard.up("a")
    stage.keyboard.up("ArrowUp")
    assert commands(stage) == [(0.5, 0), (0.5, 1), (0.5, 0), (0, 0)]
    stage.keyboard.down("s")
    panel.get_by_label("Speed").focus()
    assert commands(stage)[-2:] == [(-0.5, 0), (0, 0)]


def test_a_dead_man_switch_must_be_held(stage: Tab) -> None:
    panel = show(stage, "teleop", {"deadman": True})
    panel.locator(".ros-stick").focus()
    stage.keyboard.down("ArrowUp")
    assert commands(stage) == []
    stage.keyboard.up("ArrowUp")
    stage.keyboard.down("Shift")
    stage.keyboard.down("ArrowUp")
    assert commands(stage) == [(0.5, 0)]
    stage.keyboard.up("Shift")
    assert commands(stage) == [(0.5, 0), (0, 0)]
    stage.evaluate(PAD, 0)
    stage.wait_for_timeout(250)
    assert commands(stage) == [(0.5, 0), (0, 0)]
    stage.evaluate(PAD, 1)
    stage.wait_for_function("() => ros.published.at(-1).message.linear.x > 0")
    assert commands(stage)[-1] == (0.5, 0.5)


def test_a_gamepad_drives_and_is_published(stage: Tab) -> None:
    stage.evaluate("ros.types['sensor_msgs/msg/Joy'] = ros.fields('')")
    stage.evaluate(PAD, 0)
    show(stage, "teleop", {"joy": "/joy"})
    stage.wait_for_function("() => ros.published.some(({ topic }) => topic === '/cmd_vel')")
    assert commands(stage) == [(0.5, 0.5)]
    joy: dict[str, Any] = stage.evaluate(
        "() => { const { message } = ros.published.find(({ topic }) => topic === '/joy');"
        " return { axes: [...message.axes], buttons: [...message.buttons] }; }"
    )
    assert joy["axes"] == pytest.approx([0.5, 1, -0.05])
    assert joy["buttons"] == [1, 0, 0, 0, 0]


def test_a_robot_stands_when_the_page_is_hidden(stage: Tab) -> None:
    stage.evaluate("ros.types['geometry_msgs/msg/TwistStamped'] = ros.fields('')")
    panel = show(stage, "teleop", {"topic": "/drive", "stamped": True})
    panel.locator(".ros-stick").focus()
    stage.keyboard.down("ArrowUp")
    hide_tab(stage, True)
    assert commands(stage, "/drive") == [(0.5, 0), (0, 0)]
    assert "header" in stage.evaluate("ros.published[0].message")


def test_speeds_are_set_and_travel_in_links(stage: Tab) -> None:
    panel = show(stage, "teleop", {"linear": "0.2"})
    panel.get_by_label("Speed").fill("0.4")
    assert stage.evaluate("ros.kept()") == {"linear": "0.4", "angular": ""}
    stage.evaluate("() => { unmount(); ros.given = { linear: '0.3', angular: '99' }; }")
    panel = show(stage, "teleop", {"linear": "0.2"})
    expect(panel).to_contain_text("0.30 m/s")
    assert stage.evaluate("ros.odd") == 1


def test_a_page_without_the_type_says_so(stage: Tab) -> None:
    panel = show(stage, "teleop", {"stamped": True})
    expect(panel).to_contain_text("no node on this page uses geometry_msgs/msg/TwistStamped")


def test_a_robot_stops_whatever_happens_to_the_gamepad(stage: Tab) -> None:
    stage.evaluate(
        """() => {
          ros.types["sensor_msgs/msg/Joy"] = ros.fields("");
          const { advertise } = ros;
          const full = { publish() { throw new Error("the queue is full"); }, close() {} };
          ros.advertise = (topic, type) => (topic === "/joy" ? full : advertise(topic, type));
        }"""
    )
    stage.evaluate(PAD, 0)
    panel = show(stage, "teleop", {"joy": "/joy"})
    stage.wait_for_function("ros.published.some(({ message }) => message.linear.x > 0.4)")
    expect(panel.locator(".ros-note")).to_have_text("the queue is full")
    stage.evaluate(PAD.replace("[-0.5, -1, 0.05]", "[0, 0, 0]"), 0)
    stage.wait_for_function("ros.published.at(-1).message.linear.x === 0")
    assert commands(stage)[-1] == (0, 0)


def test_stamps_follow_simulated_time(stage: Tab) -> None:
    stage.evaluate(
        """() => {
          ros.types["geometry_msgs/msg/TwistStamped"] = ros.fields("");
          ros.types["rosgraph_msgs/msg/Clock"] = ros.fields("");
          ros.graph.add("publisher", "/player", "/clock", "rosgraph_msgs/msg/Clock");
        }"""
    )
    panel = show(stage, "teleop", {"stamped": True})
    stage.evaluate("ros.emit('/clock', { clock: { sec: 7, nanosec: 0 } })")
    panel.locator(".ros-stick").press("ArrowUp")
    assert stage.evaluate("ros.published[0].message.header.stamp.sec") == 7
