"""The panel of services: calls, answers and failures."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import add, serve_sums, show

pytestmark = pytest.mark.firefox


def test_a_service_is_called_with_a_form(stage: Tab) -> None:
    panel = show(stage, "services")
    expect(panel.get_by_text("No services now")).to_be_visible()
    add(stage, "service", "/adder", "/adder/get_parameters", "rcl_interfaces/srv/GetParameters")
    expect(panel.get_by_text("Only hidden services now.")).to_be_visible()
    serve_sums(stage)
    assert panel.locator("li").all_inner_texts() == [
        "/add\ntutorial_interfaces/srv/AddTwoInts\nserved by /adder"
    ]
    panel.get_by_label("Show hidden").check()
    assert panel.locator("li").count() == 2
    panel.get_by_role("button", name="/add").first.click()
    panel.get_by_label("a int64").fill("9007199254740993")
    panel.get_by_label("b int64").fill("one")
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_text("'one' is not a whole number")).to_be_visible()
    expect(panel.get_by_label("b int64")).to_be_focused()
    assert stage.evaluate("ros.calls.length") == 0
    panel.get_by_label("b int64").fill("1")
    panel.get_by_label("b int64").press("Enter")
    expect(panel.get_by_label("response")).to_have_text("sum: 9007199254740994")
    expect(panel.get_by_role("status")).to_contain_text("/add responded in")
    assert stage.evaluate("ros.calls[0].timeout") == 5000
    # A wrong entry leaves the last response, paler and named as what it is, until the next one.
    panel.get_by_label("b int64").fill("two")
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_role("status")).to_have_text("Not called: correct the marked fields")
    previous = panel.get_by_label("previous response")
    expect(previous).to_have_text("sum: 9007199254740994")
    color = "(element) => getComputedStyle(element).color"
    assert previous.evaluate(color) == panel.locator("label > small").first.evaluate(color)
    panel.get_by_label("b int64").fill("2")
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_label("response", exact=True)).to_have_text("sum: 9007199254740995")
    expect(previous).to_have_count(0)


def test_a_call_without_an_answer_is_said_plainly(stage: Tab) -> None:
    panel = show(stage, "services", {"show": ["/add"]})
    expect(
        panel.get_by_text("No server for /add now. Start the node that provides it.")
    ).to_be_visible()
    serve_sums(stage)
    panel.get_by_label("a int64").fill("5")
    stage.evaluate(
        "void (ros.answer = async () => { throw new Error('no response from /add within 5 s'); })"
    )
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_role("status")).to_have_text("no response from /add within 5 s")
    # The server goes: the form stays as it is, and the call tells what the page's ROS says.
    stage.evaluate("ros.graph.remove('/adder')")
    stage.evaluate("void (ros.answer = async () => { throw new Error('no server for /add now'); })")
    expect(panel.get_by_text("no server now")).to_be_visible()
    expect(panel.get_by_label("a int64")).to_have_value("5")
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_role("status")).to_have_text("no server for /add now")


def test_a_service_of_an_unknown_type_is_named(stage: Tab) -> None:
    add(stage, "service", "/arm", "/grip", "arm_msgs/srv/Grip")
    panel = show(stage, "services")
    panel.get_by_role("button", name="/grip").click()
    expect(panel.get_by_role("status")).to_contain_text(
        "this page has no definition of arm_msgs/srv/Grip_Request"
    )
    expect(panel.get_by_role("button", name="Call")).to_be_disabled()


def test_a_request_may_have_no_fields(stage: Tab) -> None:
    add(stage, "service", "/adder", "/reset", "std_srvs/srv/Empty")
    panel = show(stage, "services", {"show": ["/reset"]})
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_label("response")).to_have_text("{}")
