"""Arguments of the terminal's commands, against Python's argparse, which `ros2` uses."""

from __future__ import annotations

import argparse
import contextlib
import io
import re
from collections.abc import Mapping
from random import Random
from typing import Any

import pytest
from verbs import asked


def positive_int(text: str) -> int:
    """Read a number as ros2topic does; so do the others."""
    try:
        value = int(text)
    except ValueError:
        value = -1
    if value <= 0:
        raise argparse.ArgumentTypeError("value must be a positive integer")
    return value


def unsigned_int(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        value = -1
    if value < 0:
        raise argparse.ArgumentTypeError("value must be non-negative integer")
    return value


def nonnegative_int(text: str) -> int:
    value = int(text)
    if value < 0:
        raise ValueError
    return value


def positive_float(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError("Expects a floating point number") from None
    if value <= 0.0:
        raise argparse.ArgumentTypeError("Value must be positive")
    return value


UNRECOGNIZED = re.compile(r"\A(?s:.*)unrecognized arguments: ")
READERS = (int, float, positive_int, unsigned_int, nonnegative_int, positive_float)
TYPES = {each.__name__: each for each in READERS}


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
    groups: dict[str, Any] = {}
    for one in verb["args"]:
        keys: dict[str, Any] = {"help": one["help"].replace("%", "%%")}
        place: Any = made
        if "group" in one:
            name = one["group"]
            place = groups[name] = groups.get(name) or made.add_mutually_exclusive_group()
        if one.get("count") == "flag":
            keys["action"] = "store_true"
        elif one.get("count") == "append":
            keys |= {"action": "append"} | ({"metavar": one["metavar"]} if "metavar" in one else {})
        else:
            if "count" in one:
                keys["nargs"] = {"...": argparse.REMAINDER, "1": 1}.get(one["count"], one["count"])
            for name in ("metavar", "choices"):
                if name in one:
                    keys[name] = one[name]
            if one.get("type") in TYPES:
                keys["type"] = TYPES[one["type"]]
            if "initial" in one and one["initial"] != "inf":
                keys["default"] = one["initial"]
        if "flags" in one:
            place.add_argument(*one["flags"], dest=one["name"], **keys)
        else:
            place.add_argument(one["name"], **keys)
    return made


def python(verb: Mapping[str, Any], words: list[str]) -> str:
    """What Python prints, or "" if it takes the words."""
    return printed(parser(verb), words)


def printed(made: argparse.ArgumentParser, words: list[str]) -> str:
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        try:
            made.parse_args(words)
        except SystemExit:
            return out.getvalue()
    return ""


@pytest.mark.parametrize("columns", [80, 132, 50])
def test_help_is_laid_out_as_by_argparse(
    verbs: list[Mapping[str, Any]], columns: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    lines = [(verb["prog"], ["--help"], columns) for verb in verbs]
    found = asked("arguments", lines)
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
    ("topic pub", "/chatter std_msgs/msg/String -1 -t 3"),
    ("topic pub", "/chatter std_msgs/msg/String x --stdin"),
    ("topic hz", "--window 3"),
    ("param list", "/talker --filter"),
    ("param describe", "/talker"),
    ("component unload", "/box one"),
    ("component load", "/box p -r"),
    ("interface show", "--all-comments --no-comments x"),
    ("doctor", "-r --report-failed"),
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
    [found] = asked("arguments", [(verb["prog"], words.split(), 80)])
    assert found + "\n" == expected


def test_options_may_be_short_joined_and_anywhere() -> None:
    def values(prog: str, *words: str) -> Any:
        return asked("arguments", [(prog, words, 80)])[0]

    found = values("ros2 topic list", "-tv")
    assert (found["show_types"], found["verbose"], found["count"]) == (True, True, False)
    found = values(
        "ros2 topic pub", "-r5", "/c", "std_msgs/msg/String", "{a: -1}", "--print=3", "-1"
    )
    assert (found["rate"], found["print"], found["once"], found["values"]) == (
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
    assert error.endswith("argument -r/--rate: Expects a floating point number")
    assert values("ros2 node info", "/n", "more", "words") == "unrecognized more words"


# Words that mutation inserts.
ODD = [
    *("--", "-", "-h", "--help", "--nope", "-x", "-1", "-1.5", "1e3", "--qos-", "--once=3", "-tv"),
    *("", "a b", "--spin-time", "x", "--no", "-s", "{a: -1}", "--r", "-r5", "-r=5", "--rate="),
    *("inf", "nan", "0", "-0", "1_0", "é", "--window", "--stdin", "--rate", "\0", "$(x)"),
]
SEEDS = {
    "topic echo": "/chatter std_msgs/msg/String --once --csv -l 5 --qos-depth 3",
    "topic pub": "/chatter std_msgs/msg/String {data: -r 5 -1 -w 2 --keep-alive 1",
    "topic hz": "/a /b --window 3 -s",
    "param set": "/talker volume 3 --timeout 2",
    "param list": "/talker --filter x --param-prefixes a b --param-type",
    "service call": "/mute std_srvs/srv/SetBool {} -r 1",
    "action send_goal": "/f test_msgs/action/Fibonacci {} -f",
    "component load": "/box p q -n x -r a:=b -r c:=d",
    "component unload": "/box 1 2 -q",
    "interface show": "std_msgs/msg/String --no-comments",
    "doctor": "-r -iw",
    "run": "speaking talker --ros-args -r a:=b",
    "node info": "/talker --include-hidden --spin-time 2",
    "lifecycle set": "/talker activate",
    "pkg create": "x --package-format 3 --dependencies a b",
    "launch": "p f a:=b",
}


def mutated(random: Random, text: str) -> list[str]:
    """The words of a command line, some of them removed, inserted and changed."""
    words = text.split()
    for _ in range(random.randint(1, 4)):
        chance = random.random()
        if chance < 0.3 and words:
            del words[random.randrange(len(words))]
        elif chance < 0.7 or not words:
            words.insert(random.randint(0, len(words)), random.choice(ODD))
        else:
            index = random.randrange(len(words))
            word = words[index]
            cut = random.randint(0, len(word))
            end = cut + random.randint(0, 2)
            words[index] = word[:cut] + random.choice(["-", "=", '"', "9", "z", ""]) + word[end:]
    return words


def test_mutated_arguments_have_the_errors_of_argparse(
    verbs: list[Mapping[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    random = Random(33)
    known = {verb["prog"]: parser(verb) for verb in verbs}
    names = random.choices(list(SEEDS), k=10_000)
    cases = [(f"ros2 {name}", mutated(random, SEEDS[name]), 80) for name in names]
    wrong = 0
    for (name, words, _), found in zip(cases, asked("arguments", cases), strict=True):
        expected = printed(known[name], words).removesuffix("\n")
        # As in ros2, words that nothing takes are an error of the whole command.
        expected = UNRECOGNIZED.sub("unrecognized ", expected)
        assert expected == (found if isinstance(found, str) else ""), (name, words)
        wrong += bool(expected)
    assert wrong > 4000
