"""Collect the message types with which a page reads and writes the messages of a program."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from sitegen.interfaces import typesupport
from sitegen.interfaces.generator import shares
from sitegen.interfaces.values import values_of
from sitegen.shipped import ROS

# The name of a type in a compiled program: the end of the string that names its type support.
NAMED = re.compile(rb"([a-z][a-z0-9_]*/(?:msg|srv|action)/[A-Z][A-Za-z0-9_]*)\0")

# type_description_interfaces/msg/FieldType by number; types that a page cannot show are missing.
TYPES = {
    **{2: "int8", 3: "uint8", 4: "int16", 5: "uint16", 6: "int32", 7: "uint32"},
    **{8: "int64", 9: "uint64", 10: "float32", 11: "float64", 13: "uint8", 15: "bool", 16: "uint8"},
    **{17: "string", 18: "wstring", 21: "string", 22: "wstring"},
}
BOUNDED = (21, 22)
# A byte: a number as others, but of its own type in Python.
OCTET = 16
# The kind of array that a type number stands for, which is the number divided by 48.
ARRAYS = ("", "[{}]", "[<={}]", "[]")
# IDL has no empty messages: rosidl adds this field, and the page's reader expects it.
FILLER = "structure_needs_at_least_one_member"

MessageType = dict[str, Any]


def types_of(program: Path, prefixes: Iterable[Path]) -> dict[str, MessageType]:
    """Return the message types that `program` names and the types nested in them, by name."""
    return types({name.decode() for name in NAMED.findall(program.read_bytes())}, prefixes)


def types(names: Iterable[str], prefixes: Iterable[Path]) -> dict[str, MessageType]:
    """Return the message types `names` and the types nested in them, by name.

    Their type descriptions are in ROS or in one of `prefixes`. See MessageType in protocol.js.
    """
    packages = {share.name: share for share in shares([ROS, *prefixes])}
    found: dict[str, MessageType] = {}
    for named in sorted(names):
        interface = typesupport.interface_of(named)
        package, kind, name = interface.split("/")
        file = packages.get(package, Path()) / kind / f"{name}.json"
        if file.is_file():
            _describe(named, file, packages, found)
    return found


def without_hashes(found: Mapping[str, MessageType]) -> dict[str, MessageType]:
    """Return the same types without their hashes, which few pages need and nothing can compress."""
    return {
        name: {key: value for key, value in one.items() if key != "hash"}
        for name, one in found.items()
    }


def hashes_of(found: Mapping[str, MessageType]) -> dict[str, str]:
    """Return the hashes of message types and services, by name."""
    return {
        name.removesuffix("_Request"): one["hash"] for name, one in found.items() if "hash" in one
    }


def _describe(
    name: str, file: Path, packages: Mapping[str, Path], found: dict[str, MessageType]
) -> None:
    read = json.loads(file.read_text())
    data = read["type_description_msg"]
    hashes = {entry["type_name"]: entry["hash_string"] for entry in read["type_hashes"]}
    parts = [data["type_description"], *data["referenced_type_descriptions"]]
    described = {part["type_name"]: part["fields"] for part in parts}
    missing = [name]
    while missing:
        one = missing.pop()
        if one in found or one not in described:
            continue
        fields = [field for field in described[one] if field["name"] != FILLER]
        values = values_of(one, packages)
        found[one] = {
            "fields": [_field(field, values.defaults) for field in fields],
            "constants": values.constants,
        }
        # A request has the hash of its service, by which others know it.
        if digest := hashes.get(one.removesuffix("_Request")):
            found[one]["hash"] = digest
        missing += [field["type"]["nested_type_name"] for field in fields]


def _field(field: Mapping[str, Any], defaults: Mapping[str, Any]) -> dict[str, Any]:
    entry: dict[str, Any] = {"name": field["name"], "type": _type(field["type"])}
    if field["type"]["type_id"] % typesupport.SCALARS == OCTET:
        entry["octet"] = True
    default = defaults.get(field["name"])
    if default is not None:
        entry["default"] = default
    return entry


def _type(kind: Mapping[str, Any]) -> str:
    """Return the type of a field as written in a .msg file."""
    array, number = divmod(kind["type_id"], typesupport.SCALARS)
    name = kind["nested_type_name"] if number == typesupport.NESTED else TYPES.get(number, "?")
    if number in BOUNDED:
        name += f"<={kind['string_capacity']}"
    return str(name + ARRAYS[array].format(kind["capacity"]))
