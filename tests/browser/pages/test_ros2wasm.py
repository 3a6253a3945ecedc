"""Nodes of the ROS2WASM project, as stand-ins and as a compiled program, in a real browser."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Serve
from panel import Panel, expect_nothing_left, graph, numbers
from playwright.sync_api import Browser, Page, expect
from waiting import until

# Firefox that is driven by WebDriver now and then loses a worker that starts one, and only then.
pytestmark = pytest.mark.chromium


@pytest.fixture
def url(ros2wasm: Path, serve: Serve) -> str:
    return serve(ros2wasm, "/robot/")


@pytest.fixture
def page(browser: Browser, url: str) -> Iterator[Page]:
    """A tab; the test fails on an error that nobody caught."""
    page = browser.new_page()
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    yield page
    page.close()
    assert wrong == []


def consecutive(found: list[int]) -> bool:
    return bool(found) and found == list(range(found[0], found[0] + len(found)))


def words(panel: Panel) -> list[str]:
    """What a console shows, without the name before what is said of the node."""
    return [line.removeprefix(f"{panel.node}: ") for line in panel.lines()]


def test_topics_reach_both_ways(page: Page, url: str) -> None:
    page.goto(url)
    talker, listener, old_talker, old_listener, other_listener = (
        Panel(page, name)
        for name in ("talker", "listener", "old_talker", "old_listener", "other_listener")
    )
    # One after another, since the graph lists them in the order in which they came.
    for count, panel in enumerate((listener, old_listener, other_listener, old_talker), 1):
        panel.start()
        until(lambda count=count: len(graph(page)["all"]) == 3 * count)  # type: ignore[misc]
    # It says Hello, world! with a comma, which their page would have made a line end of.
    for panel in (listener, old_listener, other_listener):
        panel.wait_for("I heard: 'Hello, world! 9'")
    assert graph(page) == {
        "nodes": ["/minimal_subscriber", "/old_listener", "/old_publisher", "/other_listener"],
        "topics": [
            "/old_publisher > /chatter (std_msgs/msg/String) > "
            "/minimal_subscriber,/old_listener,/other_listener"
        ],
        "all": [
            *("/minimal_subscriber", "/rosout", "/chatter"),
            *("/old_listener", "/rosout", "/chatter"),
            *("/other_listener", "/rosout", "/chatter"),
            *("/old_publisher", "/rosout", "/chatter"),
        ],
    }
    old_talker.wait_for("That was all")
    assert numbers(old_talker, "Publishing") == list(range(50))
    for panel in (listener, old_listener, other_listener):
        panel.wait_for("I heard: 'Hello, world! 49'")
        assert consecutive(numbers(panel, "I heard"))
    last = old_talker.console.locator("div").last
    expect(last).to_have_attribute("data-severity", "warn")
    # It took back what it had, though it named the wrong topic each time.
    assert "/old_publisher" not in graph(page)["nodes"]

    old_listener.button("Clear").click()
    talker.start()
    old_listener.wait_for("I heard: 'Hello, world! 2'")
    assert consecutive(numbers(old_listener, "I heard"))


def test_panels_know_them_as_any_node(page: Page, url: str) -> None:
    page.goto(url)
    Panel(page, "old_talker").start()
    Panel(page, "listener").start()
    topics = page.get_by_role("region", name="Topics")
    topics.scroll_into_view_if_needed()
    expect(topics.locator("tbody tr")).to_contain_text(re.compile(r"/chatterstd_msgs/msg/String11"))
    expect(topics.get_by_role("log")).to_contain_text("data: Hello, world! ")
    nodes = page.get_by_role("region", name="Nodes")
    nodes.scroll_into_view_if_needed()
    entry = nodes.locator("li").filter(has_text="old_talker")
    expect(entry).to_contain_text("ros2wasm/talker.js")
    expect(entry.locator(".ros-graph-node")).to_have_text("/old_publisherpublishes/chatter")

    log = page.get_by_role("region", name="Log")
    log.scroll_into_view_if_needed()
    expect(log.get_by_role("log")).to_contain_text("Hello, world! 20", timeout=15_000)
    lines = [line for line in log.get_by_role("log").inner_text().split("\n") if "Publi" in line]
    said = [int(number) for number in re.findall(r"world! (\d+)", "\n".join(lines))]
    assert consecutive(said), "each once, though it publishes them on /rosout, too"
    assert all(re.search(r" INFO old_publisher: Publishing: ", line) for line in lines)


def test_the_page_can_publish_to_them(page: Page, url: str) -> None:
    page.goto(url)
    listener = Panel(page, "old_listener")
    listener.start()
    publish = page.get_by_role("region", name="Publish")
    publish.scroll_into_view_if_needed()
    text = "a, b: <b>\"c\"</b> # 'd', \\ ü, 😀"
    publish.get_by_label("data").fill(text)
    publish.get_by_role("button", name="Publish once").click()
    listener.wait_for(f"I heard: '{text}'")


def test_they_stop_and_start_and_leave_nothing(page: Page, url: str) -> None:
    page.goto(url)
    old_talker, old_listener = Panel(page, "old_talker"), Panel(page, "old_listener")
    old_talker.expect_state("stopped")
    assert page.workers == []
    old_listener.start()
    for _ in range(2):
        old_talker.button("Clear").click()
        old_listener.button("Clear").click()
        old_talker.start()
        old_listener.wait_for("I heard: 'Hello, world! 1'")
        assert numbers(old_talker, "Publishing")[0] == 0
        old_talker.stop()
        assert graph(page)["nodes"] == ["/old_listener"]
    old_listener.stop()
    expect_nothing_left(page)


def test_services_reach_both_ways(page: Page, url: str) -> None:
    page.goto(f"{url}services/")
    server, client, old_server, one, two = (
        Panel(page, name) for name in ("server", "client", "old_server", "add_1_2", "add_30_4")
    )
    # They ask before a server is there, and are answered when it is.
    one.start()
    two.start()
    one.wait_for("Request 0")
    two.wait_for("Request 0")
    server.start()
    one.wait_for("Sum: 7")
    two.wait_for("Sum: 38")
    assert [line for line in one.messages() if "Sum" in line] == [f"Sum: {n}" for n in range(3, 8)]
    server.stop()

    client.start()
    client.wait_for("No service yet, waiting")
    old_server.start()
    client.wait_for("Sum: 42")
    client.expect_state("stopped")
    assert old_server.messages() == ["Ready to add two numbers", "40 + 2"]
    services = page.get_by_role("region", name="Services")
    services.scroll_into_view_if_needed()
    services.get_by_label("a int64").fill("9223372036854775000")
    services.get_by_label("b int64").fill("807")
    services.get_by_role("button", name="Call").click()
    expect(services.get_by_label("response")).to_have_text("sum: 9223372036854775807")


def test_answers_go_to_those_who_asked(page: Page, url: str) -> None:
    page.goto(f"{url}services/")
    slow, client, one, two = (
        Panel(page, name) for name in ("slow_server", "client", "add_1_2", "add_30_4")
    )
    for panel in (one, two, client, slow):
        panel.start()
    one.wait_for("Sum: 7")
    two.wait_for("Sum: 38")
    client.wait_for("Sum: 42")
    assert [line for line in one.messages() if "Sum" in line] == [f"Sum: {n}" for n in range(3, 8)]
    assert [line for line in two.messages() if "Sum" in line] == [
        f"Sum: {n}" for n in range(34, 39)
    ]
    # One that is gone leaves the service to others, and answers nobody.
    one.expect_state("running")
    assert graph(page)["nodes"] == ["/slow_server"]


MIRROR = """async ([topic, type, messages]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  const found = [];
  const until = async (done) => {
    const end = performance.now() + 20_000;
    while (!done() && performance.now() < end) await new Promise((go) => setTimeout(go, 20));
  };
  const qos = { depth: 100, reliable: true };
  const back = `${topic}/back`;
  const close = ros.subscribe(back, type, (message) => found.push(message), qos);
  const out = ros.advertise(topic, type, qos);
  await until(() => [topic, back].every((wanted) => ros.graph.topics().some(
    ({ name, publishers, subscriptions }) =>
      name === wanted && publishers.length && subscriptions.length)));
  for (const message of messages) out.publish(message);
  await until(() => found.length === messages.length);
  close();
  out.close();
  const plain = (_, one) => {
    if (ArrayBuffer.isView(one)) return Array.from(one);
    const known = typeof one !== "bigint" && !(typeof one === "number" && !Number.isFinite(one));
    return known ? one : String(one);
  };
  return [messages, found].map((all) => JSON.parse(JSON.stringify(all, plain)));
}"""

# What is published, as JavaScript. Their stacks and our queues hold ten.
MIRRORED = {
    "/text std_msgs/msg/String": r"""
      ["", "plain", "a, b", ", , ,", "two\nlines\n", "true", "1.5", "~", "a: b", "- a"]
        .map((data) => ({ data }))""",
    "/text std_msgs/msg/String more": r"""
      ["#a", "'", '"', "\\n, x", "ü 😀 日本", "\t\r\u2028", "{}", "[a, b]", " ", "x".repeat(70000)]
        .map((data) => ({ data }))""",
    "/number std_msgs/msg/Int64": """
      [9223372036854775807n, -9223372036854775808n, 0n, 1n, 2n, 3n, 4n, 5n, 6n, 7n]
        .map((data) => ({ data }))""",
    "/empty std_msgs/msg/Empty": "[{}, {}]",
    "/array std_msgs/msg/Float64MultiArray": """[
      { layout: { dim: [{ label: "a, b", size: 1, stride: 2 }], data_offset: 3 },
        data: Float64Array.of(0.1, 1e300, -2.5e-7, Infinity, -Infinity, NaN, 3) },
      { layout: { dim: [], data_offset: 0 }, data: Float64Array.of() }]""",
    "/joints sensor_msgs/msg/JointState": """[{
      header: { stamp: { sec: -1, nanosec: 999999999 }, frame_id: "base, link" },
      name: ["left", "", "a, b"], position: Float64Array.of(1), velocity: Float64Array.of(),
      effort: Float64Array.of(2, 3) }]""",
    "/imu sensor_msgs/msg/Imu": """[{
      header: { stamp: { sec: 1, nanosec: 2 }, frame_id: "" },
      orientation: { x: 0.5, y: 0, z: 0, w: 1 },
      orientation_covariance: Float64Array.from({ length: 9 }, (_, i) => i / 3),
      angular_velocity: { x: 1, y: 2, z: 3 }, angular_velocity_covariance: new Float64Array(9),
      linear_acceleration: { x: 1e-9, y: 1e16, z: 5e-324 },
      linear_acceleration_covariance: new Float64Array(9) }]""",
    "/diagnostics diagnostic_msgs/msg/DiagnosticArray": r"""[{
      header: { stamp: { sec: 1, nanosec: 2 }, frame_id: "x" }, status: [
        { level: 2, name: "a", message: "b: c, d", hardware_id: "7", values: [] },
        { level: 0, name: "", message: "", hardware_id: "", values: [
          { key: "k, 1", value: "v\n2" }, { key: "true", value: "~" }] }] }]""",
    # To write a large one as YAML takes longer than the script waits until it asks again.
    "/image sensor_msgs/msg/Image": """[500_000, 1, 2, 500_000, 3, 4].map((width) => ({
      header: { stamp: { sec: 1, nanosec: 2 }, frame_id: `image ${width}` }, height: 1, width,
      encoding: "mono8", is_bigendian: 0, step: width, data: new Uint8Array(width).fill(7) }))""",
}


@pytest.mark.parametrize("case", MIRRORED)
def test_messages_of_all_kinds_come_back_as_they_went(page: Page, url: str, case: str) -> None:
    page.goto(f"{url}types/")
    Panel(page, "mirror").expect_state("running")
    topic, type = case.split()[:2]
    messages = page.evaluate_handle(f"() => {MIRRORED[case]}")
    sent, found = page.evaluate(MIRROR, [topic, type, messages])
    assert found == sent
    assert Panel(page, "mirror").lines() == []


def test_lines_that_were_joined_are_read(page: Page, url: str) -> None:
    page.goto(f"{url}types/")
    message = page.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          const found = await new Promise((found) => ros.subscribe(
            "/point", "geometry_msgs/msg/PointStamped", found));
          return [JSON.stringify(found.header), String(Object.values(found.point))];
        }"""
    )
    assert message == [
        '{"stamp":{"sec":7,"nanosec":8},"frame_id":"map"}',
        "1,-2.5,Infinity",
    ]


