"""What all panels have in common, and the panel of nodes."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import WIDER, add, chatter, hide_tab, serve_sums, show, subscribed
from touch import pale_placeholders, small_targets

pytestmark = pytest.mark.firefox


# What stands where there is no rate.
NONE = "\u2013"


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


@pytest.mark.parametrize("kind", ["topics", "log"])
def test_panels_that_are_far_away_are_printed(stage: Tab, kind: str) -> None:
    chatter(stage)
    show(stage, kind, {"echo": "/chatter"})
    all_of_it = subscribed(stage)
    stage.evaluate("main.style.marginTop = '9000px'")
    stage.wait_for_function("() => ros.subscriptions.length === 0")
    stage.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert subscribed(stage) == all_of_it
    stage.evaluate("dispatchEvent(new Event('afterprint'))")
    assert subscribed(stage) == []
    stage.evaluate("unmount()")
    stage.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert subscribed(stage) == []


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
