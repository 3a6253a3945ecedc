"""A page and a rosbridge_server as most robots have it, which tells little and fails silently."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Built, serving
from olderbridge import OlderBridge, older_bridge
from playwright.sync_api import Browser, Locator, Page, expect
from station import CALL, GRAPH, state
from waiting import until

from sitegen.__main__ import main

SITE = """
site: {{title: Robot}}
connect: {{addresses: ["ws://127.0.0.1:{port}"], autoconnect: true}}
pages:
  - path: /
    title: Robot
    content:
      - publish: {{topic: /shared, type: std_msgs/msg/String}}
      - topics:
"""
# What a terminal loads when it is used: definitions that the page does not have at first.
LEARN = """async () => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  const define = (name, ...fields) => (ros.types[name] = {
    fields: fields.map(([type, name]) => ({ type, name })), constants: [],
  });
  define("std_srvs/srv/SetBool_Request", ["bool", "data"]);
  define("std_srvs/srv/SetBool_Response", ["bool", "success"], ["string", "message"]);
  define("odd_msgs/msg/Odd", ["string", "data"]);
}"""
SET = ["/robot/set", "std_srvs/srv/SetBool", {"data": True}]
# The page publishes, and hears a topic.
PUBLISH = """async ([topic, type, count]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  globalThis.publishers ??= {};
  publishers[topic] ??= ros.advertise(topic, type);
  for (let n = 0; n < count; n++) publishers[topic].publish({ data: `page ${n}` });
}"""
SUBSCRIBE = """async ([topic, type]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  globalThis.heard ??= {};
  heard[topic] = [];
  ros.subscribe(topic, type, (message) => heard[topic].push(message));
}"""
KEPT = """async () => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  globalThis.kept = [];
  const wanted = { reliable: true, transientLocal: true, depth: 1 };
  const reader = ros.node("/reader");
  reader.subscribe("/robot/chatter", "std_msgs/msg/String", (one) => kept.push(one), wanted);
}"""
SLOW = """async () => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  globalThis.slow = ros.call("/robot/slow", "std_srvs/srv/SetBool", { data: true }, 60000);
}"""


@pytest.fixture
def bridge() -> Iterator[OlderBridge]:
    with older_bridge() as bridge:
        yield bridge


@pytest.fixture
def tab(browser: Browser, site: Path, built: Built) -> Iterator[Page]:
    with serving(built(site)) as address:
        context = browser.new_context()
        tab = context.new_page()
        tab.goto(address)
        expect(state(tab)).to_contain_text("(jazzy, rosbridge)")
        until(lambda: "service /robot /robot/slow" in tab.evaluate(GRAPH))
        tab.evaluate(LEARN)
        yield tab
        context.close()


@pytest.fixture
def site(bridge: OlderBridge, tmp_path: Path) -> Path:
    folder = tmp_path / "robot"
    folder.mkdir()
    folder.joinpath("site.yaml").write_text(SITE.format(port=bridge.port))
    return folder


def notes(tab: Page) -> Locator:
    return tab.locator(".ros-connect-notes")


def publish(tab: Page, bridge: OlderBridge, topic: str, kind: str) -> None:
    """Let the page publish until a message arrives: the first ones have no subscription yet."""

    def arrives() -> bool:
        tab.evaluate(PUBLISH, [topic, kind, 1])
        return bool(bridge.operations("publish", topic=topic))

    until(arrives)


def test_what_the_page_offers_is_not_told_again_nor_heard_twice(
    tab: Page, bridge: OlderBridge
) -> None:
    tab.evaluate(SUBSCRIBE, ["/shared", "std_msgs/msg/String"])
    tab.evaluate(PUBLISH, ["/shared", "std_msgs/msg/String", 0])
    until(lambda: "subscription /robot /shared" in tab.evaluate(GRAPH))
    until(lambda: "/shared" in bridge.advertised)
    # The server has been asked for its topics since.
    asked = len(bridge.operations("call_service", service="/rosapi/node_details"))
    until(
        lambda: len(bridge.operations("call_service", service="/rosapi/node_details")) > asked + 6
    )
    assert "publisher /rosbridge_websocket /shared" not in tab.evaluate(GRAPH)
    assert "publisher /rosbridge_websocket /connected_clients" in tab.evaluate(GRAPH)
    tab.evaluate(PUBLISH, ["/shared", "std_msgs/msg/String", 3])
    until(lambda: len(bridge.operations("publish", topic="/shared")) == 3)
    tab.evaluate(CALL, SET)
    assert len(tab.evaluate("heard['/shared']")) == 3


def test_cbor_is_asked_for_only_if_the_server_can_write_it(tab: Page, bridge: OlderBridge) -> None:
    tab.evaluate(SUBSCRIBE, ["/robot/scan", "robot_msgs/msg/Scan"])
    tab.evaluate(SUBSCRIBE, ["/robot/odom", "robot_msgs/msg/Odometry"])
    until(lambda: tab.evaluate("heard['/robot/scan'].length && heard['/robot/odom'].length"))
    ranges = tab.evaluate("[...heard['/robot/scan'][0].ranges].map(String)")
    assert ranges == ["1.5", "Infinity"]
    covariance = tab.evaluate("[...heard['/robot/odom'][0].pose.covariance].map(String)")
    assert covariance == ["0.25", "NaN"]
    compressions = {one["topic"]: one["compression"] for one in bridge.operations("subscribe")}
    assert compressions["/robot/scan"] == "cbor"
    assert compressions["/robot/odom"] == "none"


def test_what_the_server_does_not_take_is_told_and_not_sent(tab: Page, bridge: OlderBridge) -> None:
    publish(tab, bridge, "/odd", "odd_msgs/msg/Odd")
    expect(notes(tab)).to_contain_text("/odd: the robot's server has not taken it", timeout=20_000)
    sent = len(bridge.operations("publish", topic="/odd"))
    tab.evaluate(PUBLISH, ["/odd", "odd_msgs/msg/Odd", 3])
    publish(tab, bridge, "/shared", "std_msgs/msg/String")
    assert len(bridge.operations("publish", topic="/odd")) == sent


def test_a_slow_service_holds_nothing_up(tab: Page, bridge: OlderBridge) -> None:
    tab.evaluate(SLOW)
    until(lambda: bridge.operations("call_service", service="/robot/slow"))
    assert "from the robot" in tab.evaluate(CALL, SET)
    publish(tab, bridge, "/shared", "std_msgs/msg/String")
    bridge.release()
    assert tab.evaluate("slow.then(({ message }) => message)") == "from the robot"


def test_a_node_gets_what_a_topic_keeps_of_any_name(tab: Page) -> None:
    """The server does not tell which topics keep messages."""
    tab.evaluate(KEPT)
    until(lambda: tab.evaluate("kept.length"))
    assert "subscription /reader /robot/chatter" in tab.evaluate(GRAPH)


def test_the_type_of_an_action_is_learned_from_the_error(tab: Page) -> None:
    until(
        lambda: "service /rosbridge_websocket /robot/count/_action/send_goal" in tab.evaluate(GRAPH)
    )


def test_a_server_that_stands_still_and_one_without_rosapi_are_told(
    tab: Page, bridge: OlderBridge
) -> None:
    bridge.silent = True
    expect(state(tab)).to_contain_text("does not answer", timeout=10_000)
    bridge.silent = False
    expect(state(tab)).to_contain_text("Connected to")
    bridge.has_rosapi = False
    expect(notes(tab)).to_contain_text("rosapi: Service /rosapi/", timeout=20_000)
    assert "from the robot" in tab.evaluate(CALL, SET)


def test_a_page_that_is_a_single_file_joins_it(
    browser: Browser, site: Path, tmp_path: Path
) -> None:
    file = tmp_path / "one.html"
    assert main(["build", str(site), "--single-file", "/", "--output", str(file)]) == 0
    context = browser.new_context()
    tab = context.new_page()
    tab.goto(file.as_uri())
    expect(state(tab)).to_contain_text("(jazzy, rosbridge)")
    expect(tab.locator(".ros-connect-nodes")).to_contain_text("/robot")
    context.close()
