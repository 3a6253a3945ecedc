"""A page in one network and a robot in another, between which the cable is pulled for a while."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import gateways
import pytest
from browser import CHROMIUM, FLAGS, TIMEOUT, Built
from gateways import Process
from joined import Robot
from native import Native
from networks import Network, networks, only_root
from playwright.sync_api import Browser, Page, expect
from station import GRAPH, state
from waiting import until

SITE = """
site: {title: Robot}
connect: {addresses: [self], autoconnect: true}
pages:
  - path: /
    title: Robot
    content: [connect:]
"""
# The robot sends twenty messages a second, and the page has a history that holds ten.
HEAR_AND_SAY = """async () => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  window.heard = [];
  const hear = ({ data }) => heard.push(Number(data.split(" ")[1]));
  ros.subscribe("/robot/chatter", "std_msgs/msg/String", hear, { reliable: true });
  const said = ros.advertise("/said", "std_msgs/msg/String", { reliable: true, depth: 10 });
  window.say = (...texts) => texts.forEach((data) => said.publish({ data }));
}"""

pytestmark = [only_root, pytest.mark.chromium]


@contextmanager
def opened(browser: Browser, network: Network, address: str, wrapper: Path) -> Iterator[Page]:
    """Open an address in a browser that is in a network."""
    command = " ".join([*network.inside, CHROMIUM])
    wrapper.write_text(f'#!/bin/sh\nexec {command} "$@"\n', encoding="utf-8")
    wrapper.chmod(0o755)
    other = browser.browser_type.launch(executable_path=wrapper, args=FLAGS)
    try:
        page = other.new_page()
        page.set_default_timeout(TIMEOUT)
        page.goto(address)
        yield page
    finally:
        other.close()


def test_a_network_that_is_cut_costs_no_message(
    browser: Browser, built: Built, native: Native, tmp_path: Path
) -> None:
    folder = tmp_path / "site"
    folder.mkdir()
    folder.joinpath("site.yaml").write_text(SITE, encoding="utf-8")
    site = built(folder)
    with networks() as (here, there):
        robot = Robot(native, here.inside)
        command: list[str | Path] = [*here.inside, native.python, "-m", "sitegen", "gateway"]
        command += ["--site", site, "--bind", here.address, "--port", "0"]
        gateway = Process(*command, env=gateways.environment(native), cwd=tmp_path)
        try:
            address = gateway.expect("http://").split()[-1]
            with opened(browser, there, address, tmp_path / "chromium") as page:
                _cut(page, robot, here)
            assert "left" not in "\n".join(gateway.lines)
        finally:
            gateway.stop()
            robot.stop()


def _cut(page: Page, robot: Robot, network: Network) -> None:
    expect(state(page)).to_contain_text("Connected to")
    robot.listen("/said", False)
    page.evaluate(HEAR_AND_SAY)
    until(lambda: robot.topic("/said")["publishers"])
    until(lambda: "subscription /robot /said" in page.evaluate(GRAPH))
    page.evaluate("say('before')")
    until(lambda: "before" in robot.texts("/said"))
    until(lambda: page.evaluate("heard.length") > 10)
    network.set("down")
    expect(state(page)).to_contain_text("does not answer")
    page.evaluate("say('one', 'two', 'three')")
    sent = robot.sent()
    until(lambda: robot.sent() > sent + 40)
    network.set("up")
    expect(state(page)).to_contain_text("Connected to")
    until(lambda: robot.texts("/said")[-1:] == ["three"])
    assert robot.texts("/said") == ["before", "one", "two", "three"]
    sent = robot.sent()
    until(lambda: page.evaluate("heard.at(-1)") >= sent)
    heard = page.evaluate("heard")
    assert heard == list(range(heard[0], heard[0] + len(heard)))
