"""Programs that fail, never end, or wait in the middle of main(), in a real browser."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from browser import Built, Serve, whole
from panel import Panel, expect_nothing_left
from paths import SITES
from playwright.sync_api import Browser, BrowserContext, Page, expect

pytestmark = [pytest.mark.firefox(always=True), pytest.mark.asyncify(always=True)]

SITE = SITES / "faults"

STACK_OVERFLOW = "stack overflow: too many nested calls, or too large local variables"
# What the console of each node shows in the end, without the log's head, and the node's state.
ENDS = {
    "throw": (["throw: robot::BatteryError: battery <b>low</b>"], "failed"),
    "throw_in_callback": (["throw_in_callback: std::out_of_range: no such wheel"], "failed"),
    "abort": (["abort: aborted"], "failed"),
    "assert": (["assert: faults/src/fault.cpp:78: assertion failed: zero == 1"], "failed"),
    "trap": (["trap: unreachable"], "failed"),
    "trap_after_wait": (["trap_after_wait: unreachable"], "failed"),
    "out_of_memory": (["out_of_memory: out of memory (std::bad_alloc)"], "failed"),
    "recursion": ([f"recursion: {STACK_OVERFLOW}"], "failed"),
    "large_variable": ([f"large_variable: {STACK_OVERFLOW}"], "failed"),
    "large_frames": ([f"large_frames: {STACK_OVERFLOW}"], "failed"),
    "exit": (["exit: exited with code 3"], "failed"),
    "unknown_argument": (
        [
            "unknown_argument: rclcpp::exceptions::UnknownROSArgsError: "
            "found unknown ROS arguments: '--paint' 'red'"
        ],
        "failed",
    ),
    "catch": (["WARN caught: a small thing"], "stopped"),
    "sleep": (["slept 1", "no newline at the end"], "stopped"),
    "steps": (["INFO never waited for anything else", "ERROR timeout: 1"], "stopped"),
    "levels": (
        [
            "DEBUG shown  3.14 -5000000000 4 ff z %",
            "FATAL stream 1 1",
            "INFO once 0",
            "INFO skipped first 1",
            "INFO skipped first 2",
            "WARN throttled 0",
        ],
        "stopped",
    ),
}
# The last line of what failed by itself.
ADVICE = "    (run 'sitegen build --debug' to see where)"


def plain(lines: list[str]) -> list[str]:
    """Lines of a console without what differs: the times, and how a browser calls a trap."""
    heads = [re.sub(r"^\[(\w+)\] \[[\d.]+\] \[fault\]: ", r"\1 ", line) for line in lines]
    return [re.sub(r": unreachable.*", ": unreachable", line, flags=re.I) for line in heads]


@pytest.fixture(scope="module")
def browser(browser: Browser) -> Iterator[Browser]:
    with whole(browser) as found:
        yield found


@pytest.fixture
def page(browser_name: str, context: BrowserContext, serve: Serve, built: Built) -> Iterator[Page]:
    page = context.new_page()
    uncaught: list[str] = []
    page.on("pageerror", lambda error: uncaught.append(str(error)))
    page.goto(serve(built(SITE)))
    yield page
    page.close()
    if browser_name == "firefox":
        # So it calls a worker that was terminated while its program computed.
        uncaught = [error for error in uncaught if error != "undefined"]
    assert uncaught == []


def test_each_end_is_told_and_leaves_nothing(page: Page) -> None:
    panels = {name: Panel(page, name) for name in ENDS}
    for panel in panels.values():
        panel.start()
    for name, (lines, state) in ENDS.items():
        panels[name].expect_state(state)
        panels[name].wait_for(lines[-1].split(" ", 1)[-1])
        advice = [ADVICE] if state == "failed" and name != "exit" else []
        assert plain(panels[name].lines()) == [*lines, *advice]
    expect_nothing_left(page)


def test_a_failure_is_red(page: Page) -> None:
    panel = Panel(page, "trap")
    panel.start()
    panel.expect_state("failed")
    line = panel.console.get_by_text("trap: unreachable")
    red, green, blue = map(
        int, re.findall(r"\d+", line.evaluate("element => getComputedStyle(element).color"))[:3]
    )
    assert red > 1.5 * max(green, blue)


def test_a_program_that_never_waits_is_terminated(page: Page) -> None:
    panel = Panel(page, "busy")
    panel.start()
    panel.wait_for("busy")
    panel.stop()
    panel.wait_for("busy: did not end within a second and was terminated")
    expect_nothing_left(page)


def test_a_flood_of_lines_keeps_the_last(page: Page) -> None:
    panel = Panel(page, "flood")
    panel.start()
    panel.wait_for("line 99999")
    assert panel.lines() == [f"line {number}" for number in range(99_000, 100_000)]
    panel.stop()
    expect_nothing_left(page)


def test_a_node_that_is_terminated_in_the_middle_of_large_messages_spoils_nothing(
    page: Page,
) -> None:
    pour, drink = Panel(page, "pour"), Panel(page, "drink")
    drink.start()
    drink.expect_state("running")
    for turn in range(3):
        before = len(drink.lines())
        pour.start()
        expect(drink.console.locator("> *")).not_to_have_count(before)
        pour.stop()
        assert "pour: did not end within a second and was terminated" in pour.lines()[turn:]
    assert {message for message in drink.messages()} == {"a large message, whole"}
    drink.stop()
    expect_nothing_left(page)


def test_what_a_program_published_before_it_ended_arrives(page: Page) -> None:
    speaker, listener = Panel(page, "last_words"), Panel(page, "listen")
    listener.start()
    speaker.start()
    speaker.expect_state("stopped")
    listener.wait_for("heard 300 words")
    # What a program returns that was stopped is told, and is no failure.
    listener.stop()
    listener.wait_for("listen: exited with code 1")
    expect_nothing_left(page)
