"""What `connect:` allows, and what the panel says: names, rates, clocks, keys, addresses."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Built, serving
from joined import Gateway, Robot
from native import Native
from playwright.sync_api import Browser, Page, expect
from waiting import until

SITE = """
site: {{title: Robot}}
connect:
  addresses: [ws://127.0.0.1:{port}, ws://127.0.0.1:{locked}]
  namespace: /student1
  send: {{topics: [/said]}}
  receive: {{topics: [/hello, /robot/chat*]}}
  rates: {{/robot/*: 4}}
pages:
  - path: /
    title: Robot
    content:
      - topics:
"""
SAY = """async ([topic, data]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  window.publishers ??= {};
  window.publishers[topic] ??= ros.advertise(topic, "std_msgs/msg/String");
  window.publishers[topic].publish({ data });
}"""
HEAR = """async (topic) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  window.heard = [];
  const hear = ({ data }) => window.heard.push(data);
  ros.subscribe(topic, "std_msgs/msg/String", hear, { reliable: true });
}"""


@pytest.fixture(scope="module")
def gateway(native: Native, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    gateway = Gateway(native, tmp_path_factory.mktemp("gateway") / "log")
    gateway.start(ahead=5)
    yield gateway
    gateway.stop()


@pytest.fixture(scope="module")
def locked(native: Native, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    """A gateway that asks for a key; it is started by the test that needs it."""
    gateway = Gateway(native, tmp_path_factory.mktemp("locked") / "log")
    yield gateway
    gateway.stop()


@pytest.fixture(scope="module")
def site(
    gateway: Gateway, locked: Gateway, built: Built, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[str]:
    folder = tmp_path_factory.mktemp("site")
    text = SITE.format(port=gateway.port, locked=locked.port)
    folder.joinpath("site.yaml").write_text(text, encoding="utf-8")
    with serving(built(folder)) as address:
        yield address


@pytest.fixture
def page(browser: Browser, site: str) -> Iterator[Page]:
    # A connection that is refused is an error of the console, which pages cannot prevent.
    context = browser.new_context()
    tab = context.new_page()
    tab.goto(site)
    yield tab
    context.close()


def test_only_what_connect_lists_passes(page: Page, gateway: Gateway, robot: Robot) -> None:
    policy = page.locator("meta[http-equiv='Content-Security-Policy']").get_attribute("content")
    [allowed] = re.findall("connect-src ([^;]*)", policy or "")
    assert allowed.startswith("'self' ws://127.0.0.1:")
    assert len(allowed.split()) == 3
    panel = page.locator(".ros-connect")
    expect(panel).to_contain_text("Not connected.")
    panel.get_by_role("button", name="Connect").click()
    expect(panel).to_contain_text("Connected to")
    expect(panel.get_by_text("The clock of the gateway is 5")).to_be_visible()
    robot.publish("/student1/hello", [], 10)
    robot.listen("/student1/said", False)
    robot.listen("/student1/secret", False)
    topics = page.locator(".ros-topics")
    # In the namespace of the page, names are those of the page.
    expect(topics).to_contain_text("/hello")
    expect(topics).to_contain_text("/robot/chatter")
    expect(topics).not_to_contain_text("/robot/map")
    expect(topics).to_contain_text("/said")
    page.evaluate(HEAR, "/hello")
    until(lambda: robot.subscriptions("/student1/hello") > 0)
    robot.publish("/student1/hello", ["to the page"], 10)
    until(lambda: page.evaluate("window.heard"))
    assert page.evaluate("window.heard") == ["to the page"]
    page.evaluate(SAY, ["/secret", "to nobody"])
    page.evaluate(SAY, ["/said", "first"])
    until(lambda: robot.topic("/student1/said")["publishers"])
    page.evaluate(SAY, ["/said", "to the robot"])
    until(lambda: "to the robot" in robot.texts("/student1/said"))
    assert robot.texts("/student1/secret") == []
    page.evaluate(HEAR, "/robot/chatter")
    until(lambda: len(page.evaluate("window.heard")) > 4)
    numbers = [int(text.split()[1]) for text in page.evaluate("window.heard")]
    # The robot sends 20 in a second.
    assert numbers[-1] - numbers[0] >= 3 * (len(numbers) - 1)


def test_a_key_is_asked_for_and_ends(
    page: Page, locked: Gateway, native: Native, tmp_path: Path
) -> None:
    config = tmp_path / "gateway.yaml"
    config.write_text("keys: {secret: gateway.secret}\n", encoding="utf-8")
    make: list[str | Path] = [native.python, "-m", "sitegen"]
    make += ["gateway", "keys", "ada", "--for", "10s"]
    made = subprocess.run(
        make, env=native.environment, cwd=tmp_path, text=True, capture_output=True, check=True
    )
    key = made.stdout.split()[-1]
    locked.start(config=config)
    panel = page.locator(".ros-connect")
    panel.get_by_label("Gateway").select_option(index=1)
    connect = panel.get_by_role("button", name="Connect")
    connect.click()
    expect(panel).to_contain_text("This gateway asks for a key.")
    field = panel.get_by_label("Key")
    expect(field).to_be_focused()
    field.fill("wrong")
    connect.click()
    expect(panel.locator(".ros-connect-state")).to_have_class(re.compile("ros-wrong"))
    expect(panel).not_to_contain_text("Connected to")
    field.fill(key)
    page.keyboard.press("Enter")
    expect(panel).to_contain_text("Connected to")
    expect(panel).to_contain_text("Your key is good for 0:")
    expect(panel).to_contain_text("the key has ended", timeout=20_000)
    expect(panel.get_by_role("button", name="Connect")).to_be_visible()


def test_an_address_where_nobody_answers_is_tried_again(page: Page, locked: Gateway) -> None:
    locked.stop()
    panel = page.locator(".ros-connect")
    panel.get_by_label("Gateway").select_option(index=1)
    panel.get_by_role("button", name="Connect").click()
    expect(panel).to_contain_text("No gateway answers")
    expect(panel).to_contain_text("Next try in")
    panel.get_by_role("button", name="Disconnect").click()
    expect(panel).to_contain_text("Not connected.")
    expect(panel.get_by_label("Gateway")).to_be_enabled()
