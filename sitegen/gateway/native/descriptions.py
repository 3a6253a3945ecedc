"""Describe installed interfaces to pages, which read and write messages by their fields."""

from __future__ import annotations

import functools
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from ament_index_python import get_package_share_directory

# type_description_interfaces/msg/FieldType by number, as in sitegen/interfaces/messages.py, which
# needs rosidl.
_SCALARS = {
    **{2: "int8", 3: "uint8", 4: "int16", 5: "uint16", 6: "int32", 7: "uint32"},
    **{8: "int64", 9: "uint64", 10: "float32", 11: "float64", 13: "uint8", 15: "bool", 16: "uint8"},
    **{17: "string", 18: "wstring", 21: "string", 22: "wstring"},
}
_NESTED = 1
_BOUNDED = (21, 22)
# A scalar is its number; arrays of it add 48, bounded sequences 96, and unbounded sequences 144.
_ARRAYS = ("", "[{}]", "[<={}]", "[]")
_FILLER = "structure_needs_at_least_one_member"


def describe(names: Iterable[str]) -> dict[str, Any]:
    """Return the messages of interfaces and those nested in them: MessageType in protocol.js.

    Of a service or an action, these are its parts. What is not installed is left out.
    """
    found: dict[str, Any] = {}
    for name in names:
        found |= _describe(name)
    return found


@functools.cache
def hash_of(type_name: str) -> str:
    """Return the hash of an interface that is installed here, or "" if it is unknown."""
    hashes = _read(type_name).get("type_hashes", [])
    return next((str(e["hash_string"]) for e in hashes if e["type_name"] == type_name), "")


@functools.lru_cache(1000)
def _describe(name: str) -> Mapping[str, Any]:
    read = _read(name).get("type_description_msg")
    if not read:
        return {}
    parts = [read["type_description"], *read["referenced_type_descriptions"]]
    messages = {part["type_name"]: part["fields"] for part in parts}
    return {
        one: {"fields": [_field(f) for f in fields if f["name"] != _FILLER], "constants": []}
        for one, fields in messages.items()
        # Services and actions are described as types of their parts, and what introspection sends.
        if f"{one}_Request" not in messages
        and f"{one}_Goal" not in messages
        and not one.endswith("_Event")
    }


def _read(name: str) -> dict[str, Any]:
    """Return the description of an interface, which has those of the parts of an action, too."""
    package, kind, short = [*name.split("/"), "", ""][:3]
    try:
        share = Path(get_package_share_directory(package))
        read = json.loads((share / kind / f"{short.split('_')[0]}.json").read_text("utf-8"))
    except (LookupError, OSError, ValueError):
        return {}
    return read if isinstance(read, dict) else {}


def _field(field: Mapping[str, Any]) -> dict[str, str]:
    kind = field["type"]
    array, number = divmod(kind["type_id"], 48)
    name = kind["nested_type_name"] if number == _NESTED else _SCALARS.get(number, "?")
    if number in _BOUNDED:
        name += f"<={kind['string_capacity']}"
    return {"name": field["name"], "type": name + _ARRAYS[array].format(kind["capacity"])}
