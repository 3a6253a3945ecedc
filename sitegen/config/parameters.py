"""Read the parameters of a node in site.yaml."""

from __future__ import annotations

import re

import yaml

from sitegen.config.document import Value
from sitegen.config.files import locate
from sitegen.errors import Problems
from sitegen.workspace import parameterfiles

NUMBER = re.compile(r"[-+]?(\d+|\d+\.\d*|\.\d+|\d+(\.\d*)?[eE][-+]?\d+|\.inf|\.nan)", re.IGNORECASE)
# The parameters of `qos_overrides` have names of topics in their names.
NAME = re.compile(r"[A-Za-z_/][\w/]*(\.[A-Za-z_/][\w/]*)*", re.ASCII)


def read(value: Value, problems: Problems) -> dict[str, str]:
    """Return the parameters by name in the form of `-p name:=value`; nested names are dotted.

    A list contains mappings and parameter files; later ones take precedence. Reports names and
    values that no parameter can have, and files that cannot be read.
    """
    if value.kind != "list":
        return _mapping(value, problems)
    found: dict[str, str] = {}
    for item in value.items():
        if item.kind == "mapping":
            parameterfiles.merge(found, _mapping(item, problems))
        elif item.kind == "text":
            parameterfiles.merge(found, _file(item, problems))
        else:
            message = f"expected a file or a mapping of names to values, found {item.found}"
            problems.add(item.location, item.key, message)
    return found


def _file(value: Value, problems: Problems) -> dict[str, str]:
    file = locate(value, problems)
    try:
        return parameterfiles.read(file) if file else {}
    except ValueError as error:
        problems.add(value.location, value.key, str(error))
        return {}


def arguments(value: Value, problems: Problems) -> tuple[str, ...]:
    """Return the command line of a node with each `--params-file` replaced by its parameters."""
    words: list[str] = []
    items = value.items()
    for item, before in zip(items, [None, *items], strict=False):
        if before is not None and before.text == parameterfiles.OPTION:
            words.pop()
            for name, text in _file(item, problems).items():
                words += ["-p", f"{name}:={text}"]
        else:
            words.append(item.text)
    return tuple(words)


def _mapping(value: Value, problems: Problems) -> dict[str, str]:
    found: dict[str, str] = {}
    for name, entry in value.entries(problems).items():
        if not NAME.fullmatch(name):
            message = f"'{name}' is not a valid parameter name; use letters, digits, '_' and '.'"
            problems.add(entry.location, entry.key, message)
        elif entry.kind == "mapping":
            nested = _mapping(entry, problems)
            found |= {f"{name}.{inner}": text for inner, text in nested.items()}
        elif entry.kind == "list":
            found[name] = _list(entry, problems)
        else:
            found[name] = _scalar(entry, problems)[1]
    return found


def _list(value: Value, problems: Problems) -> str:
    items = [_scalar(item, problems) for item in value.items()]
    kinds = {kind for kind, _ in items}
    if not items:
        problems.add(value.location, value.key, "an empty list has no type; remove it")
    elif len(kinds) > 1 and "" not in kinds:
        message = (
            f"all values of a list must have the same type, found {' and '.join(sorted(kinds))}"
        )
        problems.add(value.location, value.key, message)
    return f"[{', '.join(text for _, text in items)}]"


def _scalar(value: Value, problems: Problems) -> tuple[str, str]:
    """Return the type and the text of a value; no type if it is not valid for parameters."""
    plain = isinstance(value.node, yaml.ScalarNode) and not value.node.style
    if value.kind == "flag":
        return "flags", value.text
    if plain and NUMBER.fullmatch(value.text):
        whole = re.fullmatch(r"[-+]?\d+", value.text)
        return "whole numbers" if whole else "floating-point numbers", value.text
    if value.kind != "text":
        message = f"expected a boolean, a number, a string or a list of these, found {value.found}"
        problems.add(value.location, value.key, message)
        return "", ""
    return "text", "'" + value.text.replace("'", "''") + "'"
