"""The panel of topics: names, rates and echoes."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import add, cells, chatter, show, subscribed

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
