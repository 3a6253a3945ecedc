"""A C++ node in a page and native nodes on one graph, through a gateway that serves the page."""

from __future__ import annotations

import json
import re
import signal
import socket
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Built, resolving
from joined import Gateway, Robot
from native import Native
from paths import SITES
from playwright.sync_api import Browser, Page, expect
from roweprograms import compiled
from station import CALL, GRAPH, cancel_a_goal, printed, state, use_each_other
from terminal import Terminal
from waiting import until
from websockets.sync.client import connect

SITE = SITES / "gateway"
CHATTER = "publisher /station /page/chatter"
# A publisher that keeps 3 messages; it goes on after the page has matched the robot's subscription.
FAST = """async () => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  const publisher = ros.advertise("/page/fast", "std_msgs/msg/String", { depth: 3 });
  globalThis.say = (first, last) => {
    for (let n = first; n <= last; n++) publisher.publish({ data: `fast ${n}` });
  };
}"""


@pytest.fixture(scope="module")
def gateway(
    native: Native, built: Built, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Gateway]:
    gateway = Gateway(native, tmp_path_factory.mktemp("gateway") / "log", built(SITE))
    gateway.start()
    yield gateway
    gateway.stop()


@pytest.fixture
def joined(browser: Browser, gateway: Gateway) -> Iterator[Page]:
    """The page with its node, which has joined the robot's graph."""
    # A connection that is refused is an error of the console, which pages cannot prevent.
    context = browser.new_context()
    tab = context.new_page()
    tab.goto(gateway.http)
    expect(state(tab)).to_contain_text("Connected to")
    tab.get_by_role("button", name="Start", exact=True).first.click()
    yield tab
    context.close()


def test_a_node_of_the_page_and_native_ones_are_one_graph(joined: Page, robot: Robot) -> None:
    use_each_other(joined, robot)


def test_a_program_without_ros_and_a_node_of_the_page_reach_each_other(
    joined: Page, gateway: Gateway, robot: Robot
) -> None:
    """The program is a plain WebSocket client, as in a language that has no module of rowe."""
    until(lambda: "/station" in robot.nodes() and "/page/set" in robot.services("station"))
    with connect(f"{gateway.http.replace('http', 'ws')}rowe") as socket:
        socket.send(json.dumps({"message_id": "1", "service": "/page/set", "data": True}))
        answer = json.loads(socket.recv(10))
        assert (answer["in_reply_to"], answer["message"]) == ("1", "from the page")
        socket.send(json.dumps({"subscribe": "/page/chatter"}))
        message = json.loads(socket.recv(10))
        assert message["topic"] == "/page/chatter"
        assert message["data"].startswith("page ")


def test_a_program_in_c_calls_the_cpp_node_of_the_page(
    joined: Page, gateway: Gateway, robot: Robot, tmp_path: Path
) -> None:
    until(lambda: "/station" in robot.nodes() and "/page/set" in robot.services("station"))
    program = compiled(tmp_path, "ask")
    url = f"{gateway.http.replace('http', 'ws')}rowe"
    request = json.dumps({"service": "/page/set", "data": True})
    found = subprocess.run([program, url, request], stdout=subprocess.PIPE, timeout=60, check=True)
    answer = {"success": True, "message": "from the page", "service": "/page/set"}
    assert json.loads(found.stdout) == answer


def test_a_page_that_leaves_takes_its_nodes_with_it(joined: Page, robot: Robot) -> None:
    until(lambda: "/station" in robot.nodes())
    joined.get_by_role("button", name="Disconnect").click()
    expect(state(joined)).to_contain_text("Not connected.")
    until(lambda: "/station" not in robot.nodes())
    until(lambda: not [one for one in joined.evaluate(GRAPH) if "/robot " in one])
    joined.get_by_role("button", name="Connect", exact=True).click()
    until(lambda: "/station" in robot.nodes())
    joined.context.close()
    until(lambda: "/station" not in robot.nodes())
    assert robot.topic("/page/chatter")["publishers"] == []


def test_a_killed_gateway_is_joined_again_without_ghosts_or_doubles(
    joined: Page, gateway: Gateway, robot: Robot
) -> None:
    until(lambda: "/station" in robot.nodes())
    gateway.stop(signal.SIGKILL)
    expect(state(joined)).to_contain_text("No gateway answers")
    assert [one for one in joined.evaluate(GRAPH) if "/robot " in one] == []
    gateway.start()
    expect(state(joined)).to_contain_text("Connected to", timeout=30_000)
    publishers = [["station", "RELIABLE", "VOLATILE"]]
    # The middleware takes a while to notice that the killed participant is gone.
    until(lambda: robot.topic("/page/chatter")["publishers"] == publishers, 60)
    count = len(robot.texts("/page/chatter"))
    until(lambda: len(robot.texts("/page/chatter")) > count + 10)
    numbers = [int(text.split()[1]) for text in robot.texts("/page/chatter")[count:]]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert robot.call() == "from the page"
    # What the page keeps is there for those who come now.
    robot.listen("/page/map", True)
    until(lambda: robot.texts("/page/map"))
    remote = [one for one in joined.evaluate(GRAPH) if " /robot /robot/" in one]
    assert sorted(set(remote)) == sorted(remote) != []


