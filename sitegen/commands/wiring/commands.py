"""Find commands of `ros2` in texts that name what their page does not have."""

from __future__ import annotations

import re
import shlex
from collections.abc import Collection, Iterator
from typing import NamedTuple

from sitegen.errors import Location, Problems, nearest
from sitegen.model import Markdown, Page, Site
from sitegen.shipped import INTERFACES, PACKAGES, ROS

_FENCE = re.compile(
    r"[ \t>]*(?:(?:[-*+]|\d+[.)])[ \t]+)?(?P<fence>`{3,}|~{3,})[ \t]*(?P<info>.*?)[ \t]*$"
)
_TYPE = re.compile(r"(\w+)/(msg|srv|action)/(\w+)")
# The groups whose verbs take the name of a topic, a service or an action.
_NAMED = {"topic": "topic", "service": "service", "action": "action"}
# Every node has these, and tools of ROS use them.
_COMMON = {"/clock", "/parameter_events", "/rosout", "/diagnostics", "/tf", "/tf_static"}
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
    programs = {(node.package, node.executable) for node in page.nodes.values()}
    # What commands create: topics that they publish, and names that they give to nodes.
    made = {word for one in commands for word in one.words if one.words[:2] == ["topic", "pub"]}
    made |= {name for one in commands for word in one.words for name in _REMAPPED.findall(word)}
    renamed = any("__ns:=" in word or word == "-r" for one in commands for word in one.words)
    for command in commands:
        for word in command.words:
            match = _TYPE.fullmatch(word)
            if match and not _is_type(site, *match.groups()):
                message = f"'{command.shown}' names the unknown type '{word}'; check its spelling"
                problems.add(command.location, "ros2", message)
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
    hidden = given is not None and any(part.startswith("_") for part in given.split("/"))
    if given is None or hidden or given in names or given in _COMMON:
        return
    if group == "service" and given.rpartition("/")[2] in _PARAMETERS:
        return
    advice = nearest(given, [name for name in names if name.startswith("/")])
    message = f"page /{page.path} has no {_NAMED[group]} '{given}'"
    problems.add(command.location, "ros2", f"{message}; {advice}")


# The services of the parameters of each node.
_PARAMETERS = {
    *("describe_parameters", "get_parameter_types", "get_parameters", "get_type_description"),
    *("list_parameters", "set_parameters", "set_parameters_atomically"),
}


def _is_type(site: Site, package: str, kind: str, name: str) -> bool:
    own = site.packages.get(package)
    if own is not None:
        return any(re.split(r"[/.]", file)[-2] == name for file in own.interfaces)
    folders = (ROS / "share", INTERFACES, PACKAGES)
    return any([*(folder / package / kind).glob(f"{name}.*")] for folder in folders)


def _commands(text: Markdown) -> Iterator[_Command]:
    """Yield the words of each `ros2` in the blocks of commands of a text, without `ros2`."""
    fence, language, begun = "", "", ""
    for number, line in enumerate(text.text.split("\n"), start=text.location.line):
        edge = _FENCE.match(line)
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
