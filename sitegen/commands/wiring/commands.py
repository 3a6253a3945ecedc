"""Find commands of `ros2` in texts that name what their page does not have."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import NamedTuple

from sitegen import workspace
from sitegen.commands.wiring.common import is_common
from sitegen.config.commandlines import Command, commands
from sitegen.errors import Problems, nearest
from sitegen.model import Markdown, Page, Site

_KINDS = ("msg", "srv", "action")
_TYPE = re.compile(rf"\w+/({'|'.join(_KINDS)})/\w+")
# The groups whose verbs take the name of a topic, a service or an action.
_NAMED = {"topic": "topic", "service": "service", "action": "action"}
# The verbs that take the name of a node.
_OF_NODES = {
    "node": {"info"},
    "param": {"delete", "describe", "dump", "get", "load", "set"},
    "lifecycle": {"get", "list", "set"},
    "component": {"unload"},
}
_REMAPPED = re.compile(r"\S+:=(/\S+)")


class Names(NamedTuple):
    """The names of a page's topics, services and actions, and of its nodes; None if not known."""

    endpoints: Collection[str] | None
    nodes: Collection[str] | None


def check(page: Page, site: Site, names: Names, problems: Problems) -> None:
    """Report what commands of the texts of `page` name and the page does not have."""
    given = [
        command for part in page.leaves if isinstance(part, Markdown) for command in commands(part)
    ]
    packages = {**workspace.shipped_packages(), **site.packages}
    types = workspace.interfaces(packages, _KINDS) if given else frozenset()
    programs = {(node.package, node.executable) for node in page.nodes.values()}
    # What commands create: topics that they publish, and names that they give to nodes.
    made = {word for one in given for word in one.words if one.words[:2] == ["topic", "pub"]}
    made |= {name for one in given for word in one.words for name in _REMAPPED.findall(word)}
    loaded = any(one.words[0] == "component" for one in given)
    renamed = any("__ns:=" in word or word == "-r" for one in given for word in one.words)
    for command in given:
        for word in command.words:
            if _TYPE.fullmatch(word) and word not in types:
                problems.add(command.location, "ros2", workspace.unknown_interface(word, types))
        _check_program(command, page, programs, problems)
        if names.endpoints is not None and not renamed:
            _check_name(command, page, {*names.endpoints, *made}, problems)
        if names.nodes is not None and not renamed and not loaded:
            _check_node(command, page, names.nodes, problems)


def _check_program(
    command: Command, page: Page, programs: Collection[tuple[str, str]], problems: Problems
) -> None:
    program = command.program
    if program is None or program in programs or ("", "") in programs:
        return
    if program[0] == "rclcpp_components":
        return
    message = f"page /{page.path} has no program '{' '.join(program)}'"
    advice = nearest(" ".join(program), [" ".join(known) for known in programs])
    problems.add(command.location, "ros2", f"{message}; {advice}")


def _check_name(command: Command, page: Page, names: Collection[str], problems: Problems) -> None:
    group, verb = command.words[0], command.words[1:2]
    if group not in _NAMED or verb in ([], ["list"], ["find"], ["pub"]):
        return
    given = next((word for word in command.words[2:] if re.fullmatch(r"/[\w/]+", word)), None)
    if given is None or given in names or is_common(given):
        return
    advice = nearest(given, [name for name in names if name.startswith("/")])
    message = f"page /{page.path} has no {_NAMED[group]} '{given}'"
    problems.add(command.location, "ros2", f"{message}; {advice}")


def _check_node(command: Command, page: Page, names: Collection[str], problems: Problems) -> None:
    group, verb = command.words[0], command.words[1] if len(command.words) > 1 else ""
    if verb not in _OF_NODES.get(group, ()):
        return
    # Before the name, there may be options with values.
    given = [word for word in command.words[2:] if re.fullmatch(r"/?\w[\w/]*", word)]
    full = [word if word.startswith("/") else f"/{word}" for word in given]
    if not given or any(name in names for name in full):
        return
    likely = next((word for word in given if word.startswith("/")), full[0])
    message = f"page /{page.path} has no node '{likely}'"
    problems.add(command.location, "ros2", f"{message}; {nearest(likely, sorted(names))}")
