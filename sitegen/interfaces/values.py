"""Read the constants and default values of interfaces, as rosidl's generators read them."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sitegen.interfaces import rosidl, typesupport

# The end of the names of the messages that a service or an action has, and their order in its file.
PARTS = {"": 0, "Request": 0, "Goal": 0, "Response": 1, "Result": 1, "Feedback": 2}
# The types of IDL that have another name in .msg files.
IDL_TYPES = {"boolean": "bool", "octet": "byte", "float": "float32", "double": "float64"}
# Numbers in JSON have 53 bits in JavaScript.
EXACT_AS_TEXT = ("int64", "uint64")
# Holds the values of an .idl file, which takes long to parse.
SUFFIX = ".values"


@dataclass(frozen=True)
class Values:
    """The constants of a message, in their order, and the defaults of its fields, by name.

    Integers of 64 bits are decimal texts.
    """

    constants: Sequence[Mapping[str, Any]] = ()
    defaults: Mapping[str, Any] = field(default_factory=dict)


def values_of(message: str, packages: Mapping[str, Path]) -> Values:
    """Return the values of `message`, whose definition is in the folder of its package."""
    package, kind, interface = typesupport.interface_of(message).split("/")
    part = message.split("/")[2].partition("_")[2]
    stem = packages.get(package, Path()) / kind / interface
    idl, file = stem.with_suffix(SUFFIX), stem.with_suffix(f".{kind}")
    if idl.is_file():
        found = json.loads(idl.read_text(encoding="utf-8-sig")).get(message.split("/")[2])
        return Values(**found) if found else Values()
    if not file.is_file() or part not in PARTS:
        return Values()
    texts = re.split(r"^---\s*$", file.read_text(encoding="utf-8-sig"), flags=re.M)
    if PARTS[part] >= len(texts):
        return Values()
    parser = rosidl.module(rosidl.PARSER)
    parsed = parser.parse_message_string(package, interface, texts[PARTS[part]])
    defaults = {one.name: one for one in parsed.fields if one.default_value is not None}
    return Values(
        [_constant(one.name, one.type, _read(one.type, one.value)) for one in parsed.constants],
        {
            name: _exact(one.type.type, _read(one.type, one.default_value))
            for name, one in defaults.items()
        },
    )


def write_idl_values(idl: Path, share: Path) -> None:
    """Write the values of an .idl file to the folder `share`, where `values_of` finds them."""
    parser = rosidl.module("rosidl_parser.parser")
    rosidl_types = rosidl.module("rosidl_parser.definition")
    content = parser.parse_idl_string(idl.read_text(encoding="utf-8-sig"))
    messages = content.get_elements_of_type(rosidl_types.Message)
    for one in content.get_elements_of_type(rosidl_types.Service):
        messages += [one.request_message, one.response_message]
    for one in content.get_elements_of_type(rosidl_types.Action):
        messages += [one.goal, one.result, one.feedback]
    found = {one.structure.namespaced_type.name: _idl_values(one) for one in messages}
    share.mkdir(parents=True, exist_ok=True)
    (share / idl.name).with_suffix(SUFFIX).write_text(json.dumps(found), encoding="utf-8")


def _idl_values(message: Any) -> dict[str, Any]:
    defaults = {}
    for member in message.structure.members:
        if member.has_annotation("default"):
            value = member.get_annotation_value("default")["value"]
            nested = hasattr(member.type, "value_type")
            kind = _idl_type(member.type.value_type if nested else member.type)
            defaults[member.name] = _exact(kind, ast.literal_eval(value) if nested else value)
    constants = [_constant(one.name, _idl_type(one.type), one.value) for one in message.constants]
    return {"constants": constants, "defaults": defaults}


def _idl_type(kind: Any) -> str:
    """Return the name that a type without array has in .msg files."""
    if not hasattr(kind, "typename"):
        return "wstring" if "WString" in type(kind).__name__ else "string"
    return IDL_TYPES.get(kind.typename, str(kind.typename))


def _read(kind: Any, value: Any) -> Any:
    """Return the value that the classes have for `value` of a .msg file.

    rosidl writes it as IDL and reads it again; both steps decode escapes.
    """
    if not isinstance(value, str | list):
        return value
    adapter = rosidl.module("rosidl_adapter.msg")
    literal = adapter.to_idl_literal(adapter.get_idl_type(kind), value)
    # The IDL is written in Latin-1, and read in UTF-8.
    literal = literal.encode("latin-1").decode("utf-8")
    lark = rosidl.module("lark")
    token = lark.Token("ESCAPED_STRING", literal)
    parser = rosidl.module("rosidl_parser.parser")
    text = parser.get_string_literal_value(lark.Tree("string_literal", [token]))
    return ast.literal_eval(text) if isinstance(value, list) else text


def _constant(name: str, kind: str, value: Any) -> dict[str, Any]:
    return {"name": name, "type": kind, "value": _exact(kind, value)}


def _exact(kind: str, value: Any) -> Any:
    if isinstance(value, list | tuple):
        return [_exact(kind, one) for one in value]
    return str(value) if kind in EXACT_AS_TEXT else value
