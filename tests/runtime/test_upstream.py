"""The options of the terminal's commands, against those of ros2cli.

`ros2cli.json` has the options of ros2cli 0.36.1 (e20d2c6, between Jazzy and Kilted): for each verb
the file and line that define it, and for each option what its help shows.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from paths import ROOT
from verbs import asked

UPSTREAM: dict[str, dict[str, Any]] = json.loads(
    (Path(__file__).parent / "ros2cli.json").read_text()
)
# A page has no network, so these have nothing to work on.
ABSENT = {"ros2 doctor hello", "ros2 multicast receive", "ros2 multicast send"}
# Options that later versions have added; 935 and the like are pull requests of ros2cli.
QOS = [
    *("--qos-profile", "--qos-depth", "--qos-history", "--qos-reliability", "--qos-durability"),
    *("--qos-liveliness", "--qos-liveliness-lease-duration-seconds"),
]
LATER: dict[str, list[str]] = {
    "ros2 topic bw": QOS,  # 935
    "ros2 topic delay": QOS,  # 935
    "ros2 topic hz": QOS,  # 935
    "ros2 service call": QOS,  # 966
    "ros2 service info": ["--verbose"],  # commit 7d9a451
    "ros2 action send_goal": ["--timeout"],  # 1067
}


@pytest.fixture(scope="module")
def ours() -> dict[str, Mapping[str, Any]]:
    return {verb["prog"]: verb for verb in asked("verbs")}


def known(argument: Mapping[str, Any]) -> dict[str, Any]:
    """What the help of an argument of ours shows, in the form of the table."""
    flags = argument.get("flags")
    bare = argument.get("choices") or argument.get("count") == "flag"
    name = argument["name"].upper() if flags else argument["name"]
    shown = argument.get("metavar") or (None if bare else name)
    found = {key: argument.get(key) for key in ("flags", "count", "type", "choices", "help")}
    if found["choices"]:
        found["choices"] = [str(one) for one in found["choices"]]
    return {key: value for key, value in {**found, "shown": shown}.items() if value is not None}


def groups(arguments: list[Any]) -> set[frozenset[str]]:
    """The sets of arguments that exclude each other."""
    named: dict[str, set[str]] = {}
    for one in arguments:
        if "group" in one:
            name = (one.get("flags") or [one.get("name") or one["shown"]])[0]
            named.setdefault(one["group"], set()).add(name)
    return {frozenset(each) for each in named.values()}


# Groups without verbs have no options of their own that differ.
VERBS = [name for name, one in UPSTREAM.items() if name not in ABSENT and one["args"]]


@pytest.mark.parametrize("name", VERBS)
def test_a_verb_has_the_options_of_ros2cli(name: str, ours: dict[str, Mapping[str, Any]]) -> None:
    if name.count(" ") == 1 and name not in ours:
        return  # the options of a command with verbs are tested below
    verb, expected = ours[name], UPSTREAM[name]
    assert verb["about"] == expected["about"], expected["source"]
    later = LATER.get(name, [])
    arguments = [one for one in verb["args"] if not {*one.get("flags", [])} & {*later}]
    assert [one for one in verb["args"] if one not in arguments] or not later
    wanted = [{k: v for k, v in one.items() if k != "group"} for one in expected["args"]]
    assert [known(one) for one in arguments] == wanted, expected["source"]
    assert groups(arguments) == groups(expected["args"]), expected["source"]


def test_every_verb_of_ros2cli_is_known(ours: dict[str, Mapping[str, Any]]) -> None:
    verbs = {name for name in UPSTREAM if name.count(" ") == 2}
    assert verbs - ABSENT <= set(ours)
    alone = {"ros2 doctor", "ros2 run", "ros2 wtf"}
    assert alone <= set(ours)


ROW = re.compile(r"^\| `ros2 (\w+)` \| (.*) \|$", re.M)


def test_the_documentation_lists_every_verb(ours: dict[str, Mapping[str, Any]]) -> None:
    text = (ROOT / "docs/terminal.md").read_text()
    listed = {group: {*re.findall(r"`(\w+)`", verbs)} for group, verbs in ROW.findall(text)}
    known: dict[str, set[str]] = {}
    for name in ours:
        _, group, *verb = name.split()
        known.setdefault(group, set()).update(verb)
    # These only say that a page does not have them, which is among the differences.
    for group, verbs in {"bag": "convert list reindex", "pkg": "create prefix xml"}.items():
        known[group] -= {*verbs.split()}
        assert all(re.search(rf"`(ros2 \w+ )?{verb}`", text) for verb in verbs.split())
    del known["wtf"]
    assert {group: listed[group] & verbs for group, verbs in known.items()} == known
    assert {*listed} == {*known}
