"""The language of the terminal: words, quotes, pipes and lists."""

from __future__ import annotations

import json
import subprocess
from typing import Any

import pytest
from paths import ROOT


def parsed(line: str) -> Any:
    command = ["node", str(ROOT / "tests/support/verbs.mjs"), "lines", json.dumps([line])]
    done = subprocess.run(command, text=True, capture_output=True, check=True)
    return json.loads(done.stdout)[0]


def words(line: str) -> list[str]:
    """The words of a single command; `$name` stands for a variable."""
    [one] = parsed(line)
    [step] = one["steps"]
    [command] = step["pipeline"]["commands"]
    return [
        "".join(piece if isinstance(piece, str) else f"${piece['variable']}" for piece in word)
        for word in command["words"]
    ]


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("echo a  b", ["echo", "a", "b"]),
        ("echo 'a  b' \"c 'd'\"", ["echo", "a  b", "c 'd'"]),
        ('echo "{data: \\"x\\", y: \\n}"', ["echo", '{data: "x", y: \\n}']),
        ("echo a\\ b 'it'\\''s'", ["echo", "a b", "it's"]),
        ("echo '' \"\"", ["echo", "", ""]),
        ("echo $? '$?' \"$?\" a$ ${HOME}/x", ["echo", "$?", "$?", "$?", "a$", "$HOME/x"]),
        ("echo a # not this", ["echo", "a"]),
        ("echo a#b {a: [1, 2]}", ["echo", "a#b", "{a:", "[1,", "2]}"]),
        ("echo 'two\nlines'", ["echo", "two\nlines"]),
        ("echo a\\\nb", ["echo", "ab"]),
    ],
)
def test_words_are_those_of_sh(line: str, expected: list[str]) -> None:
    assert words(line) == expected


@pytest.mark.parametrize("line", ["echo 'a", 'echo "a', "echo a |", "echo a &&", "echo \\", "a\n|"])
def test_an_unfinished_line_is_continued(line: str) -> None:
    expected = "syntax error near unexpected token `|'" if line == "a\n|" else "unfinished"
    assert parsed(line) == expected


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("| grep", "syntax error near unexpected token `|'"),
        ("a ; ; b", "syntax error near unexpected token `;'"),
        ("a & && b", "syntax error near unexpected token `&&'"),
        ("(a)", "syntax error near unexpected token `('"),
        ("a > | b", "syntax error near unexpected token `|'"),
        ("echo $(a)", "command substitution is not supported here"),
        ("echo `a`", "command substitution is not supported here"),
        ("x" * 110_000, "line too long"),
    ],
)
def test_what_is_wrong_is_named(line: str, expected: str) -> None:
    assert parsed(line) == expected


def test_lists_pipes_and_redirections() -> None:
    first, second = parsed("a 1 | b 2>&1 > out.txt && c || d & e < in.txt >> more")
    assert (first["background"], second["background"]) == (True, False)
    assert first["text"] == "a 1 | b 2>&1 > out.txt && c || d"
    assert [step["when"] for step in first["steps"]] == ["always", "success", "failure"]
    piped = first["steps"][0]["pipeline"]["commands"]
    assert [command["words"][0] for command in piped] == [["a"], ["b"]]
    assert (piped[1]["to"], piped[1]["merged"]) == ({"file": ["out.txt"], "append": False}, True)
    [step] = second["steps"]
    [command] = step["pipeline"]["commands"]
    assert (command["from"], command["to"]["append"]) == (["in.txt"], True)
