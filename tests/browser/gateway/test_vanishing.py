"""A page vanishes in the middle of a service call, as client and as server."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from browser import Built
from joined import Gateway, Robot
from native import Native
from paths import SITES
from playwright.sync_api import Browser, Page, expect
from waiting import until

# A node of the page calls a service; `answer` is what comes back.
CALL = """async ([node, service]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  const call = ros.node(node).call(service, "std_srvs/srv/SetBool", { data: true }, 60_000);
  call.then(({ message }) => { window.answer = message; });
}"""
# A node of the page offers a service; without a message, it never answers.
SERVE = """async ([node, service, message]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  window.requests = 0;
  ros.node(node).serve(service, "std_srvs/srv/SetBool", ({ data }) => {
    window.requests += 1;
    return message ? { success: data, message } : new Promise(() => {});
  });
}"""


@pytest.fixture(scope="module")
def gateway(
    built: Built, native: Native, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Gateway]:
    site = built(SITES / "gateway")
    gateway = Gateway(native, tmp_path_factory.mktemp("gateway") / "log", site)
    gateway.start()
    yield gateway
    gateway.stop()


def joined(browser: Browser, gateway: Gateway) -> Page:
    """Open a page without nodes, and wait until it has joined and sees the robot."""
    tab = browser.new_context().new_page()
    tab.goto(f"{gateway.http}watch/")
    expect(tab.locator(".ros-connect-nodes")).to_contain_text("/robot")
    return tab


def session(gateway: Gateway) -> str:
    """The name in the log of the page that joined last."""
    [line] = [line for line in gateway.log if ": is visitor" in line][-1:]
    found = re.search(r"\[\w+\]", line)
    assert found
    return found.group()


def test_a_client_that_vanishes_leaves_a_native_service_to_the_others(
    browser: Browser, gateway: Gateway, robot: Robot
) -> None:
    tab = joined(browser, gateway)
    name = session(gateway)
    tab.evaluate(CALL, ["/asker", "/robot/slow"])
    until(lambda: robot.holds() == 1)
    assert "/asker" in robot.nodes()
    assert robot.sides("/robot/slow") == [1, 1]
    before = len(gateway.log)
    tab.close()
    until(lambda: "/asker" not in robot.nodes())
    until(lambda: robot.sides("/robot/slow") == [1, 0])
    # Others get their answers, from the first one's on, which has nobody to go to.
    other = joined(browser, gateway)
    other.evaluate(CALL, ["/other", "/robot/slow"])
    robot.ask("/robot/slow")
    until(lambda: robot.holds() == 3)
    robot.release()
    until(lambda: robot.answers("/robot/slow") == ["slowly"])
    until(lambda: other.evaluate("window.answer") == "slowly")
    new = gateway.log[before:]
    assert [line.partition(": ")[2] for line in new if name in line] == ["left"]
    assert [line for line in new if "[" not in line] == []
    other.context.close()


def test_a_service_that_vanishes_is_gone_and_another_page_can_offer_it(
    browser: Browser, gateway: Gateway, robot: Robot
) -> None:
    tab = joined(browser, gateway)
    name = session(gateway)
    tab.evaluate(SERVE, ["/server", "/page/late", ""])
    robot.ask("/page/late")
    until(lambda: tab.evaluate("window.requests") == 1)
    before = len(gateway.log)
    tab.close()
    # As natively: the client sees that the service is gone, and its call stays without an answer.
    until(lambda: robot.ready("/page/late") == [False])
    until(lambda: robot.sides("/page/late")[0] == 0)
    assert "/server" not in robot.nodes()
    other = joined(browser, gateway)
    other.evaluate(SERVE, ["/server", "/page/late", "from the other page"])
    robot.ask("/page/late")
    until(lambda: robot.answers("/page/late")[1])
    assert robot.answers("/page/late") == ["", "from the other page"]
    assert other.evaluate("window.requests") == 1
    new = gateway.log[before:]
    assert [line.partition(": ")[2] for line in new if name in line] == ["left"]
    assert [line for line in new if "[" not in line] == []
    other.context.close()
