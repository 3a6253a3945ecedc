"""The panel that publishes messages."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import add, chatter, show

pytestmark = pytest.mark.firefox


def test_a_message_is_published_once_and_repeated(stage: Tab) -> None:
    panel = show(stage, "publish", {"topic": "/cmd_vel"})
    expect(panel.get_by_text("No node uses /cmd_vel now")).to_be_visible()
    add(stage, "subscription", "/robot", "/cmd_vel", "geometry_msgs/msg/Twist")
    panel.get_by_label("x float64").first.fill("0.25")
    panel.get_by_role("button", name="Publish once").click()
    expect(panel.get_by_role("status")).to_have_text("1 message published")
    zero = {"x": 0, "y": 0, "z": 0}
    assert stage.evaluate("ros.published") == [
        {"topic": "/cmd_vel", "type": "geometry_msgs/msg/Twist",
         "message": {"linear": {**zero, "x": 0.25}, "angular": zero}}
    ]  # fmt: skip
    rate = panel.get_by_label("messages per second (Hz)")
    rate.fill("1000")
    panel.get_by_role("button", name="Repeat").click()
    expect(panel.get_by_role("status")).to_have_text("The rate must be a number from 0.1 to 100 Hz")
    rate.fill("50")
    panel.get_by_role("button", name="Repeat").click()
    stage.wait_for_function("() => ros.published.length > 10")
    # What is typed meanwhile goes out with the next message; what is no message stops it.
    panel.get_by_label("x float64").first.fill("2")
    stage.wait_for_function("() => ros.published.at(-1).message.linear.x === 2")
    panel.get_by_role("button", name="Stop").click()
    count = stage.evaluate("ros.published.length")
    stage.wait_for_timeout(100)
    assert stage.evaluate("ros.published.length") == count
    panel.get_by_role("button", name="Repeat").click()
    panel.get_by_label("x float64").first.fill("fast")
    expect(panel.get_by_text("'fast' is not a number")).to_be_visible()
    expect(panel.get_by_role("status")).to_have_text("Not published: correct the marked fields")
    expect(panel.get_by_role("button", name="Repeat")).to_be_visible()
    stage.evaluate("unmount()")
    assert stage.evaluate("ros.closed") == 1


def test_the_visitor_chooses_a_topic(stage: Tab) -> None:
    panel = show(stage, "publish")
    expect(panel.get_by_text("No topics to publish on")).to_be_visible()
    chatter(stage)
    add(stage, "subscription", "/arm", "/grip", "arm_msgs/msg/Grip")
    add(stage, "subscription", "/robot", "/cmd_vel", "geometry_msgs/msg/Twist")
    choice = panel.get_by_label("topic", exact=True)
    assert choice.locator("option").all_inner_texts() == ["/chatter", "/cmd_vel"]
    panel.get_by_label("data string").fill("hi")
    panel.get_by_role("button", name="Publish once").click()
    choice.select_option("/cmd_vel")
    expect(panel.get_by_label("x float64")).to_have_count(2)
    assert stage.evaluate("[ros.published.length, ros.closed]") == [1, 1]


def test_a_type_makes_a_form_before_anybody_uses_the_topic(stage: Tab) -> None:
    options = {"topic": "/chatter", "type": "std_msgs/msg/String"}
    panel = show(stage, "publish", options)
    panel.get_by_label("data string").fill("first")
    panel.get_by_label("data string").press("Enter")
    assert stage.evaluate("ros.published[0].message") == {"data": "first"}
