"""Actions and managed nodes in a terminal, with Python nodes."""

from __future__ import annotations

import re

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from terminal import Terminal

GOAL = r"""Waiting for an action server to become available\.\.\.
Sending goal:
     order: 2

Goal accepted with ID: [0-9a-f]{32}

"""
RESULT = r"""Result:
    sequence:
- 0
- 1
- 1

Goal finished with status: SUCCEEDED"""
FEEDBACK = r"""Feedback:
    (?:partial_)?sequence:
- 0
- 1
- 1

"""


def test_goals_and_transitions(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(serve(built(SITES / "instruments")) + "terminal/")
    terminal = Terminal(tab, 110)
    terminal.await_names("/managed/change_state", "/fibonacci/_action/send_goal")
    kind = "test_msgs/action/Fibonacci"
    for line, expected in [
        ("ros2 action list", "/fibonacci"),
        ("ros2 action list -t", f"/fibonacci [{kind}]"),
        ("ros2 action type /fibonacci", kind),
        ("ros2 action find " + kind, "/fibonacci"),
        (
            "ros2 action info /fibonacci",
            "Action: /fibonacci\nAction clients: 0\nAction servers: 1\n    /counter",
        ),
        (
            "ros2 action info /fibonacci -t | tail -1",
            f"    /counter [{kind}]",
        ),
        (
            f"ros2 interface show {kind}",
            "int32 order\n---\nint32[] sequence\n---\nint32[] sequence",
        ),
        ("ros2 lifecycle nodes", "/managed"),
        ("ros2 lifecycle get /managed", "unconfigured [1]"),
        ("ros2 lifecycle get", "/managed: unconfigured [1]"),
        (
            "ros2 lifecycle list /managed",
            "- configure [1]\n\tStart: unconfigured\n\tGoal: configuring\n"
            "- shutdown [5]\n\tStart: unconfigured\n\tGoal: shuttingdown".expandtabs(8),
        ),
        ("ros2 lifecycle set /managed configure", "Transitioning successful"),
        ("ros2 lifecycle get /managed", "inactive [2]"),
        ("ros2 lifecycle set /managed activate; echo $?", "Transitioning failed\n0"),
        (
            "ros2 lifecycle set /managed fly; echo $?",
            "Unknown transition requested, available ones are:\n- cleanup [2]\n- activate [3]\n"
            "- shutdown [6]\n1",
        ),
        ("ros2 lifecycle get /counter; echo $?", "Node not found\n1"),
    ]:
        assert terminal.run(line) == expected, line
    found = terminal.run(f"ros2 action send_goal /fibonacci {kind} '{{order: 2}}'")
    assert re.fullmatch(GOAL + RESULT, found), found
    found = terminal.run(f"ros2 action send_goal -f /fibonacci {kind} '{{order: 2}}'")
    assert re.search(FEEDBACK, found), found
    assert re.search(RESULT, found), found
    found = terminal.run(f"ros2 action send_goal /fibonacci {kind} '{{order: 3}}' | tail -1")
    assert found == "Goal finished with status: ABORTED"
    found = terminal.run(f"ros2 action send_goal /fibonacci {kind} '{{order: -1}}' | tail -1")
    assert found == "Goal was rejected."
    # Ctrl-C cancels a goal.
    terminal.begin(f"ros2 action send_goal -f /fibonacci {kind} '{{order: 40}}'")
    terminal.wait_for("Feedback:")
    terminal.interrupt()
    # Feedback that was on its way may be printed in between.
    assert re.search(r"Canceling goal\.\.\.\n(.*\n)*Goal canceled\.", terminal.text())
    assert terminal.status() == 2
    for line, expected in [
        (
            f"ros2 action send_goal /fibonacci {kind} 7; echo $?",
            "Failed to populate message fields: TypeError(\"Value '7' is expected to be a dict",
        ),
        ("ros2 action send_goal /fibonacci a/action/B '{}'; echo $?", "The passed action type is"),
    ]:
        assert terminal.run(line).startswith(expected)
        assert terminal.run(line).endswith("\n1")
