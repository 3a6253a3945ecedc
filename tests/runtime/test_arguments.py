"""Arguments of the terminal's commands, against Python's argparse, which `ros2` uses."""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import subprocess
from collections.abc import Mapping
from typing import Any

import pytest
from paths import ROOT

SCRIPT = ROOT / "tests/support/verbs.mjs"
TYPES = {"int": int, "float": float}


def asked(*words: str) -> Any:
    """What the script prints."""
    done = subprocess.run(["node", SCRIPT, *words], text=True, capture_output=True, check=True)
    return json.loads(done.stdout)


@pytest.fixture(scope="module")
def verbs() -> list[Mapping[str, Any]]:
    found: list[Mapping[str, Any]] = asked("verbs")
    return found


def parser(verb: Mapping[str, Any]) -> argparse.ArgumentParser:
    """The parser of a verb, as Python has it."""
    made = argparse.ArgumentParser(
        prog=verb["prog"],
        description=verb["about"],
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    for one in verb["args"]:
        keys: dict[str, Any] = {"help": one["help"].replace("%", "%%")}
        if one.get("count") == "flag":
            keys["action"] = "store_true"
        else:
            if "count" in one:
                keys["nargs"] = argparse.REMAINDER if one["count"] == "..." else one["count"]
            for name in ("metavar", "choices"):
                if name in one:
                    keys[name] = one[name]
            if one.get("type") in TYPES:
                keys["type"] = TYPES[one["type"]]
        if "flags" in one:
            made.add_argument(*one["flags"], dest=one["name"], **keys)
        else:
            made.add_argument(one["name"], **keys)
    return made


def python(verb: Mapping[str, Any], words: list[str]) -> str:
    """What Python prints, or "" if it takes the words."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        try:
            parser(verb).parse_args(words)
        except SystemExit:
            return out.getvalue()
    return ""


@pytest.mark.parametrize("columns", [80, 132, 50])
def test_help_is_laid_out_as_by_argparse(
    verbs: list[Mapping[str, Any]], columns: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    lines = [(verb["prog"], ["--help"], columns) for verb in verbs]
    found = asked("arguments", json.dumps(lines))
    assert len(found) > 35
    for verb, text in zip(verbs, found, strict=True):
        assert text + "\n" == python(verb, ["--help"]), verb["prog"]


WRONG = [
    ("topic echo", ""),
    ("topic pub", "/chatter"),
    ("topic pub", "/chatter std_msgs/msg/String x --print 1.5"),
    ("topic echo", "/chatter --qos-reliability maybe"),
    ("topic echo", "/chatter --qos-"),
    ("topic echo", "/chatter --truncate-length"),
    ("topic hz", "/chatter --wall-time=yes"),
    ("service call", ""),
    ("param set", "/talker volume"),
    ("action send_goal", "/fibonacci example_interfaces/action/Fibonacci {} -t soon"),
    ("run", "speaking"),
    ("interface show", ""),
]


@pytest.mark.parametrize(("name", "words"), WRONG)
def test_errors_are_those_of_argparse(
    verbs: list[Mapping[str, Any]], name: str, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    [verb] = (each for each in verbs if each["prog"] == f"ros2 {name}")
    expected = python(verb, words.split())
    assert "error: " in expected
    [found] = asked("arguments", json.dumps([(verb["prog"], words.split(), 80)]))
    assert found + "\n" == expected


def test_options_may_be_short_joined_and_anywhere() -> None:
    def values(prog: str, *words: str) -> Any:
        return asked("arguments", json.dumps([(prog, words, 80)]))[0]

    found = values("ros2 topic list", "-tv")
    assert (found["show_types"], found["verbose"], found["count"]) == (True, True, False)
    found = values(
        "ros2 topic pub", "-r5", "/c", "--times=3", "std_msgs/msg/String", "-1", "{a: -1}"
    )
    assert (found["rate"], found["times"], found["once"], found["values"]) == (
        5,
        3,
        True,
        "{a: -1}",
    )
    # Abbreviations, as in argparse.
    assert values("ros2 topic echo", "/c", "--trunc", "7")["truncate_length"] == 7
    found = values("ros2 run", "p", "e", "--ros-args", "-r", "a:=b", "--help")
    assert found["argv"] == ["--ros-args", "-r", "a:=b", "--help"]
    assert values("ros2 param set", "/n", "p", "-3")["value"] == "-3"
    error = values("ros2 topic pub", "/c", "std_msgs/msg/String", "x", "-r", "fast")
    assert error.endswith("argument -r/--rate: invalid positive_float value: 'fast'")
    assert values("ros2 node info", "/n", "more", "words") == "unrecognized more words"
