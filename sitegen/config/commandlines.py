"""The commands of `ros2` in the text of a page, and the terminal that runs them."""

from __future__ import annotations

import re
import shlex
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

from sitegen.config.blocks import INNER_FENCE
from sitegen.config.nodes import Declared
from sitegen.errors import Location, Problems
from sitegen.model import Markdown, Part, Widget, leaves

# The widget that runs commands.
KIND = "terminal"


class Command(NamedTuple):
    """The words of a command after `ros2`, and its line."""

    words: Sequence[str]
    location: Location

    @property
    def program(self) -> tuple[str, str] | None:
        """The package and the executable that `ros2 run` starts."""
        if self.words[0] != "run":
            return None
        words = [word for word in self.words[1:] if not word.startswith("-")]
        return (words[0], words[1]) if len(words) > 1 else None


def with_terminal(
    parts: Sequence[Part], nodes: Mapping[str, Declared], own: Collection[str], problems: Problems
) -> list[Part]:
    """Return the content with a docked terminal if its text has commands and it has no terminal.

    The terminal can start the nodes `own`, and those of `nodes` whose program a command names. A
    page without nodes has nothing that a command could be about.
    """
    widgets = [part for part in leaves(parts) if isinstance(part, Widget)]
    texts = [part for part in leaves(parts) if isinstance(part, Markdown)]
    found = [command for text in texts for command in commands(text)]
    for widget in widgets:
        if widget.is_docked and not found:
            message = "a docked terminal opens when a visitor runs a command of the text"
            advice = "add a ```ros2 block, or remove 'docked'"
            problems.add(widget.location, f"{KIND}.docked", f"{message}; {advice}")
    if not found or any(widget.kind == KIND for widget in widgets):
        return list(parts)
    programs = {command.program for command in found}
    shown = {widget.target for widget in widgets}
    runs = [
        name
        for name, (node, _) in nodes.items()
        if name not in shown and (name in own or (node.package, node.executable) in programs)
    ]
    if not runs and not any(shown):
        return list(parts)
    return [*parts, Widget(KIND, "", {"nodes": runs, "docked": True}, found[0].location)]


def commands(text: Markdown) -> Iterator[Command]:
    """Yield each `ros2` in the `ros2` and `console` blocks of a text."""
    if "ros2" not in text.text:
        return
    fence, language, begun = "", "", ""
    for number, line in enumerate(text.text.split("\n"), start=text.location.line):
        edge = INNER_FENCE.match(line)
        if edge and not fence:
            fence, language = edge["fence"], re.split(r"[\s{}.]", f"{edge['info']} ")[0]
        elif edge and edge["fence"].startswith(fence) and not edge["info"]:
            fence = begun = ""
        elif fence and language in ("ros2", "console"):
            begun += line
            if line.endswith("\\"):
                begun = begun.removesuffix("\\")
                continue
            where = Location(text.location.file, number)
            yield from (Command(words, where) for words in _split(begun, language))
            begun = ""


def _split(line: str, language: str) -> Iterator[list[str]]:
    plain = line.strip()
    if language == "console" and not plain.startswith("$ "):
        return
    lexer = shlex.shlex(plain.removeprefix("$ "), posix=True, punctuation_chars="|;&<>")
    lexer.whitespace_split = True
    try:
        words = list(lexer)
    except ValueError:
        return
    command: list[str] = []
    for word in [*words, ";"]:
        if not set(word) <= set("|;&"):
            command.append(word)
            continue
        if command[:1] == ["ros2"] and len(command) > 1:
            yield command[1:]
        command = []
