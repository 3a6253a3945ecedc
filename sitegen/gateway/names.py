"""Decide which names of the graph a client may reach."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache
from typing import Literal

# What a client does with a name. The names are those of the lists in gateway.yaml.
Use = Literal[
    "subscribe",
    "publish",
    "call_services",
    "advertise_services",
    "send_goals",
    "advertise_actions",
    "get_parameters",
    "set_parameters",
]
USES: tuple[Use, ...] = Use.__args__  # type: ignore[attr-defined]

# By the kind of an endpoint: what a client does that has one, and that could use one of others.
HAVING: dict[str, Use] = {
    "publisher": "publish",
    "subscription": "subscribe",
    "client": "call_services",
    "service": "advertise_services",
}
USING: dict[str, Use] = {
    "publisher": "subscribe",
    "subscription": "publish",
    "service": "call_services",
    "client": "advertise_services",
}

DOES: dict[Use, str] = {
    "subscribe": "subscribing to",
    "publish": "publishing",
    "call_services": "calling",
    "advertise_services": "offering",
    "send_goals": "sending goals to",
    "advertise_actions": "offering",
    "get_parameters": "reading",
    "set_parameters": "setting",
}

LONGEST = 256
# A name of the graph, and after ":" the name of a parameter.
NAME = re.compile(r"(/~?[A-Za-z_]\w*)+(:([\w./@-]+|\*))?", re.ASCII)
PROTECTED = re.compile(r"(^|[/:.~])protected")
ACTION = re.compile(r"(?P<action>.+)/_action/(?P<part>\w+)")
READING = ("get_parameters", "get_parameter_types", "list_parameters", "describe_parameters")
SETTING = ("set_parameters", "set_parameters_atomically")
PARAMETERS = re.compile(rf"(?P<node>.+)/(?P<verb>{'|'.join((*READING, *SETTING))})")


def refusal(use: Use, name: str, allowed: Iterable[str] | None) -> str:
    """Return why a client may not use `name`, "" if it may; with None, all names are allowed.

    Names that begin with "protected", or have a namespace that does, are never reachable.
    """
    if len(name) > LONGEST or not NAME.fullmatch(name):
        return f"'{name[:80]}' is not a valid name"
    if PROTECTED.search(name):
        return f"{name} is protected"
    if allowed is None or any(pattern(text).fullmatch(name) for text in allowed):
        return ""
    return f"{DOES[use]} {name} is not allowed"


def subject(use: Use, name: str) -> tuple[Use, str]:
    """Return what a use of `name` amounts to.

    The topics and services of an action are the action, and the parameter services of a node are
    its parameters, of which `*` stands for all.
    """
    if action := ACTION.fullmatch(name):
        serving = {
            "subscribe": action["part"] not in ("feedback", "status"),
            "publish": action["part"] in ("feedback", "status"),
            "advertise_services": True,
        }.get(use, False)
        return ("advertise_actions" if serving else "send_goals"), action["action"]
    if use == "call_services" and (found := PARAMETERS.fullmatch(name)):
        setting = found["verb"] in SETTING
        return ("set_parameters" if setting else "get_parameters"), f"{found['node']}:*"
    return use, name


@lru_cache(1000)
def pattern(text: str) -> re.Pattern[str]:
    """Return a regular expression: `*` stands for part of a name between two `/`, `**` for any."""
    parts = re.split(r"(\*\*|\*|\?)", text)
    signs = {"**": ".*", "*": "[^/:]*", "?": "[^/:]"}
    return re.compile("".join(signs.get(part, re.escape(part)) for part in parts), re.DOTALL)
