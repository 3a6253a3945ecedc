"""A page of another origin that opens the page in a window, and uses its graph."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Serve
from playwright.sync_api import Browser, BrowserContext, Page
from roslib import allow

# `connect` resolves with "connected" or the error, and `ended` when the connection closes.
READY = """async (inside) => {
  const [ROSLIB, { transportTo }] = [await import("/roslib.js"), await import("/outside.js")];
  globalThis.opened = window.open(inside);
  globalThis.link = new ROSLIB.Ros({
    transportFactory: transportTo(opened, new URL(inside).origin) });
  globalThis.connect = () => new Promise((resolve) => {
    globalThis.ended = new Promise((close) => link.once("close", () => close("closed")));
    link.once("connection", () => resolve("connected"));
    link.once("error", ({ message }) => resolve(message));
    link.connect("page:");
  });
  globalThis.hear = () => new Promise((resolve) =>
    link.Topic({ name: "/latched", messageType: "std_msgs/String" }).subscribe(resolve));
}"""


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    """Windows of their own."""
    context = browser.new_context()
    yield context
    context.close()


@pytest.fixture
def opener(context: BrowserContext, serve: Serve, around: Path) -> Page:
    """The page of another origin."""
    tab = context.new_page()
    tab.goto(serve(around))
    return tab


def opened(opener: Page, url: str) -> Page:
    with opener.expect_popup() as popup:
        opener.evaluate(READY, url)
    return popup.value


def connected(opener: Page, serve: Serve, inside: Path) -> Page:
    """Return the window, which lets the page of another origin in."""
    allow(inside, opener.url)
    window = opened(opener, serve(inside))
    assert opener.evaluate("connect()") == "connected"
    return window


@pytest.mark.firefox
def test_a_page_uses_the_graph_of_a_window_until_it_closes(
    opener: Page, serve: Serve, inside: Path
) -> None:
    window = connected(opener, serve, inside)
    assert opener.evaluate("hear()") == {"data": "once"}
    assert window.evaluate("ros.nodes()").count("/rosbridge") == 1
    window.close()
    assert opener.evaluate("ended") == "closed"
    assert not opener.evaluate("link.isConnected")
    error = opener.evaluate("connect()")
    assert error.endswith(" is closed, or isolated from other pages")


@pytest.mark.firefox
def test_a_window_is_connected_again_after_a_reload(
    opener: Page, serve: Serve, inside: Path
) -> None:
    window = connected(opener, serve, inside)
    window.reload()
    assert opener.evaluate("ended") == "closed"
    assert opener.evaluate("connect()") == "connected"
    assert opener.evaluate("hear()") == {"data": "once"}


@pytest.mark.firefox
def test_the_graph_forgets_a_page_that_goes(opener: Page, serve: Serve, inside: Path) -> None:
    window = connected(opener, serve, inside)
    opener.goto("about:blank")
    window.wait_for_function("!ros.nodes().includes('/rosbridge')")


def test_windows_of_sites_that_do_not_name_the_page_refuse(
    opener: Page, serve: Serve, inside: Path
) -> None:
    window = opened(opener, serve(inside))
    origin = opener.url.rstrip("/")
    assert opener.evaluate("connect()") == f"this page takes no messages from {origin}"
    assert "/rosbridge" not in window.evaluate("ros.nodes()")


def test_a_window_that_was_not_opened_is_an_error(opener: Page) -> None:
    error = opener.evaluate(
        """async () => {
          const { transportTo } = await import("/outside.js");
          return transportTo(null, "http://127.0.0.1")().catch(({ message }) => message);
        }"""
    )
    assert error == "there is no window; browsers open one only when the visitor clicks"
