"""Managed nodes, and nodes in the other forms that packages use them in."""

from __future__ import annotations

import pytest
from panel import LINE, Panel, Played
from paths import SITES

pytestmark = pytest.mark.firefox

SITE = SITES / "rclcpp"
INACTIVE = (
    "Trying to publish message on the topic '/lifecycle_chatter', "
    "but the publisher is not activated"
)


def said(panel: Panel) -> list[str]:
    """What a node printed, and of what it logged the text."""
    matches = [(LINE.match(line), line) for line in panel.lines()]
    return [match[3] if match else line for match, line in matches]


def test_a_managed_node_changes_its_state(played: Played) -> None:
    managed = played(SITE, "forms", "managed")
    assert said(managed) == [
        "configure from unconfigured",
        "1 inactive",
        INACTIVE,
        "1 active",
        "heard in time",
        "No transition matching 1 found for current state active",
        "Unable to start transition 1 from current state active: Transition is not registered.",
        "0 active",
        "1 inactive",
        INACTIVE,
        "0 inactive",
        "Caught exception in callback for transition 11",
        "Original error: stuck",
        "Error occurred while doing error handling.",
        "0 unconfigured",
        "2 transitions",
        "finalized",
    ]


def test_a_node_has_its_other_forms(played: Played) -> None:
    forms = played(SITE, "forms", "forms")
    lines = said(forms)
    words = lines.pop(2).split(", ")
    forms_of = [f"{kind} {word}" for word in ("one", "two", "three") for kind in KINDS]
    assert sorted(words) == sorted(forms_of)
    assert lines == [
        "/space/part forms",
        "/space/part/words",
        "filter 1: abc b last",
        "failed to set cft expression parameters: the message has no field 'date'",
        "data = %0 OR NOT data LIKE 'a%'",
        "filter 1: b last",
        "filter 0: a ab abc b last",
        # One ignores what its own process publishes, and is matched with it all the same.
        "own: one two, 0, 1",
        "components::Circle is a components::Circle of components: ",
        "Could not create instance of type components::Circle",
        "round is a family::Round of family: ",
        "area 28",
        "square is a components::Square of components: All sides are the same.",
        "area 9",
        "According to the loaded plugin descriptions the class triangle with base class type "
        "components::Shape does not exist. Declared types are  components::Circle round square",
        "there 0 1 1 1, 5 bytes, one.tar.gz .gz one",
        "made 1 0, removed 1 0 1",
        "timer 1",
        "# the robot of this test",
        "package 'nowhere' not found, searching: [/ros]",
        "index 1 0 1",
        "r2d2 2.5",
        "logged 0",
        "logged 1",
        "option 0 topic",
    ]


KINDS = ("custom", "plain", "generic")
