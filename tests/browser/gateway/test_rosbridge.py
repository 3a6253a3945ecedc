"""A C++ node in a page and native nodes, with a server between them that speaks rosbridge only."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from typing import Any

import pytest
from browser import Built
from joined import Gateway, Robot
from native import Native
from paths import SITES
from plainproxy import PlainProxy, plain_proxy
from playwright.sync_api import Browser, Page, expect
from station import CALL, GRAPH, PARAMETERS, printed, state
from terminal import Terminal
from waiting import until

SITE = SITES / "gateway"
# action_msgs/msg/GoalStatus.STATUS_CANCELED
CANCELED = 5
# What the page's own panels would do, in the words of a test.
ADVERTISE = """async ([topic, type]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  globalThis.publisher = ros.advertise(topic, type);
}"""
SUBSCRIBE = """async ([topic, type]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  globalThis.heard = [];
  ros.subscribe(topic, type, ({ data }) => heard.push(String(data)));
}"""


@pytest.fixture(scope="module")
def proxy(
    native: Native, built: Built, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[PlainProxy]:
    gateway = Gateway(native, tmp_path_factory.mktemp("gateway") / "log", built(SITE))
    gateway.start()
    with plain_proxy(gateway.port) as proxy:
        yield proxy
    gateway.stop()


@pytest.fixture
def joined(browser: Browser, proxy: PlainProxy) -> Iterator[Page]:
    """The page with its node, which has joined the robot's graph."""
    context = browser.new_context()
    tab = context.new_page()
    tab.goto(proxy.http)
    expect(state(tab)).to_contain_text("rosbridge")
    tab.get_by_role("button", name="Start", exact=True).first.click()
    yield tab
    context.close()


def test_a_node_of_the_page_and_a_robot_use_each_other(joined: Page, robot: Robot) -> None:
    until(lambda: printed(joined, "heard robot"))
    until(lambda: printed(joined, "charted"))
    assert printed(joined, "charted") == ["charted map of the robot"]
    until(lambda: printed(joined, "answered"))
    assert printed(joined, "answered") == ["answered from the robot"]
    until(lambda: printed(joined, "reached"))
    assert printed(joined, "reached") == ["reached 0 1 1 2 3 5"]
    robot.listen("/page/map", True)
    until(lambda: robot.texts("/page/map"))
    assert robot.texts("/page/map") == ["map of the page"]
    assert robot.call() == "from the page"
    assert robot.goal(5) == {"result": [0, 1, 1, 2, 3, 5], "feedback": 4}
    assert '"double_value":2.5' in joined.evaluate(CALL, PARAMETERS)
    graph = joined.evaluate(GRAPH)
    assert "node /robot /robot" in graph
    assert "service /robot /robot/set" in graph
    # What the page offers is the server's there, and not told again.
    others = [one for one in graph if "/page/" in one and not re.search(r" /(station\b|_)", one)]
    assert others == ["subscription /robot /page/chatter"]
    for numbers in (
        [int(line.split()[2]) for line in printed(joined, "heard robot")],
        [int(text.split()[1]) for text in robot.texts("/page/chatter")],
    ):
        assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))


def test_goals_are_canceled_in_both_directions(joined: Page, robot: Robot) -> None:
    assert robot.cancel() == {"canceling": 1, "canceled": True}
    until(lambda: printed(joined, "reached"))
    before, uuid = robot.pursued(), {"uuid": list(range(16))}

    def call(part: str, kind: str, request: object) -> Any:
        called = [f"/robot/fibonacci/_action/{part}", kind, request]
        return json.loads(joined.evaluate(CALL, called))

    fibonacci = "test_msgs/action/Fibonacci"
    goal = {"goal_id": uuid, "goal": {"order": 1000}}
    assert call("send_goal", f"{fibonacci}_SendGoal", goal)["accepted"]
    until(lambda: robot.pursued() > before)
    canceled = call("cancel_goal", "action_msgs/srv/CancelGoal", {"goal_info": {"goal_id": uuid}})
    assert len(canceled["goals_canceling"]) == 1
    assert call("get_result", f"{fibonacci}_GetResult", {"goal_id": uuid})["status"] == CANCELED
    assert "no goal" not in joined.locator(".ros-connect").inner_text()