def test_what_is_wrong_is_told_once_and_breaks_nothing(page: Page, url: str) -> None:
    page.goto(f"{url}faults/")
    rude, listener = Panel(page, "rude"), Panel(page, "listener")
    rude.start()
    listener.wait_for("I heard: 'still, here'")
    image = '/<img src=x onerror="alert(1)">'
    assert words(rude) == [
        "sent null, which is not a command",
        "sent 7, which is not a command",
        "sent register, which is not a command",
        "sent a list, which is not a command",
        "sent an object, which is not a command",
        "sent 'constructor', which is not a command",
        "sent 'publish' with undefined for 'message', which must be text",
        "sent 'publish' with a list for 'topic', which must be text",
        "sent 'console' with an object for 'message', which must be text",
        "sent 'register' with undefined for 'role', which must be text",
        "published on /unknown and is no publisher of it",
        "asked for messages of /unknown and is no subscriber of it",
        "unregistered /unknown (publisher), which it had not registered",
        "registered as publisher of /untyped, whose type is not in site.yaml; "
        "give 'rude' there types: {/untyped: package/msg/Name}",
        "registered as service_server of /untyped/service, whose type is not in site.yaml; "
        "give 'rude' there types: {/untyped/service: package/srv/Name}",
        "registered as service_client of /mixed, whose type in site.yaml is std_msgs/msg/String; "
        "give 'rude' there types: {/mixed: package/srv/Name}",
        "registered as subscriber of /add_two_ints, whose type in site.yaml is "
        "tutorial_interfaces/srv/AddTwoInts; "
        "give 'rude' there types: {/add_two_ints: package/msg/Name}",
        "registered as 'constructor' of /chatter, which is not a role",
        "registered as action_server of /fibonacci; ROS2WASM does not define how the parts of an "
        "action travel, so it cannot be reached",
        "registered as action_client of /fibonacci; ROS2WASM does not define how the parts of an "
        "action travel, so it cannot be reached",
        f"registered as publisher of {image}, whose type is not in site.yaml; "
        f"give 'rude' there types: {{{image}: package/msg/Name}}",
        "sent an invalid std_msgs/msg/Int32 on /number: data: 'seven' is not a whole number; "
        "check the type that site.yaml gives /number",
        "answered on /add_two_ints without a request",
        "printed <b>as it is</b>",
        "printed <b>as it is</b>",
    ]
    rude.expect_state("running")
    assert page.locator("img[src=x]").count() == 0
    assert graph(page)["nodes"] == ["/minimal_subscriber", "/rude"]


