"""Sliders for joints: they publish what joint_state_publisher_gui would."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from stage import show, subscribed
from waiting import until

pytestmark = pytest.mark.firefox

ARM = """<robot name="arm">
  <link name="base"/>
  <joint name="waist" type="continuous"><axis xyz="0 0 1"/></joint>
  <joint name="lift" type="prismatic"><limit lower="0.1" upper="0.5"/></joint>
  <joint name="follower" type="prismatic">
    <limit lower="-9" upper="9"/><mimic joint="lift" multiplier="-2" offset="1"/>
  </joint>
  <joint name="stand" type="fixed"/>
  <joint name="elbow" type="revolute"><limit lower="-1" upper="2"/></joint>
</robot>"""


def joints(stage: Tab, description: str = ARM, **options: Any) -> Locator:
    stage.evaluate("ros.types['sensor_msgs/msg/JointState'] = ros.fields('')")
    panel = show(stage, "joints", options)
    stage.evaluate("(data) => ros.emit('/robot_description', { data })", description)
    return panel


def last(stage: Tab) -> dict[str, Any]:
    """The newest message, by joint."""
    stage.evaluate("frames()")
    found: dict[str, Any] = stage.evaluate(
        """() => {
          const { topic, type, message } = ros.published.at(-1);
          return { topic, type, ...Object.fromEntries(message.name.map((name, index) =>
            [name, Number(message.position[index].toFixed(3))])) };
        }"""
    )
    assert (found.pop("topic"), found.pop("type")) == (
        "/joint_states",
        "sensor_msgs/msg/JointState",
    )
    return found


def test_a_slider_moves_its_joint_and_those_that_mimic_it(stage: Tab) -> None:
    panel = joints(stage)
    expect(panel.locator("label")).to_have_text(["waist", "lift", "elbow"])
    start = {"waist": 0, "lift": 0.3, "follower": 0.4, "elbow": 0}
    assert last(stage) == start
    panel.get_by_label("elbow", exact=True).fill("1.5")
    assert last(stage) == {**start, "elbow": 1.5}
    lift = panel.get_by_label("lift in m")
    lift.fill("7")
    lift.press("Enter")
    # No further than its limit.
    assert last(stage) == {"waist": 0, "lift": 0.5, "follower": 0, "elbow": 1.5}
    assert stage.evaluate("ros.kept().positions") == {"lift": 0.5, "elbow": 1.5}
    stage.emulate_media(reduced_motion="reduce")
    panel.get_by_role("button", name="Center").click()
    assert last(stage) == start
    panel.get_by_role("button", name="Random").click()
    moved = last(stage)
    assert moved != start
    assert 0.1 <= moved["lift"] <= 0.5
    assert -1 <= moved["elbow"] <= 2


def test_joints_start_at_their_zeros(stage: Tab) -> None:
    panel = joints(stage, zeros={"elbow": 1.5, "lift": 7, "unknown": 3})
    start = {"waist": 0, "lift": 0.5, "follower": 0, "elbow": 1.5}
    assert last(stage) == start
    panel.get_by_label("elbow", exact=True).fill("0")
    stage.emulate_media(reduced_motion="reduce")
    panel.get_by_role("button", name="Center").click()
    assert last(stage) == start


def test_joints_move_on_their_way_at_the_speed_of_the_slowest(stage: Tab) -> None:
    stage.emulate_media(reduced_motion="no-preference")
    slow = ARM.replace('<limit lower="-1"', '<limit velocity="3" lower="-1"')
    panel = joints(stage, slow, zeros={"elbow": 2})
    panel.get_by_label("elbow", exact=True).fill("-1")
    count = stage.evaluate("ros.published.length")
    began = stage.evaluate("performance.now()")
    panel.get_by_role("button", name="Center").click()
    until(lambda: last(stage)["elbow"] == 2)
    # 3 rad at 3 rad/s at most, which is the speed in the middle of the way.
    assert stage.evaluate("performance.now()") - began >= 1500
    way = stage.evaluate(
        "(count) => ros.published.slice(count).map(({ message }) => message.position[3])", count
    )
    assert way == sorted(way)
    assert len(set(way)) > 5


def test_a_slider_ends_the_motion(stage: Tab) -> None:
    stage.emulate_media(reduced_motion="no-preference")
    panel = joints(stage)
    panel.get_by_label("waist", exact=True).fill("3")
    panel.get_by_role("button", name="Center").click()
    panel.get_by_label("elbow", exact=True).fill("1")
    stopped = last(stage)
    assert stopped["waist"] > 0
    stage.evaluate("frames(20)")
    assert last(stage) == stopped


def test_positions_come_back_with_a_link(stage: Tab) -> None:
    stage.evaluate("ros.given = { positions: { elbow: 1.25, lift: 'x', unknown: 3 } }")
    joints(stage)
    assert last(stage) == {"waist": 0, "lift": 0.3, "follower": 0.4, "elbow": 1.25}


def test_it_goes_on_publishing_until_it_is_closed(stage: Tab) -> None:
    joints(stage)
    count = stage.evaluate("ros.published.length")
    stage.wait_for_function("(count) => ros.published.length > count + 3", arg=count)
    assert subscribed(stage) == ["/robot_description"]
    stage.evaluate("unmount()")
    assert subscribed(stage) == []
    assert stage.evaluate("ros.closed") == 1


@pytest.mark.parametrize(
    ("description", "said"),
    [
        ("<sdf/>", "not a robot description"),
        ("this is no XML", "not a robot description"),
        ("<robot><joint name='a' type='fixed'/></robot>", "no joints that move"),
    ],
)
def test_what_is_wrong_is_said(stage: Tab, description: str, said: str) -> None:
    expect(joints(stage, description)).to_contain_text(said)


def test_a_circle_of_mimics_is_no_trap(stage: Tab) -> None:
    circle = """<robot>
      <joint name="a" type="continuous"><mimic joint="b"/></joint>
      <joint name="b" type="continuous"><mimic joint="a"/></joint>
      <joint name="c" type="continuous"/></robot>"""
    joints(stage, circle)
    assert last(stage) == {"a": 0, "b": 0, "c": 0}


def test_a_page_without_the_type_says_so(stage: Tab) -> None:
    expect(show(stage, "joints")).to_contain_text("no node on this page uses sensor_msgs/msg/Joint")
