"""The demos, faults and services in WebKitGTK, which Playwright's tests of them cannot run in."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
from browser import Built, Serve
from panel import graph, numbers
from paths import ROOT, SITES
from webkit import Window, WindowPanel, webkit

from tests.browser.graph.test_faults import ADVICE, ENDS, plain
from tests.browser.pages.test_demos import paths

SITES = SITES
COUNT = "(selector) => document.querySelectorAll(selector).length"


@pytest.fixture
def page(window: Window, built: Built, serve: Serve) -> Iterator[Window]:
    """A window for this repository's site; the test fails on a foreign request or a wrong build."""
    url = serve(built(ROOT))
    window.goto(url)
    yield window
    names = "() => performance.getEntriesByType('resource').map(({ name }) => name)"
    loaded: list[str] = window.evaluate(names)
    assert [address for address in loaded if not address.startswith(url)] == []
    programs = {name.split(".")[-2] for name in paths(loaded) if name.endswith(".wasm")}
    assert programs == {"asyncify"}


def open_demo(page: Window, demo: str) -> None:
    page.evaluate("(demo) => { location.href = demo; }", f"{demo}/")
    page.wait_until(lambda: page.evaluate("() => location.pathname").endswith(f"/{demo}/"))


def test_demo01_talks_by_itself(page: Window) -> None:
    open_demo(page, "demo01")
    talker = WindowPanel(page, "talker")
    for _ in range(2):
        talker.wait_for("Hello, world! 2")
        assert numbers(talker, "Publishing")[:3] == [0, 1, 2]
        page.reload()
    talker.wait_for("Hello, world! 0")


def test_demo02_starts_and_stops(page: Window) -> None:
    open_demo(page, "demo02")
    talker = WindowPanel(page, "talker")
    for _ in range(2):
        talker.start()
        talker.wait_for("Hello, world! 1")
        talker.stop()
        talker.wait_for("Goodbye")
        said = numbers(talker, "Publishing")
        assert talker.messages()[-1] == f"Goodbye after {len(said)} greetings"
        assert graph(page)["all"] == []
        talker.press("Clear")
        assert talker.lines() == []


def test_demo03_talks_and_listens(page: Window) -> None:
    open_demo(page, "demo03")
    talker, listener = WindowPanel(page, "talker"), WindowPanel(page, "listener")
    listener.start()
    listener.expect_state("running")
    talker.start()
    listener.wait_for("Hello, world! 3")
    heard = numbers(listener, "I heard")
    assert heard == list(range(heard[0], heard[-1] + 1))
    assert graph(page)["topics"] == [
        "/minimal_publisher > /chatter (std_msgs/msg/String) > /minimal_subscriber"
    ]
    listener.stop()
    talker.stop()
    assert graph(page)["all"] == []


def test_demo04_dances_and_says_why_there_is_no_real_robot(page: Window) -> None:
    open_demo(page, "demo04")
    robot = 'section[aria-label="Robot"]'
    page.wait_for(f"{robot} [role=status]", "This browser does not support Web Bluetooth.")
    assert not page.find(f"{robot} .ros-connect").is_enabled()
    WindowPanel(page, "colors").start()
    page.wait_for(f"{robot} dl", "yellow")
    dance = WindowPanel(page, "dance")
    dance.start()
    page.wait_for(f"{robot} dl", "Motor A35 %")
    page.click(f"{robot} input[type=checkbox]")
    dance.wait_for("Something is 0.05 m before me")
    page.wait_for(f"{robot} dl", "Motor A0 %")
    page.click(f"{robot} input[type=checkbox]")
    dance.wait_for("The way is free")
    page.wait_for(f"{robot} dl", "Motor A35 %")
    dance.stop()
    page.wait_for(f"{robot} [role=status]", "Stopped: no publishers on /cmd_vel any more")


