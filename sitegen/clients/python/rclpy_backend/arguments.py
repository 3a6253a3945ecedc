"""The command line: the arguments after --ros-args."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple, Never

import yaml

from rclpy_backend.enums import RCUTILS_LOG_SEVERITY
from rclpy_backend.errors import RCLError, UnknownROSArgsError
from sitegen.rclyaml import EVERYWHERE, Overrides, ParameterError

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
    ("--params-file",): "params file",
    ("--log-level",): "log level",
}


class Remap(NamedTuple):
    """A remapping rule, for one node or all (""), for topics, services or both ("")."""

    node: str
    kind: str
    old: str
    new: str


@dataclass
class Arguments:
    """Parsed arguments."""

    remaps: list[Remap] = field(default_factory=list)
    parameters: Overrides = field(default_factory=Overrides)
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
        elif word in UNUSED or any(word in names for names in NAMES):
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
        try:
            found.parameters.add(given["name"], given["value"], given["node"] or EVERYWHERE)
        except (ParameterError, yaml.YAMLError) as error:
            _fail(option, text, error)
    elif option == "--params-file":
        try:
            content = Path(text).read_text(encoding="utf-8-sig")
            found.parameters.file(yaml.parse(content, Loader=yaml.SafeLoader))
        except (OSError, ValueError, yaml.YAMLError) as error:
            _fail(option, text, error)
    elif option == "--log-level":
        logger, _, level = text.rpartition(":=")
        severity = severities().get(level.upper())
        if severity is None:
            _fail(option, text)
        found.log_levels[logger] = severity


def _fail(option: str, text: str, error: Exception | None = None) -> Never:
    what = next(name for options, name in NAMES.items() if option in options)
    where = f", at line {error.line}" if isinstance(error, ParameterError) else ""
    why = f" Error: {error}{where}" if error else ""
    raise RCLError(f"failed to initialize rcl: Couldn't parse {what}: '{option} {text}'.{why}")


def severities() -> dict[str, int]:
    """Return the severities of log messages by name."""
    return {level.name.rpartition("_")[2]: int(level) for level in RCUTILS_LOG_SEVERITY}


def rclpy_remove_ros_args(pycli_args: Sequence[str]) -> list[str]:
    """Return the arguments that are not for ROS."""
    return parse(pycli_args).others
