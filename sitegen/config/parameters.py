"""Read the parameters of a node in site.yaml."""

from __future__ import annotations

import re

import yaml

from sitegen.config.document import Value
from sitegen.config.files import locate
from sitegen.errors import Problems
from sitegen.rclyaml import NAMES, Overrides, Scalar, scalar
from sitegen.workspace import parameterfiles

STRING = "tag:yaml.org,2002:str"
# The parameters of `qos_overrides` have names of topics in their names.
NAME = re.compile(r"[A-Za-z_/][\w/]*(\.[A-Za-z_/][\w/]*)*", re.ASCII)


def read(value: Value, problems: Problems) -> dict[str, str]:
    """Return the parameters by name in the form of `-p name:=value`; nested names are dotted.

    A list contains mappings and parameter files, which count as the same arguments of `ros2 run`
    do. Reports names and values that no parameter can have, and files that cannot be read.
    """
    overrides = Overrides()
    for item in value.items() if value.kind == "list" else [value]:
        if item.kind == "mapping":
            _mapping(item, "", overrides, problems)
        elif item.kind == "text":
            _file(item, overrides, problems)
        else:
            message = f"expected a file or a mapping of names to values, found {item.found}"
            problems.add(item.location, item.key, message)
    return parameterfiles.rules(overrides)


def arguments(value: Value, problems: Problems) -> tuple[str, ...]:
    """Return the command line of a node with each `--params-file` replaced by its parameters."""
    words: list[str] = []
    items = value.items()
    for item, before in zip(items, [None, *items], strict=False):
        if before is not None and before.text == parameterfiles.OPTION:
            words.pop()
            overrides = Overrides()
            _file(item, overrides, problems)
            for name, text in parameterfiles.rules(overrides).items():
                words += ["-p", f"{name}:={text}"]
        else:
            words.append(item.text)
    return tuple(words)


def _file(value: Value, overrides: Overrides, problems: Problems) -> None:
    file = locate(value, problems)
    try:
        if file:
            parameterfiles.add(overrides, file)
    except ValueError as error:
        problems.add(value.location, value.key, str(error))


def _mapping(value: Value, above: str, overrides: Overrides, problems: Problems) -> None:
    for name, entry in value.entries(problems).items():
        if not NAME.fullmatch(name):
            message = f"'{name}' is not a valid parameter name; use letters, digits, '_' and '.'"
            problems.add(entry.location, entry.key, message)
        elif entry.kind == "mapping":
            _mapping(entry, f"{above}{name}.", overrides, problems)
        elif entry.kind == "list":
            overrides.set(f"{above}{name}", _list(entry, problems))
        else:
            overrides.set(f"{above}{name}", _scalar(entry, problems))


def _list(value: Value, problems: Problems) -> list[Scalar] | None:
    items = [_scalar(item, problems) for item in value.items()]
    known = [item for item in items if item is not None]
    kinds = sorted({NAMES[type(item)] for item in known})
    if not items:
        problems.add(value.location, value.key, "an empty list has no type; remove it")
    elif len(kinds) > 1:
        message = f"all values of a list must have the same type, found {' and '.join(kinds)}"
        problems.add(value.location, value.key, message)
    return known or None


def _scalar(value: Value, problems: Problems) -> Scalar | None:
    """Return a value as ROS reads it from a parameter file; None if it is not valid there."""
    node = value.node
    if not isinstance(node, yaml.ScalarNode) or (not node.style and not node.value):
        message = f"expected a boolean, a number, a string or a list of these, found {value.found}"
        problems.add(value.location, value.key, message)
        return None
    # The mark of a value is before its tag.
    length = node.end_mark.column - node.start_mark.column
    tagged = node.tag == STRING and not node.style and length >= len("!!str ") + len(node.value)
    return node.value if node.style in ("'", '"') or tagged else scalar(node.value)
