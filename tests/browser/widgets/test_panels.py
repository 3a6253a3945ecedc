"""Panels of topics, services and nodes in a real browser."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import WIDER, add, cells, chatter, hide_tab, show, subscribed
from touch import pale_placeholders, small_targets

pytestmark = pytest.mark.firefox

# What stands where there is no rate.
NONE = "\u2013"


def test_topics_come_and_go_with_their_types_and_numbers(stage: Tab) -> None:
    panel = show(stage, "topics")
    expect(panel.get_by_text("No topics now")).to_be_visible()
    add(stage, "publisher", "/talker", "/rosout", "rcl_interfaces/msg/Log")
    expect(panel.get_by_text("Only hidden topics now.")).to_be_visible()
    chatter(stage)
    add(stage, "publisher", "/talker", "/_hidden", "std_msgs/msg/String")
    add(stage, "subscription", "/_page", "/chatter", "std_msgs/msg/String")
    add(stage, "subscription", "/_page", "/only_asked_for", "std_msgs/msg/String")
    assert cells(panel) == [f"/chatter std_msgs/msg/String 1 1 {NONE}"]
    row = panel.locator("tbody tr")
    assert row.locator("td").nth(1).locator("span").get_attribute("title") == "/listener"
    panel.get_by_label("Show hidden").check()
    assert [cell.split()[0] for cell in cells(panel)] == ["/_hidden", "/chatter", "/rosout"]
    stage.evaluate("ros.graph.remove('/talker')")
    assert cells(panel) == [f"/chatter std_msgs/msg/String 0 1 {NONE}"]
    stage.evaluate("ros.graph.remove('/listener')")
    assert cells(panel) == []


def test_topics_tell_who_does_not_hear_whom_and_what_was_missed(stage: Tab) -> None:
    chatter(stage)
    panel = show(stage, "topics")
    warnings = panel.locator("tbody p")
    expect(warnings).to_have_count(0)
    policies = ["RELIABILITY", "DURABILITY", "DEADLINE", "LIVELINESS", "TYPE"]
    texts = []
    for policy in policies:
        pair = {"publisher": "/talker", "subscription": "/listener", "policy": policy}
        hidden = {**pair, "subscription": "/_page"}
        stage.evaluate(
            "(pairs) => { ros.graph.mismatches['/chatter'] = pairs; ros.graph.changed(); }",
            [pair, pair, hidden],
        )
        texts.append(warnings.inner_text())
    assert [text.split(":")[0] for text in texts] == [
        f"/listener does not receive from /talker. {policy.capitalize()}" for policy in policies
    ]
    assert texts[0].endswith("the subscription requests reliable, the publisher offers best effort")
    assert len({text.split(":")[1] for text in texts}) == len(policies)
    stage.evaluate(
        """() => {
          ros.graph.mismatches["/chatter"] = [1, 2, 3, 4, 5].map((n) =>
            ({ publisher: "/talker", subscription: `/<b>${n}`, policy: "TYPE" }));
          ros.graph.missed["/chatter"] = 12345;
          ros.graph.changed();
        }"""
    )
    assert warnings.count() == 4
    expect(warnings.last).to_have_text("and 2 more")
    expect(warnings.first).to_contain_text("/<b>1 does not receive from /talker")
    expect(panel.get_by_text("12K missed")).to_have_attribute("title", re.compile("newer ones"))
    stage.evaluate("ros.graph.mismatches = {}; ros.graph.missed = {}; ros.graph.changed()")
    assert cells(panel) == [f"/chatter std_msgs/msg/String 1 1 {NONE}"]


def test_rate_and_bandwidth_are_measured(stage: Tab) -> None:
    chatter(stage)
    panel = show(stage, "topics", {"show": ["/chatter", "/later"]})
    assert [cell.split()[0] for cell in cells(panel)] == ["/chatter", "/later"]
    assert subscribed(stage) == ["/chatter bytes"]
    stage.evaluate(
        """() => {
          let time = performance.timeOrigin + performance.now() - 4000;
          window.publisher = setInterval(() => {
            const now = performance.timeOrigin + performance.now();
            for (; time <= now; time += 20) ros.emit("/chatter", {}, 1500, time);
          }, 10);
        }"""
    )
    expect(panel.locator("tbody td:last-child span").first).to_have_text("50.0 Hz")
    expect(panel.locator("tbody td:last-child small").first).to_have_text("75.0 kB/s")
    stage.evaluate("clearInterval(publisher)")
    # A publisher that is silent slows down, and soon has no rate at all.
    expect(panel.locator("tbody td:last-child span").first).to_have_text(NONE)


def test_a_topic_is_echoed_paused_and_bounded(stage: Tab) -> None:
    chatter(stage)
    panel = show(stage, "topics", {"echo": "/chatter"})
    log = panel.get_by_role("log")
    expect(panel.get_by_text("No message yet")).to_be_visible()
    expect(panel.get_by_text("/talker → /listener")).to_be_visible()
    stage.evaluate("for (let i = 0; i < 200; i++) ros.emit('/chatter', { data: `${i}` })")
    stage.evaluate("frames()")
    texts = log.locator("> *").all_inner_texts()
    assert texts == [f"data: '{number}'\n---" for number in range(150, 200)]
    assert log.evaluate("(e) => e.scrollHeight - e.scrollTop - e.clientHeight") < 2

    panel.get_by_role("button", name="Pause").click()
    assert subscribed(stage) == ["/chatter bytes"]
    panel.get_by_role("button", name="Clear").click()
    expect(panel.get_by_text("Paused")).to_be_visible()
    panel.get_by_role("button", name="Resume").click()
    stage.evaluate("ros.emit('/chatter', { data: '<img src=x>' })")
    expect(log).to_have_text("data: <img src=x>\n---")

    panel.get_by_role("button", name="/chatter").click()
    expect(panel.get_by_text("Choose a topic")).to_be_visible()
    assert subscribed(stage) == ["/chatter bytes"]


def test_an_echo_asks_for_what_the_publishers_offer(stage: Tab) -> None:
    add(stage, "publisher", "/map", "/map", "std_msgs/msg/String", transientLocal=True)
    show(stage, "topics", {"echo": "/map"})
    qos = (
        "(() => { const { qos } = ros.subscriptions.find(({ bytes }) => !bytes);"
        " return [qos.reliable, qos.transientLocal]; })()"
    )
    assert stage.evaluate(qos) == [True, True]
    add(stage, "publisher", "/other", "/map", "std_msgs/msg/String", reliable=False)
    assert stage.evaluate(qos) == [False, False]


def test_a_type_without_definition_is_measured_and_named(stage: Tab) -> None:
    add(stage, "publisher", "/arm", "/grip", "arm_msgs/msg/Grip")
    panel = show(stage, "topics", {"echo": "/grip"})
    expect(panel.get_by_text("This page has no definition of arm_msgs/msg/Grip")).to_be_visible()
    assert subscribed(stage) == ["/grip bytes"]


@pytest.mark.parametrize("kind", ["topics", "log"])
def test_nothing_is_subscribed_while_nobody_looks(stage: Tab, kind: str) -> None:
    chatter(stage)
    show(stage, kind, {"echo": "/chatter"})
    all_of_it = subscribed(stage)
    assert all_of_it
    hide_tab(stage, True)
    assert subscribed(stage) == []
    hide_tab(stage, False)
    assert subscribed(stage) == all_of_it
    # Scrolled away, and in a closed <details>.
    into_details = (
        "{ const row = document.querySelector('.ros-row');"
        " const details = document.createElement('details');"
        " row.replaceWith(details); details.append(row); }"
    )
    for gone, back in [
        ("main.style.marginTop = '9000px'", "main.style.marginTop = ''"),
        (into_details, "document.querySelector('details').open = true"),
    ]:
        stage.evaluate(gone)
        stage.wait_for_function("() => ros.subscriptions.length === 0")
        stage.evaluate(back)
        stage.wait_for_function("(count) => ros.subscriptions.length === count", arg=len(all_of_it))
    stage.evaluate("unmount()")
    assert subscribed(stage) == []
    assert stage.locator("#panel > *").count() == 0


def serve_sums(stage: Tab) -> None:
    add(stage, "service", "/adder", "/add", "tutorial_interfaces/srv/AddTwoInts")
    stage.evaluate("void (ros.answer = async ({ a, b }) => ({ sum: a + b }))")


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


def test_nodes_tell_what_runs_and_what_it_does(stage: Tab) -> None:
    stage.evaluate("ros.addNode('talker', 'cpp_pubsub', 'talker')")
    panel = show(stage, "nodes")
    item = panel.get_by_role("listitem")
    assert item.inner_text().split() == ["talker", "stopped", "cpp_pubsub/talker"]
    stage.evaluate("ros.nodes.get('talker').become('running', 2_500_000)")
    add(stage, "node", "/talker", "", "", program="talker")
    add(stage, "publisher", "/talker", "/chatter", "std_msgs/msg/String", program="talker")
    add(stage, "publisher", "/talker", "/rosout", "rcl_interfaces/msg/Log", program="talker")
    add(stage, "service", "/talker", "/reset", "std_srvs/srv/Empty", program="talker")
    add(stage, "client", "/talker", "/add", "tutorial_interfaces/srv/AddTwoInts", program="talker")
    add(stage, "subscription", "/listener", "/chatter", "std_msgs/msg/String", program="other")
    expect(item.locator(".ros-state")).to_have_text("running")
    expect(item).to_contain_text("2.5 MB of memory")
    assert item.locator("dl").inner_text().split() == [
        "publishes", "/chatter", "serves", "/reset", "calls", "/add"
    ]  # fmt: skip
    panel.get_by_label("Show hidden").check()
    expect(item.locator("dl")).to_contain_text("/rosout")
    expect(item).to_contain_text(re.compile(r"for [1-9]\d* s"))
    stage.evaluate("ros.graph.remove('/talker'); ros.nodes.get('talker').become('failed')")
    expect(item.locator("dl")).to_have_count(0)
    expect(item.locator(".ros-state")).to_have_text("failed")


@pytest.mark.parametrize("kind", ["topics", "nodes", "services", "publish", "graph", "log"])
def test_panels_fit_a_phone(stage: Tab, kind: str) -> None:
    stage.set_viewport_size({"width": 360, "height": 700})
    chatter(stage)
    serve_sums(stage)
    add(
        stage,
        "publisher",
        "/a",
        "/a/very/long/name/of_a_topic/that_has_no_end",
        "a/msg/LongNameOfType",
    )
    stage.evaluate(
        "ros.addNode('talker', 'a_package_with_a_long_name', 'an_executable_with_one_too')"
    )
    panel = show(stage, kind, {"show": ["/add"]} if kind == "services" else {})
    assert stage.evaluate(WIDER) == 0
    assert small_targets(stage) == []
    assert pale_placeholders(stage) == []
    height = panel.evaluate("(e) => e.offsetHeight")
    stage.evaluate("ros.graph.remove('/talker')")
    assert panel.evaluate("(e) => e.offsetHeight") == height


def test_a_row_can_be_clicked_anywhere(stage: Tab) -> None:
    chatter(stage)
    panel = show(stage, "topics")
    pick = panel.get_by_role("button", name="/chatter")
    panel.locator("tbody td").last.click()
    expect(pick).to_have_attribute("aria-pressed", "true")
    # The button in it counts once, by click and by key.
    pick.click()
    expect(pick).to_have_attribute("aria-pressed", "false")
    pick.press("Enter")
    expect(pick).to_have_attribute("aria-pressed", "true")
    # Who selects text has not clicked.
    box = panel.locator("tbody small").first.bounding_box()
    assert box
    stage.mouse.move(box["x"] + 2, box["y"] + 8)
    stage.mouse.down()
    stage.mouse.move(box["x"] + 60, box["y"] + 8)
    stage.mouse.up()
    assert stage.evaluate("getSelection().isCollapsed") is False
    expect(pick).to_have_attribute("aria-pressed", "true")
    stage.evaluate("getSelection().empty(); unmount()")
    serve_sums(stage)
    panel = show(stage, "services")
    panel.get_by_text("served by").click()
    expect(panel.get_by_role("button", name="/add")).to_have_attribute("aria-pressed", "true")
    expect(panel.get_by_role("button", name="Call")).to_be_visible()


def test_cards_of_nodes_line_up(stage: Tab) -> None:
    stage.evaluate(
        """ros.addNode("talker", "a_package_with_a_name_so_long_that_it_takes_two_lines", "talker");
        ros.addNode("listener", "cpp_pubsub", "listener")"""
    )
    add(stage, "publisher", "/talker", "/chatter", "std_msgs/msg/String", program="talker")
    add(stage, "service", "/listener", "/reset", "std_srvs/srv/Empty", program="listener")
    panel = show(stage, "nodes")
    for part in ("li", ".ros-head", ".ros-about", ".ros-graph-nodes"):
        tops = panel.locator(part).evaluate_all("(all) => all.map((e) => e.offsetTop)")
        assert len(tops) == 2
        assert len(set(tops)) == 1, part
    heights = panel.locator("li").evaluate_all("(all) => all.map((e) => e.offsetHeight)")
    assert len(set(heights)) == 1
    columns = panel.locator("dd").evaluate_all(
        "(all) => all.map((e) => e.offsetLeft - e.closest('li').offsetLeft)"
    )
    assert len(set(columns)) == 1


@pytest.mark.parametrize("kind", ["topics", "nodes", "services", "publish", "graph", "log"])
def test_a_panel_says_what_it_waits_for(stage: Tab, kind: str) -> None:
    panel = show(stage, kind)
    if kind == "nodes":
        stage.evaluate("unmount(); ros.addNode('talker', 'cpp_pubsub', 'talker')")
        expect(show(stage, kind)).to_contain_text("stopped")
    else:
        expect(panel.locator(".ros-hint:visible").first).to_contain_text(" ")
