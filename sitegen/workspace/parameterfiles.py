"""Read parameter files of ROS."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

from sitegen import yamlnodes

VALUES = "ros__parameters"
OPTION = "--params-file"


def read(file: Path) -> dict[str, str]:
    """Return the parameters of a file as YAML text, by `pattern:name`; of two, the last counts.

    The pattern says which nodes the parameter is for: `/arm/left`, `/**`.

    Raises: ValueError if the file cannot be read.
    """
    try:
        given = yamlnodes.load(file.read_text(encoding="utf-8-sig")) or {}
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(f"'{file.name}' cannot be read: {error}") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = f" (line {mark.line + 1})" if mark else ""
        what = getattr(error, "problem", None) or str(error)
        raise ValueError(f"'{file.name}' is not valid YAML{line}: {what}") from None
    if not isinstance(given, Mapping):
        raise ValueError(f"'{file.name}' has no parameters; start with the name of a node")
    found: dict[str, str] = {}
    for pattern, values in _sections("", given):
        if not isinstance(values, Mapping):
            raise ValueError(f"'{file.name}': '{VALUES}' of '{pattern}' has no parameters")
        merge(found, {f"{pattern}:{name}": written(value) for name, value in _flat("", values)})
    return found


def merge(parameters: dict[str, str], more: Mapping[str, str]) -> None:
    """Add the parameters `more` to `parameters`; they take precedence over all that are there."""
    for name, value in more.items():
        parameters.pop(name, None)
        parameters[name] = value


def written(value: Any) -> str:
    """Return a value as one line of YAML."""
    if isinstance(value, str):
        return value if _is_plain(value) else _quoted(value)
    if isinstance(value, list):
        items = (_quoted(each) if isinstance(each, str) else written(each) for each in value)
        return f"[{', '.join(items)}]"
    return str(yaml.safe_dump(value, default_flow_style=True)).partition("\n...")[0].strip()


def _quoted(text: str) -> str:
    if text.isprintable():
        return "'" + text.replace("'", "''") + "'"
    # In double quotes, line ends are escaped: in single quotes, they would become spaces.
    return str(yaml.safe_dump(text, default_style='"', width=math.inf, allow_unicode=True)).strip()


def _is_plain(text: str) -> bool:
    """Return whether `text` without quotes is a string with this value."""
    try:
        return bool(yamlnodes.load(text) == text)
    except yaml.YAMLError:
        return False


def _sections(path: str, part: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    for key, value in part.items():
        name = f"{path}/{str(key).strip('/')}"
        if isinstance(value, Mapping) and VALUES in value:
            yield name, value[VALUES] or {}
        elif isinstance(value, Mapping):
            yield from _sections(name, value)


def _flat(prefix: str, values: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    for key, value in values.items():
        if isinstance(value, Mapping):
            yield from _flat(f"{prefix}{key}.", value)
        else:
            yield f"{prefix}{key}", value