@pytest.mark.parametrize(
    ("kind", "texts", "found"),
    [
        ("Int64", "2n ** 62n + 1n, -5n", [2**62 + 1, -5]),
        ("Float64", "0.1, 1e300, Infinity", [0.1, 1e300, math.inf]),
    ],
)
def test_numbers_arrive_as_they_are(
    joined: Page, robot: Robot, kind: str, texts: str, found: list[float]
) -> None:
    there, here = f"/robot/{kind}", f"/page/{kind}"
    # The page has no definition of the type, until the robot tells it.
    robot.publish(there, [], 10, kind)
    robot.listen(here, False, kind)
    until(lambda: f"publisher /robot {there}" in joined.evaluate(GRAPH))
    joined.evaluate(SUBSCRIBE, [there, f"std_msgs/msg/{kind}"])
    joined.evaluate(ADVERTISE, [here, f"std_msgs/msg/{kind}"])
    until(lambda: robot.topic(here)["publishers"] and robot.subscriptions(there) == 1)
    joined.evaluate(f"[{texts}].forEach((data) => publisher.publish({{ data }}))")
    until(lambda: robot.texts(here) == found)
    robot.publish(there, found, 10, kind)
    until(lambda: [type(found[0])(one) for one in joined.evaluate("heard")] == found)


def test_a_page_hears_its_own_messages_once(joined: Page, robot: Robot) -> None:
    joined.evaluate(ADVERTISE, ["/shared", "std_msgs/msg/String"])
    joined.evaluate(SUBSCRIBE, ["/shared", "std_msgs/msg/String"])
    robot.publish("/shared", [], 10)
    robot.listen("/shared", False)
    until(lambda: robot.topic("/shared")["publishers"] and robot.subscriptions("/shared") == 2)
    for number in range(20):
        joined.evaluate("(text) => publisher.publish({ data: text })", f"page {number}")
    joined.evaluate("publisher.publish({ data: 'the same' })")
    until(lambda: "the same" in robot.texts("/shared"))
    # What the robot says is heard, though the page has said it before.
    robot.publish("/shared", ["the same", "the same"], 10)
    robot.publish("/shared", ["end"], 10)
    until(lambda: "end" in joined.evaluate("heard"))
    expected = [f"page {number}" for number in range(20)]
    assert sorted(joined.evaluate("heard")) == sorted([*expected, *["the same"] * 3, "end"])


def test_what_the_robot_cannot_do_is_told(joined: Page, robot: Robot) -> None:
    joined.evaluate(ADVERTISE, ["/robot/chatter", "std_msgs/msg/Int64"])
    expect(joined.locator(".ros-connect-notes")).to_contain_text("/robot/chatter: ")


def test_a_lost_connection_heals_without_ghosts_or_doubles(
    joined: Page, proxy: PlainProxy, robot: Robot
) -> None:
    until(lambda: robot.texts("/page/chatter") and printed(joined, "heard robot"))
    proxy.cut()
    until(lambda: not [one for one in joined.evaluate(GRAPH) if "/robot " in one])
    expect(state(joined)).to_contain_text("Connected to", timeout=20_000)
    until(lambda: "service /robot /robot/set" in joined.evaluate(GRAPH))
    count = len(robot.texts("/page/chatter"))
    until(lambda: len(robot.texts("/page/chatter")) > count + 10)
    for numbers in (
        [int(line.split()[2]) for line in printed(joined, "heard robot")[-10:]],
        [int(text.split()[1]) for text in robot.texts("/page/chatter")[count:]],
    ):
        assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert robot.call() == "from the page"
    joined.get_by_role("button", name="Disconnect").click()
    until(lambda: robot.topic("/page/chatter")["publishers"] == [])


def test_panels_and_the_terminal_of_a_page_without_nodes_reach_the_robot(
    browser: Browser, proxy: PlainProxy, robot: Robot
) -> None:
    tab = browser.new_context().new_page()
    tab.goto(f"{proxy.http}watch/")
    terminal = Terminal(tab)
    terminal.await_names("/robot", "/robot/set", "/robot/get_parameters")
    expect(tab.locator(".ros-topics")).to_contain_text("data: robot")
    assert "/robot" in terminal.run("ros2 node list").splitlines()
    asked = 'ros2 service call /robot/set std_srvs/srv/SetBool "{data: true}"'
    assert "from the robot" in terminal.run(asked)
    assert "Set parameter successful" in terminal.run("ros2 param set /robot gain 4.0")
    assert "Double value is: 4.0" in terminal.run("ros2 param get /robot gain")
    assert terminal.run("ros2 action list") == "/robot/fibonacci"
    count = len(robot.texts("/page/chatter"))
    terminal.run("ros2 topic pub --once /page/chatter std_msgs/msg/String '{data: typed}'")
    until(lambda: robot.texts("/page/chatter")[count:] == ["typed"])