def test_demo05_looks_inside(page: Window) -> None:
    open_demo(page, "demo05")
    talker, listener, server, client = (
        WindowPanel(page, name) for name in ("talker", "listener", "server", "client")
    )
    services, topics, publish, log = (
        f'section[aria-label="{name}"]' for name in ("Services", "Topics", "Publish", "Log")
    )

    def choose(tab: int) -> None:
        page.click(f".tabbed-labels label:nth-of-type({tab})")

    client.start()
    client.wait_for("No service yet, waiting")
    choose(4)
    page.click(f"{services} .ros-send")
    page.wait_for(f"{services} [role=status]", "no server for /add_two_ints now")
    server.start()
    client.wait_for("Sum: 42")
    client.expect_state("stopped")
    page.fill(f"{services} .ros-field:nth-of-type(1) input", "9007199254740993")
    page.fill(f"{services} .ros-field:nth-of-type(2) input", "-1")
    page.click(f"{services} .ros-send")
    page.wait_for(f"{services} [aria-label=response]", "sum: 9007199254740992")

    talker.start()
    listener.start()
    choose(2)
    page.wait_for(f"{topics} [role=log]", "data: Hello, world!")
    rate = f"{topics} tbody td:last-child span"
    page.wait_until(lambda: re.fullmatch(r"[12]\.\d\d Hz", page.text(rate)))
    choose(3)
    page.fill(f"{publish} .ros-field input", "Grüße")
    page.click(f"{publish} .ros-send")
    listener.wait_for("I heard: 'Grüße'")
    choose(5)
    page.wait_for('section[aria-label="Nodes"]', "MB of memory")
    drawn = "/minimal_publisher publishes /chatter"
    choose(1)
    page.find('section[aria-label="Graph"]')
    page.find(f'section[aria-label="Graph"] [aria-label*="{drawn}"]')
    choose(6)
    page.wait_for(f"{log} [role=log]", "add_two_ints_server: 40 + 2 = 42")
    page.fill(f"{log} input[type=search]", "Grüße")
    page.wait_until(lambda: page.evaluate(COUNT, f"{log} [role=log] > *") == 1)


def has_ended(panel: WindowPanel, lines: list[str]) -> bool:
    return plain([line.removesuffix(f"\n{ADVICE}") for line in panel.lines()]) == lines


def test_each_end_is_told_and_leaves_nothing(window: Window, serve: Serve, built: Built) -> None:
    window.goto(serve(built(SITES / "faults")))
    panels = {name: WindowPanel(window, name) for name in ENDS}
    for panel in panels.values():
        panel.start()
    for name, (lines, state) in ENDS.items():
        panels[name].expect_state(state)
        window.wait_until(partial(has_ended, panels[name], lines))
    assert graph(window)["all"] == []


def test_a_node_that_does_not_end_is_terminated(serve: Serve, built: Built) -> None:
    # In a browser of its own: WebKit lets a loop of WebAssembly compute on when its worker is
    # terminated, which would slow down all tests after this one.
    with webkit() as window:
        window.goto(serve(built(SITES / "faults")))
        busy = WindowPanel(window, "busy")
        busy.start()
        busy.wait_for("busy")
        busy.press("Stop")
        busy.wait_for("busy: did not end within a second and was terminated")
        assert graph(window)["all"] == []


def test_nodes_of_ros2wasm_run_and_compiled_ones_say_what_is_missing(
    window: Window, serve: Serve, ros2wasm: Path
) -> None:
    """The site leaves out the build for browsers without JSPI."""
    window.goto(serve(ros2wasm))
    talker, listener = WindowPanel(window, "old_talker"), WindowPanel(window, "old_listener")
    listener.start()
    listener.expect_state("running")
    talker.start()
    listener.wait_for("I heard: 'Hello, world! 3'")
    compiled = WindowPanel(window, "talker")
    compiled.start()
    compiled.expect_state("failed")
    compiled.wait_for("does not support JavaScript Promise Integration, which the node needs")


def test_callers_get_their_own_answers(window: Window, serve: Serve, built: Built) -> None:
    window.goto(serve(built(SITES / "services")))
    server, callers = WindowPanel(window, "server"), WindowPanel(window, "callers")
    server.start()
    callers.start()
    callers.wait_for("ready")
    assert callers.messages() == [
        "right 200, wrong 0, 1.000000, removed 1 0, early 1, late 1: at last",
        "ready 0, answered 0",
    ]
