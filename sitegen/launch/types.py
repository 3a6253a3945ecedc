"""The types of values in launch files, as launch reads them from text."""

from __future__ import annotations

from typing import Any

import yaml

from sitegen import yamlnodes

SCALARS: dict[str, type] = {"str": str, "bool": bool, "int": int, "float": float}
LISTS = {f"list_of_{name}": kind for name, kind in SCALARS.items()}
# The type `yaml` stands for the type that the value looks like.
ANY = "yaml"


def typed(text: str, named: str, *, partly: bool = False) -> Any:
    """Return a text as a value of the type `named`, read by YAML 1.1 as in launch.

    If `partly`, it may have substitutions: what is not of the type is a string.

    Raises: ValueError if it is not of the type.
    """
    if named == "str" or (named == ANY and not text):
        return text
    try:
        if named in ("int", "float"):
            return SCALARS[named](text)
        is_digit = named == "bool" and text in ("0", "1")
        value = text == "1" if is_digit else yamlnodes.load(text)
    except (yaml.YAMLError, ValueError):
        value = text if partly else None
    if not is_of(value, named, partly=partly):
        advice = "; give it the type 'str' if it is a string" if named == ANY else ""
        raise ValueError(f"'{text}' is not of type '{named}'{advice}")
    return value


def is_of(value: Any, named: str, *, partly: bool = False) -> bool:
    """Return whether a value is of the type `named`; if `partly`, strings are, too."""
    if named in SCALARS or (named == ANY and not isinstance(value, list)):
        kinds = [SCALARS[named]] if named in SCALARS else list(SCALARS.values())
        return isinstance(value, (*kinds, *([str] if partly else [])))
    if not isinstance(value, list):
        return False
    first = next((type(item) for item in value if not isinstance(item, str)), str)
    kind = LISTS.get(named, first)
    others = [str] if partly else []
    return kind in SCALARS.values() and all(isinstance(item, (kind, *others)) for item in value)
