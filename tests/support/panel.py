"""A node of a page as a test sees it: its buttons, its console, and what it has in the graph."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from browser import Scripted
from playwright.sync_api import Locator, Page, expect

LINE = re.compile(r"^\[(INFO|WARN|ERROR)\] \[\d{10}\.\d{9}\] \[(\w+)\]: (.*)$")

# A console draws with the next frame, of which a page that nobody sees has none.
DRAWN = """() => new Promise((done) => {
  requestAnimationFrame(() => requestAnimationFrame(done));
  setTimeout(done, document.hidden ? 200 : 5000);
})"""


class Speaker(Protocol):
    """What has a console."""

    def messages(self) -> list[str]: ...


class Panel:
    """The buttons and the console of one node."""

    def __init__(self, page: Page, node: str, region: str = "") -> None:
        """`region` is the name of the region that has the buttons, if it is not the node's."""
        self._page = page
        self.node = node
        self.panel = page.get_by_role("region", name=region or node, exact=True)
        # In a stage, it is apart from the buttons.
        self.console = page.get_by_role("log", name=node, exact=True, include_hidden=True)

    def button(self, name: str) -> Locator:
        return self.panel.get_by_role("button", name=name, exact=True)

    def start(self) -> None:
        self.button("Start").click()

    def stop(self) -> None:
        self.button("Stop").click()
        self.expect_state("stopped")

    def expect_state(self, state: str) -> None:
        expect(self.panel.locator(".ros-state").first).to_have_text(state)

    def expect_started(self) -> None:
        """Wait until the program runs; one that ends by itself may have ended already."""
        started = re.compile("running|stopped|failed")
        expect(self.panel.locator(".ros-state").first).to_have_text(started)

    def lines(self) -> list[str]:
        self._page.evaluate(DRAWN)
        return [line for line in self.console.inner_text().split("\n") if line]

    def messages(self) -> list[str]:
        return messages(self.lines())

    def wait_for(self, text: str) -> None:
        expect(self.console).to_contain_text(text)


# What the fixture `played` is: it takes the folder of a site, a page of it, and a node there.
Played = Callable[[Path, str, str], Panel]


def messages(lines: list[str]) -> list[str]:
    """What a node logged, each line checked for its form; ROS's own words left out."""
    found = [LINE.match(line) for line in lines]
    assert all(found), lines
    return [match[3] for match in found if match and match[2] != "rclcpp"]


def numbers(panel: Speaker, before: str) -> list[int]:
    """The numbers of the greetings in a console."""
    greetings = (re.fullmatch(rf"{before}: 'Hello, world! (\d+)'", m) for m in panel.messages())
    return [int(match[1]) for match in greetings if match]


def graph(page: Scripted) -> dict[str, list[str]]:
    """Who is in the graph of the page: nodes, what each topic connects, and all endpoints.

    Those of the page's own panels, which are there while somebody is near them, are left out.
    """
    found: dict[str, list[str]] = page.evaluate(
        """async () => {
          const src = document.querySelector("script[type=module]").src;
          const { ros } = await import(src);
          const ends = ros.graph.topics().filter((t) => t.name !== "/rosout").map(
            (t) => `${t.publishers} > ${t.name} (${t.types}) > ${t.subscriptions}`);
          const own = ros.graph.endpoints().filter((e) => e.program);
          const all = own.map((e) => e.name || e.node);
          return { nodes: ros.graph.nodes(), topics: ends, all };
        }"""
    )
    return found


def expect_nothing_left(page: Page) -> None:
    """After Stop nothing is in the graph and no worker runs."""
    assert graph(page)["all"] == []
    deadline = time.monotonic() + 60
    while page.workers and time.monotonic() < deadline:
        page.wait_for_timeout(50)  # the browser tells of a worker's end a moment later
    assert page.workers == []
