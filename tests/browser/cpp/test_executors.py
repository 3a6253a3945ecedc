"""Executors, callback groups and contexts of C++ in the page."""

from __future__ import annotations

import pytest
from panel import Played
from paths import SITES

pytestmark = pytest.mark.firefox

SITE = SITES / "rclcpp"
WAYS = (
    "125 waited TIMEOUT (2); Node '/ways' has already been added to an executor."
    "; max_duration must be greater than or equal to 0"
    "; spin() called while already spinning"
    "; Node needs to be associated with an executor."
)


def test_executors_call_back_as_their_groups_allow(played: Played) -> None:
    executors = played(SITE, "executors", "executors")
    assert executors.lines() == [
        "overlap 0",
        "overlap 1, several threads",
        "overlap 1, several threads",
        "inside 1 42",
        "own SUCCESS (0), in its thread 1",
        f"single: {WAYS}",
        f"static: {WAYS}",
        f"events: {WAYS}",
        "contexts renamed named: before after, enough, still 1",
        "guard 3",
        "told timer alone of telling, /told free of telling, 1, 1",
        "done",
    ]


def test_waitables_of_ones_own_are_waited_for(played: Played) -> None:
    waitables = played(SITE, "executors", "waitables")
    assert waitables.lines() == [
        "bell 1",
        "old bell",
        "removed",
        "bell 2",
        "timeout",
        "matched 1",
        "has use_sim_time",
    ]


def test_nodes_of_a_program_hand_over_messages(played: Played) -> None:
    handing = played(SITE, "executors", "handing")
    # Who owns what it gets has a copy where others look at the message, as upstream does it.
    assert handing.lines() == [
        "1 in this program",
        "own 1 itself",
        "own 2 a copy",
        "shared 2 itself",
        "reference 2 itself",
        "0 in this program",
        "own 3 a copy",
        "shared 4 a copy",
        "shared 5 itself",
    ]


def test_wait_sets_find_what_is_ready(played: Played) -> None:
    waits = played(SITE, "executors", "waits")
    assert waits.lines() == [
        "empty 1",
        "timeout 1",
        "ready 1: 1 0",
        "took 1 first, no more 0",
        "handled first",
        "guard 1",
        "timer",
        "guard condition already associated with a wait set",
        "stopped 1",
        "still ready 1",
    ]
