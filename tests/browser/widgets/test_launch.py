"""What launch files do while their nodes run, on pages and in the terminal."""

from __future__ import annotations

import base64
import json
from collections.abc import Sequence

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import BrowserContext, expect
from playwright.sync_api import Page as Tab
from terminal import Terminal

SITE = SITES / "events"


def in_order(lines: Sequence[str], *wanted: str) -> bool:
    """Return whether lines occur in this order, with others between them."""
    left = iter(lines)
    return all(any(line == each for line in left) for each in wanted)


@pytest.mark.firefox
def test_nodes_start_one_after_another(context: BrowserContext, serve: Serve, built: Built) -> None:
    tab = context.new_page()  # a node ends with an error
    tab.goto(serve(built(SITE)))
    panel = Panel(tab, "order.launch.py", "Launch")
    for last in ("later has started", "second is up", "of '/robot/managed' failed"):
        panel.wait_for(last)
    lines = panel.lines()
    assert lines[:2] == ["late: starts after 0.2 s", "second: starts after first has ended"]
    assert in_order(lines, "first has started", "begins", "late has started", "later has started")
    assert in_order(
        lines,
        *("first has started", "first has ended with exit code 3", "first has ended with 3"),
        *("second has started", "second is up"),
    )
    # Natively, `cleanup` fails, too, and then the node stays inactive.
    assert in_order(
        lines,
        *("managed has started", "configured", "managed is active"),
        "transition 'cleanup' of '/robot/managed' failed",
    )
    assert lines.count("configured") == 1
    for node, expected in (("managed", ["up", "configured", "activated"]), ("managed_2", ["up"])):
        assert Panel(tab, node).lines() == expected
    assert Panel(tab, "auto").lines() == ["up", "configured", "activated"]


def test_a_node_that_starts_again_changes_its_state_again(
    context: BrowserContext, serve: Serve, built: Built
) -> None:
    tab = context.new_page()
    tab.goto(serve(built(SITE)))
    auto = Panel(tab, "auto")
    auto.wait_for("activated")
    auto.stop()
    auto.button("Clear").click()
    auto.start()
    auto.wait_for("activated")
    assert auto.lines() == ["up", "configured", "activated"]


@pytest.mark.firefox
def test_a_required_node_ends_all_others(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}ends/")
    panel = Panel(tab, "ends.launch.xml", "Launch")
    because = "All nodes are stopped, because required has ended"
    panel.wait_for(because)
    panel.expect_state("stopped")
    lines = panel.lines()
    assert in_order(lines, "late has started", "required has ended", because, "late has ended")
    # It is started again once, and its timer is not waited for.
    assert lines.count("again has started") == 2
    assert Panel(tab, "never").lines() == []
    # All of it once more.
    panel.button("Clear").click()
    panel.button("Launch").click()
    panel.expect_state("running")
    panel.wait_for(because)
    lines = panel.lines()
    assert in_order(lines, "required has started", "late has started", because, "late has ended")
    assert lines.count("again has started") == 2


def test_what_waits_ends_with_stop(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}asked/")
    panel = Panel(tab, "ends.launch.xml", "Launch")
    # The node with buttons waits for the visitor, the others do not.
    panel.wait_for("late has started")
    Panel(tab, "required").expect_state("stopped")
    panel.button("Stop").click()
    panel.expect_state("stopped")
    # Whoever starts it gets what the launch file does about it.
    Panel(tab, "required").start()
    panel.wait_for("All nodes are stopped, because required has ended")
    expect(panel.button("Launch")).to_be_enabled()


def test_a_link_restores_what_ran(tab: Tab, serve: Serve, built: Built) -> None:
    state = base64.urlsafe_b64encode(json.dumps({"run": ["late"]}).encode()).decode().rstrip("=")
    tab.goto(f"{serve(built(SITE))}ends/#share=1.{state}")
    # It starts without a question, as it would without the link; nothing is launched.
    Panel(tab, "late").expect_state("running")
    panel = Panel(tab, "ends.launch.xml", "Launch")
    panel.wait_for("late has started")
    assert panel.lines() == ["late has started"]
    expect(tab.locator(".ros-word")).to_have_count(0)
    Panel(tab, "required").expect_state("stopped")


def test_the_terminal_does_the_same(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}asked/")
    Panel(tab, "ends.launch.xml", "Launch").wait_for("late has started")
    terminal = Terminal(tab, 130)
    lines = terminal.run("ros2 launch bringup ends.launch.xml; echo $?").split("\n")
    assert in_order(
        lines,
        *("[INFO] [act-1]: process started", "[INFO] [act-2]: process started"),
        *("[act-1] up", "[INFO] [act-3]: process started", "[act-3] up"),
        "[INFO] [launch]: process[act-1] was required: shutting down launched system",
        "[INFO] [act-3]: process has finished cleanly",
        "0",
    )
    assert lines.count("[INFO] [act-2]: process started") == 2


def test_one_node_follows_another(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}follow/")
    panel = Panel(tab, "follow.launch.py", "Launch")
    expect(panel.panel).to_contain_text("Press Launch to start all nodes")
    # A visitor starts the first one; the other one is started by what happens.
    Panel(tab, "first").start()
    panel.wait_for("All nodes are stopped: all is done")
    expected = ["first has started", "first has ended", "last has started", "last has ended"]
    assert panel.lines() == [*expected, "over", "All nodes are stopped: all is done"]
    terminal = Terminal(tab, 130)
    assert terminal.run("ros2 launch bringup follow.launch.py").split("\n") == [
        "[INFO] [act-1]: process started",
        "[act-1] up",
        "[INFO] [act-1]: process has finished cleanly",
        "[INFO] [act-2]: process started",
        "[act-2] up",
        "[INFO] [act-2]: process has finished cleanly",
        "[INFO] [launch.user]: over",
        "[INFO] [launch]: process[act-2] was required: shutting down launched system",
    ]


def test_a_timer_follows_simulated_time(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}simulated/")
    panel = Panel(tab, "simulated.launch.xml", "Launch")
    panel.wait_for("first has started")
    terminal = Terminal(tab, 130)
    # To the node and to the timer; time begins at 10, jumps back to 2, and is over at 7.
    publish = "ros2 topic pub --once -w 2 /clock rosgraph_msgs/msg/Clock '{{clock: {{sec: {}}}}}'"
    for second in (10, 14, 2, 6):
        assert "publishing #1" in terminal.run(publish.format(second))
    assert panel.lines() == ["late: starts after 5 s", "first has started"]
    assert "publishing #1" in terminal.run(publish.format(7))
    panel.wait_for("late has started")