def test_a_script_that_dies_or_is_not_there_fails(
    page: Page, url: str, ros2wasm: Path, serve: Serve, tmp_path: Path
) -> None:
    page.goto(f"{url}faults/")
    crash = Panel(page, "crash")
    crash.start()
    crash.expect_state("failed")
    assert crash.lines() == ["crash: Uncaught RangeError: no such wheel"]

    shutil.copytree(ros2wasm, tmp_path / "dist")
    (tmp_path / "dist/ros2wasm/nodes/crash.js").unlink()
    page.goto(f"{serve(tmp_path / 'dist')}faults/")
    crash.start()
    crash.expect_state("failed")
    assert crash.lines() == ["crash: its script could not be loaded"]


def test_a_flood_and_an_endless_program_can_be_stopped(page: Page, url: str) -> None:
    page.goto(f"{url}faults/")
    flood, endless = Panel(page, "flood"), Panel(page, "endless")
    endless.start()
    endless.expect_state("running")
    endless.stop()
    page.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          window.warnings = [];
          ros.nodes.get("flood").addEventListener("lines", ({ detail }) =>
            warnings.push(...detail.filter(({ severity }) => severity === "warn")));
        }"""
    )
    flood.start()
    expect(flood.console).to_contain_text(re.compile(r"line \d{4}"), timeout=15_000)
    flood.stop()
    warnings = page.evaluate("warnings.map(({ text }) => text)")
    assert len(warnings) == 51
    assert warnings[-1].endswith("further errors of this script are not shown")


def test_a_compiled_program_runs_as_it_is(page: Page, url: str) -> None:
    said: list[str] = []
    page.on("console", lambda message: said.append(message.text))
    page.goto(f"{url}compiled/")
    echo = Panel(page, "echo")
    echo.wait_for("message 3")
    assert echo.lines() == [
        f"[INFO] [1700000000.500000000] [echo]: message {number}" for number in (1, 2, 3)
    ]
    topics = page.get_by_role("region", name="Topics").get_by_role("log")
    talker = Panel(page, "talker_of_echo")
    first = topics.inner_text().split("\n")[0].removeprefix("data: ")
    assert f"Publishing: '{first}'" in talker.messages()
    assert graph(page)["nodes"] == ["/minimal_publisher"], "it has left"
    assert said == []
