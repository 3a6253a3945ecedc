"""Find commands of `ros2` in texts that name what their page does not have."""

from __future__ import annotations

import re
import shlex
from collections.abc import Collection, Iterator
from typing import NamedTuple

from sitegen import workspace
from sitegen.commands.wiring.common import is_common
from sitegen.config.blocks import INNER_FENCE
from sitegen.errors import Location, Problems, nearest
from sitegen.model import Markdown, Page, Site

_KINDS = ("msg", "srv", "action")
_TYPE = re.compile(rf"\w+/({'|'.join(_KINDS)})/\w+")
# The groups whose verbs take the name of a topic, a service or an action.
_NAMED = {"topic": "topic", "service": "service", "action": "action"}
_REMAPPED = re.compile(r"\S+:=(/\S+)")


class _Command(NamedTuple):
    words: list[str]
    location: Location

    @property
    def shown(self) -> str:
        return " ".join(["ros2", *self.words[:3]])


def check(page: Page, site: Site, names: Collection[str] | None, problems: Problems) -> None:
    """Report what commands of the texts of `page` name and the page does not have.

    `names` are those of its topics, services and actions, or None if not all are known.
    """
    commands = [
        command for part in page.leaves if isinstance(part, Markdown) for command in _commands(part)
    ]
    packages = {**workspace.shipped_packages(), **site.packages}
    types = workspace.interfaces(packages, _KINDS) if commands else frozenset()
    programs = {(node.package, node.executable) for node in page.nodes.values()}
    # What commands create: topics that they publish, and names that they give to nodes.
    made = {word for one in commands for word in one.words if one.words[:2] == ["topic", "pub"]}
    made |= {name for one in commands for word in one.words for name in _REMAPPED.findall(word)}
    renamed = any("__ns:=" in word or word == "-r" for one in commands for word in one.words)
    for command in commands:
        for word in command.words:
            if _TYPE.fullmatch(word) and word not in types:
                problems.add(command.location, "ros2", workspace.unknown_interface(word, types))
        _check_program(command, page, programs, problems)
        if names is not None and not renamed:
            _check_name(command, page, {*names, *made}, problems)


def _check_program(
    command: _Command, page: Page, programs: Collection[tuple[str, str]], problems: Problems
) -> None:
    if command.words[0] != "run" or ("", "") in programs:
        return
    words = [word for word in command.words[1:] if not word.startswith("-")]
    if len(words) < 2 or words[0] == "rclcpp_components" or (words[0], words[1]) in programs:
        return
    known = [" ".join(program) for program in programs]
    message = f"page /{page.path} has no program '{words[0]} {words[1]}'"
    advice = nearest(f"{words[0]} {words[1]}", known)
    problems.add(command.location, "ros2", f"{message}; {advice}")


def _check_name(command: _Command, page: Page, names: Collection[str], problems: Problems) -> None:
    group, verb = command.words[0], command.words[1:2]
    if group not in _NAMED or verb in ([], ["list"], ["find"], ["pub"]):
        return
    given = next((word for word in command.words[2:] if re.fullmatch(r"/[\w/]+", word)), None)
    if given is None or given in names or is_common(given):
        return
    advice = nearest(given, [name for name in names if name.startswith("/")])
    message = f"page /{page.path} has no {_NAMED[group]} '{given}'"
    problems.add(command.location, "ros2", f"{message}; {advice}")


def _commands(text: Markdown) -> Iterator[_Command]:
    """Yield the words of each `ros2` in the blocks of commands of a text, without `ros2`."""
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
            yield from (_Command(words, where) for words in _split(begun, language))
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
