"""Split a CMake file into commands and blocks."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from sitegen.errors import Location

TOKEN = re.compile(
    r"""
      \#\[(?P<remark>=*)\[.*?\](?P=remark)\]       # bracket comment
    | \#[^\n]*                                     # comment
    | \[(?P<level>=*)\[(?P<bracket>.*?)\](?P=level)\]
    | "(?P<quoted>(?:[^"\\]|\\.)*)"
    | (?P<paren>[()])
    | (?P<word>(?:[^\s()\#"\\;]|\\.)+)
    """,
    re.VERBOSE | re.DOTALL,
)


class Command(NamedTuple):
    """The name in lower case, and the arguments as written."""

    name: str
    words: list[str]
    location: Location


def parse(text: str, file: Path) -> Iterator[Command]:
    """Yield the commands of a file."""
    name, words, depth, line = "", list[str](), 0, 1
    for token in TOKEN.finditer(text):
        word = next((token[kind] for kind in ("word", "quoted", "bracket") if token[kind]), "")
        if token["bracket"]:
            # Elsewhere, a backslash begins an escape sequence.
            word = word.replace("\\", "\\\\")
        if token["paren"] == "(":
            depth += 1
        elif token["paren"] == ")":
            depth -= 1
            if depth == 0:
                yield Command(name, words, Location(file, line))
                name, words = "", []
        elif word and depth == 0:
            name, line = word.lower(), text.count("\n", 0, token.start()) + 1
        elif word:
            words.append(word)


def until(end: str, begin: str, commands: Iterator[Command]) -> Iterator[Command]:
    """Yield the commands up to the end of the current block."""
    depth = 1
    for command in commands:
        depth += (command.name == begin) - (command.name == end)
        if depth == 0:
            return
        yield command


def branch(block: Iterator[Command], *, first: bool) -> list[Command]:
    """Return the commands of an if() block up to else(), or what is left of it without them."""
    found, depth, other = list[Command](), 0, False
    for command in block:
        name, words, location = command
        if depth == 0 and name in ("else", "elseif") and not other:
            other = True
            if name == "elseif" and not first:
                return [Command("if", words, location), *block, Command("endif", [], location)]
            continue
        depth += (name == "if") - (name == "endif")
        if other != first:
            found.append(command)
    return found
