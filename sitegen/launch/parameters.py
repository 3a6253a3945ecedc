"""Take from a file of parameters what is for one node."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

VALUES = "ros__parameters"


def for_node(file: Path, node: str) -> dict[str, str]:
    """Return the parameters that a file has for the node of this whole name, as YAML text.

    Raises a ValueError if it cannot be read.
    """
    try:
        given = yaml.safe_load(file.read_text(encoding="utf-8")) or {}
    except yaml.YAMLError as error:
        raise ValueError(f"'{file.name}' is no YAML: {error}".replace("\n", " ")) from None
    if not isinstance(given, Mapping):
        raise ValueError(f"'{file.name}' has no parameters; begin with the name of a node")
    found: dict[str, str] = {}
    for pattern, values in _sections("", given):
        if _means(pattern, node):
            found |= {name: written(value) for name, value in _flat("", values)}
    return found


def written(value: Any) -> str:
    """Return a value as one line of YAML."""
    if isinstance(value, str):
        return (
            value if yaml.safe_load(value) == value else f"'{value.replace(chr(39), chr(39) * 2)}'"
        )
    return (
        yaml.safe_dump(value, default_flow_style=True, width=1_000_000)
        .partition("\n...")[0]
        .strip()
    )


def _sections(path: str, part: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    for key, value in part.items():
        name = f"{path}/{str(key).strip('/')}"
        if isinstance(value, Mapping) and VALUES in value:
            yield name, value[VALUES] or {}
        elif isinstance(value, Mapping):
            yield from _sections(name, value)


def _means(pattern: str, node: str) -> bool:
    if pattern.count("/") == 1 and "*" not in pattern and node.rpartition("/")[2] == pattern[1:]:
        return node == pattern
    parts = re.escape(pattern).replace(r"/\*\*", "(/.*)?").replace(r"\*", "[^/]+")
    return bool(re.fullmatch(parts, node))


def _flat(prefix: str, values: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    for key, value in values.items():
        if isinstance(value, Mapping):
            yield from _flat(f"{prefix}{key}.", value)
        else:
            yield f"{prefix}{key}", value
