"""The command line: the arguments after --ros-args."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Never

from rclpy_backend.enums import RCUTILS_LOG_SEVERITY
from rclpy_backend.errors import RCLError, UnknownROSArgsError

REMAP = re.compile(
    r"(?:(?P<node>\w+):(?![=/]))?(?:(?P<kind>rostopic|rosservice)://)?(?P<old>[^:=]+):=(?P<new>.+)"
)
PARAMETER = re.compile(r"(?:(?P<node>/?[\w/*]+):(?!=))?(?P<name>[^:=]+):=(?P<value>.*)", re.S)
FLAGS = {
    *("--enable-rosout-logs", "--disable-rosout-logs"),
    *("--enable-stdout-logs", "--disable-stdout-logs"),
    *("--enable-external-lib-logs", "--disable-external-lib-logs"),
}
# Options with one argument, which have no effect in the browser.
UNUSED = {"-e", "--enclave", "--log-config-file", "--log-file-name"}
NAMES = {
    ("-r", "--remap"): "remap rule",
    ("-p", "--param"): "parameter override rule",
    ("--log-level",): "log level",
}


class Remap(NamedTuple):
    """A remapping rule, for one node or all (""), for topics, services or both ("")."""

    node: str
    kind: str
    old: str
    new: str


class Override(NamedTuple):
    """A parameter override, as YAML; `node` is a name or a pattern, or empty for all nodes."""

    node: str
    name: str
    value: str


@dataclass
class Arguments:
    """Parsed arguments; `parameters` has overrides and the names of parameter files."""

    remaps: list[Remap] = field(default_factory=list)
    parameters: list[Override | str] = field(default_factory=list)
    log_levels: dict[str, int] = field(default_factory=dict)
    others: list[str] = field(default_factory=list)


def parse(words: Sequence[str]) -> Arguments:
    """Parse a command line.

    Raises:
        RCLError: if a value is invalid or missing.
        UnknownROSArgsError: if there are unknown arguments after --ros-args.
    """
    found = Arguments()
    unknown = []
    ros = False
    waiting = list(words)
    while waiting:
        word = waiting.pop(0)
        if word == "--ros-args":
            ros = True
        elif not ros:
            found.others.append(word)
        elif word == "--":
            ros = False
        elif word in FLAGS:
            continue
        elif word in UNUSED or word == "--params-file" or any(word in names for names in NAMES):
            if not waiting:
                raise RCLError(f"failed to initialize rcl: Couldn't parse trailing {word} flag.")
            _take(found, word, waiting.pop(0))
        else:
            unknown.append(word)
    if unknown:
        raise UnknownROSArgsError(str(unknown))
    return found


def _take(found: Arguments, option: str, text: str) -> None:
    if option in ("-r", "--remap"):
        rule = REMAP.fullmatch(text) or _fail(option, text)
        kind = (rule["kind"] or "").removeprefix("ros")
        found.remaps.append(Remap(rule["node"] or "", kind, rule["old"], rule["new"]))
    elif option in ("-p", "--param"):
        given = PARAMETER.fullmatch(text) or _fail(option, text)
        found.parameters.append(Override(given["node"] or "", given["name"], given["value"]))
    elif option == "--params-file":
        found.parameters.append(text)
    elif option == "--log-level":
        logger, _, level = text.rpartition(":=")
        severity = severities().get(level.upper())
        if severity is None:
            _fail(option, text)
        found.log_levels[logger] = severity


def _fail(option: str, text: str) -> Never:
    what = next(name for options, name in NAMES.items() if option in options)
    raise RCLError(f"failed to initialize rcl: Couldn't parse {what}: '{option} {text}'.")


def severities() -> dict[str, int]:
    """Return the severities of log messages by name."""
    return {level.name.rpartition("_")[2]: int(level) for level in RCUTILS_LOG_SEVERITY}


def rclpy_remove_ros_args(pycli_args: Sequence[str]) -> list[str]:
    """Return the arguments that are not for ROS."""
    return parse(pycli_args).others