def test_a_gateway_that_pauses_is_waited_for(joined: Page, gateway: Gateway, robot: Robot) -> None:
    until(lambda: printed(joined, "heard robot"))
    until(lambda: robot.texts("/page/chatter"))
    robot.listen("/page/fast", False)
    joined.evaluate(FAST)
    until(lambda: len(robot.topic("/page/fast")["publishers"]) == 1)
    until(lambda: "subscription /robot /page/fast" in joined.evaluate(GRAPH))
    joined.evaluate("say(1, 2)")
    until(lambda: robot.texts("/page/fast") == ["fast 1", "fast 2"])
    first = len(robot.texts("/page/chatter"))
    gateway.pause(True)
    expect(state(joined)).to_contain_text("does not answer", timeout=10_000)
    assert "node /robot /robot" in joined.evaluate(GRAPH)
    # Commands for a robot: of those that could not be sent, only what natively would be kept.
    joined.evaluate("say(3, 20)")
    gateway.pause(False)
    expect(state(joined)).to_contain_text("Connected to")
    until(lambda: robot.texts("/page/fast")[-1:] == ["fast 20"])
    assert robot.texts("/page/fast")[2:] == ["fast 18", "fast 19", "fast 20"]
    # Nothing is lost of what both sides keep for longer.
    until(lambda: len(robot.texts("/page/chatter")) > first + 40)
    numbers = [int(text.split()[1]) for text in robot.texts("/page/chatter")[first - 1 :]]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    numbers = [int(line.split()[2]) for line in printed(joined, "heard robot")]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))


def test_a_cut_connection_is_noticed_on_both_sides_and_heals(
    joined: Page, gateway: Gateway, robot: Robot
) -> None:
    until(lambda: "/station" in robot.nodes())
    gateway.pause(True)
    # Nothing is closed; there is just no answer.
    until(lambda: not [one for one in joined.evaluate(GRAPH) if "/robot " in one], 60)
    # It tries again and again.
    expect(state(joined)).to_contain_text(re.compile("No gateway answers|Connecting to"))
    gateway.pause(False)
    expect(state(joined)).to_contain_text("Connected to", timeout=40_000)
    publishers = [["station", "RELIABLE", "VOLATILE"]]
    # The middleware forgets the gateway that another test has killed later.
    until(lambda: robot.topic("/page/chatter")["publishers"] == publishers, 60)
    until(lambda: robot.nodes().count("/station") == 1, 60)


def test_ros2_in_a_terminal_of_the_page_reaches_the_robot(
    browser: Browser, gateway: Gateway, robot: Robot
) -> None:
    tab = browser.new_context().new_page()
    tab.goto(f"{gateway.http}watch/")
    terminal = Terminal(tab)
    terminal.await_names("/robot", "/robot/set", "/robot/get_parameters")
    expect(tab.locator(".ros-topics")).to_contain_text("data: robot")
    assert "/robot" in terminal.run("ros2 node list").splitlines()
    asked = 'ros2 service call /robot/set std_srvs/srv/SetBool "{data: true}"'
    assert "from the robot" in terminal.run(asked)
    assert "Double value is: 2.5" in terminal.run("ros2 param get /robot gain")
    assert "Set parameter successful" in terminal.run("ros2 param set /robot gain 4.0")
    cancel_a_goal(terminal)
    count = len(robot.texts("/page/chatter"))
    terminal.run("ros2 topic pub --once /page/chatter std_msgs/msg/String '{data: typed}'")
    until(lambda: robot.texts("/page/chatter")[count:] == ["typed"])


def test_pages_on_one_gateway_are_on_one_graph(
    joined: Page, browser: Browser, gateway: Gateway
) -> None:
    other = browser.new_context().new_page()
    other.goto(f"{gateway.http}watch/")
    expect(state(other)).to_contain_text("Connected to")
    nodes = other.locator(".ros-connect-nodes")
    expect(nodes).to_contain_text("/station")
    until(lambda: "service /station /page/set" in other.evaluate(GRAPH))
    answer = other.evaluate(CALL, ["/page/set", "std_srvs/srv/SetBool", {"data": True}])
    assert "from the page" in answer
    joined.context.close()
    expect(nodes).not_to_contain_text("/station")


def test_a_page_that_another_computer_loads_without_encryption_joins(
    browser: Browser, gateway: Gateway
) -> None:
    """To a page from http://robot, browsers offer less than to one from localhost."""
    name = f"{socket.gethostname().partition('.')[0].lower()}.local"
    with resolving(browser, name) as another:
        tab = another.new_page()
        tab.goto(gateway.http.replace("127.0.0.1", name))
        assert tab.evaluate("isSecureContext") is False
        expect(state(tab)).to_contain_text("Connected to")
        expect(tab.locator(".ros-connect-nodes")).to_contain_text("/robot")
        tab.get_by_role("button", name="Start", exact=True).first.click()
        until(lambda: printed(tab, "heard robot"))


def test_pages_with_the_same_node_do_not_disturb_each_other(
    joined: Page, browser: Browser, gateway: Gateway, robot: Robot
) -> None:
    other = browser.new_context().new_page()
    other.goto(gateway.http)
    expect(state(other)).to_contain_text("Connected to")
    other.get_by_role("button", name="Start", exact=True).first.click()
    until(lambda: len(robot.topic("/page/chatter")["publishers"]) == 2)
    for tab in (joined, other):
        until(lambda tab=tab: len(printed(tab, "heard robot")) > 10)  # type: ignore[misc]
        numbers = [int(line.split()[2]) for line in printed(tab, "heard robot")]
        assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
        # That of the other page, and its own.
        until(lambda tab=tab: tab.evaluate(GRAPH).count(CHATTER) == 2)  # type: ignore[misc]
    other.context.close()
    until(lambda: len(robot.topic("/page/chatter")["publishers"]) == 1)
    assert robot.call() == "from the page"
