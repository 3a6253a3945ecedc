"""The page of tests/sites/gateway, whose node does all that nodes do with a native robot."""

from __future__ import annotations

import re

from joined import Robot
from playwright.sync_api import Locator, Page
from terminal import Terminal
from waiting import until

GRAPH = """async () => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  return ros.graph.endpoints().map(({ kind, node, name }) => `${kind} ${node} ${name}`);
}"""
CALL = """async ([service, type, request]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  return JSON.stringify(await ros.call(service, type, request),
    (key, value) => (typeof value === "bigint" ? Number(value) : value));
}"""
PARAMETERS = ["/robot/get_parameters", "rcl_interfaces/srv/GetParameters", {"names": ["gain"]}]


def state(tab: Page) -> Locator:
    """Return the line about its connection."""
    return tab.locator(".ros-connect-state")


def printed(tab: Page, text: str) -> list[str]:
    """The lines of the station that begin with a text."""
    lines: list[str] = tab.locator(".ros-console").first.inner_text().splitlines()
    found = (re.search(rf"\[station\]: ({text}.*)", line) for line in lines)
    return [one.group(1) for one in found if one]


def cancel_a_goal(terminal: Terminal) -> None:
    """A visitor sends the robot a goal that it would pursue for ever, and cancels it."""
    action, kind = "/robot/fibonacci", "test_msgs/action/Fibonacci"
    terminal.begin(f"ros2 action send_goal {action} {kind} '{{order: 1000}}'")
    terminal.wait_for("accepted")
    terminal.interrupt()
    assert "Goal canceled." in terminal.text()


def use_each_other(joined: Page, robot: Robot) -> None:
    """The station of a page and the robot use all that the other one has."""
    until(lambda: "/station" in robot.nodes())
    until(lambda: printed(joined, "heard robot"))
    # What was published before it looked, for the subscription that asks for that alone.
    until(lambda: printed(joined, "charted"))
    assert printed(joined, "charted") == ["charted map of the robot"]
    assert printed(joined, "late") == []
    until(lambda: printed(joined, "answered"))
    assert printed(joined, "answered") == ["answered from the robot"]
    until(lambda: printed(joined, "reached"))
    assert printed(joined, "reached") == ["reached 0 1 1 2 3 5"]
    chatter = {
        "publishers": [["station", "RELIABLE", "VOLATILE"]],
        "subscriptions": [["robot", "RELIABLE", "VOLATILE"]],
    }
    # The graph may know of endpoints a little later than they of each other.
    until(lambda: robot.topic("/page/chatter") == chatter)
    latched = [["station", "RELIABLE", "TRANSIENT_LOCAL"]]
    until(lambda: robot.topic("/page/map")["publishers"] == latched)
    until(lambda: "/page/set" in robot.services("station"))
    robot.listen("/page/map", True)
    until(lambda: robot.texts("/page/map"))
    assert robot.texts("/page/map") == ["map of the page"]
    assert robot.call() == "from the page"
    assert robot.goal(5) == {"result": [0, 1, 1, 2, 3, 5], "feedback": 4}
    assert robot.cancel() == {"canceling": 1, "canceled": True}
    assert robot.speed() == 1.5
    assert robot.set_speed(3.0) is True
    assert robot.speed() == 3.0
    assert '"double_value":' in joined.evaluate(CALL, PARAMETERS)
    graph = joined.evaluate(GRAPH)
    assert "node /robot /robot" in graph
    # Each endpoint once, though both sides are told of both.
    remote = [one for one in graph if " /robot " in one]
    assert sorted(set(remote)) == sorted(remote)
    assert printed(joined, "late") == []
    count = len(robot.texts("/page/chatter"))
    until(lambda: len(robot.texts("/page/chatter")) > count + 10)
    numbers = [int(text.split()[1]) for text in robot.texts("/page/chatter")]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
