"""Turn type descriptions of ROS interfaces into type supports, which list the fields of messages.

rosidl writes a type description (`*.json`) for each interface. Reading and writing messages needs
nothing else.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

# type_description_interfaces/msg/FieldType: a scalar is its number; arrays of it add 48, bounded
# sequences 96, and unbounded sequences 144.
NESTED = 1
BOUNDED_TEXT = (21, 22)
SCALARS = 48
# Every program includes the services of these packages, and none looks them up by name.
UNNAMED = ("composition_interfaces", "lifecycle_msgs", "rcl_interfaces")


@dataclass(frozen=True)
class Field:
    """A field of a message: its C++ name, the type it nests, its bound if it is a string.

    `type_id`, `capacity` and `text_capacity` are those of its description, `default` is its default
    value as a Python literal, or as plain text if it is a string.
    """

    name: str
    nested: str
    bound: int
    type_id: int
    capacity: int
    text_capacity: int
    default: str


@dataclass(frozen=True)
class Message:
    """One message class: `std_msgs/msg/Header`, or a part of a service or an action."""

    name: str
    hash: str
    fields: tuple[Field, ...]
    definition: str = ""

    @property
    def package(self) -> str:
        """The package that defines it."""
        return self.name.split("/")[0]

    @property
    def cpp(self) -> str:
        """Its C++ class."""
        return self.name.replace("/", "::")


def read_description(file: Path) -> Iterator[Message]:
    """Yield the messages of the interface in a type description, nested messages first.

    A message has one; the `.json` of a service also describes its request, response and event.
    """
    data = json.loads(file.read_text())
    description = data["type_description_msg"]
    own = description["type_description"]["type_name"]
    hashes = {entry["type_name"]: entry["hash_string"] for entry in data["type_hashes"]}
    parts = [*description["referenced_type_descriptions"], description["type_description"]]
    messages = [_message(part, hashes) for part in parts]
    if own.split("/")[1] == "msg":
        messages[-1] = replace(messages[-1], definition=_definition(parts))
    mine = {m.name: m for m in messages if m.name == own or m.name.startswith(f"{own}_")}
    for name in list(mine):
        # Services and actions are described, too, as types whose fields are their parts.
        if f"{name}_Request" in mine or f"{name}_Goal" in mine:
            del mine[name]
    yield from _nested_first(mine)


def read_hashes(file: Path) -> dict[str, str]:
    """Return the hashes (RIHS01_…) in a type description, by the name of the type."""
    return {
        entry["type_name"]: entry["hash_string"]
        for entry in json.loads(file.read_text())["type_hashes"]
    }


def _message(part: dict[str, Any], hashes: dict[str, str]) -> Message:
    fields = tuple(_field(field) for field in part["fields"])
    return Message(part["type_name"], hashes[part["type_name"]], fields)


def _definition(parts: Sequence[dict[str, Any]]) -> str:
    """Return the fields of the last of `parts`, and of the types nested in it, for the page."""
    lines = [_line(field) for field in parts[-1]["fields"]]
    for part in parts[:-1]:
        lines += [f"={part['type_name']}", *map(_line, part["fields"])]
    return "\n".join(lines)


def _line(field: dict[str, Any]) -> str:
    """Return a field: its name, its type, its nested type or "-", the length of an array."""
    kind = field["type"]
    words = [field["name"], kind["type_id"], kind["nested_type_name"] or "-", kind["capacity"]]
    is_array = kind["type_id"] // SCALARS == 1
    return " ".join(map(str, words if is_array else words[: 3 if words[2] != "-" else 2]))


def _field(field: dict[str, Any]) -> Field:
    kind = field["type"]
    scalar = kind["type_id"] % SCALARS
    nested = kind["nested_type_name"] if scalar == NESTED else ""
    bound = kind["string_capacity"] if kind["type_id"] in BOUNDED_TEXT else 0
    return Field(
        field["name"],
        nested,
        bound,
        kind["type_id"],
        kind["capacity"],
        kind["string_capacity"],
        field["default_value"],
    )


def _nested_first(messages: dict[str, Message]) -> Iterator[Message]:
    done: set[str] = set()

    def visit(message: Message) -> Iterator[Message]:
        if message.name in done:
            return
        done.add(message.name)
        for field in message.fields:
            # Types of other interfaces have their own headers.
            if field.nested in messages:
                yield from visit(messages[field.nested])
        yield message

    for message in messages.values():
        yield from visit(message)


def header_name(interface: str) -> str:
    """Return the stem of the header of `pkg/msg/InterfaceName`, as rosidl forms it."""
    package, folder, name = interface.split("/")
    snake = re.sub("(.)([A-Z][a-z]+)", r"\1_\2", name)
    snake = re.sub("([a-z0-9])([A-Z])", r"\1_\2", snake).lower()
    return f"{package}/{folder}/detail/{snake}"


def interface_of(message: str) -> str:
    """Return the interface that defines `message`: `a/srv/B` for `a/srv/B_Request`."""
    package, folder, name = message.split("/")
    return f"{package}/{folder}/{name if folder == 'msg' else name.split('_')[0]}"


def type_support(interface: str, messages: Sequence[Message]) -> str:
    """Return the header `<interface>__type_support.hpp`, which replaces rosidl's own."""
    own = {message.name for message in messages}
    nested = {field.nested for message in messages for field in message.fields if field.nested}
    includes = sorted({header_name(interface_of(name)) for name in nested - own})
    lines = [
        f"// generated from {interface}.json by sitegen",
        "#pragma once",
        "",
        f'#include "{header_name(interface)}__struct.hpp"',
        *(f'#include "{include}__type_support.hpp"' for include in includes),
        '#include "rosidl_typesupport_sitegen_cpp/message_type_support.hpp"',
    ]
    for message in messages:
        lines += _message_support(message)
    package, folder, _ = interface.split("/")
    if folder == "srv" and package not in UNNAMED:
        lines += _service_support(interface)
    return "\n".join(lines) + "\n"


def _service_support(interface: str) -> list[str]:
    """Return the code by which programs find the type of a service by its name."""
    cpp = interface.replace("/", "::")
    return [
        "",
        "namespace rosidl_typesupport_sitegen_cpp",
        "{",
        f"inline const bool knows_{interface.replace('/', '_')} =",
        f"  know_service<{cpp}_Request, {cpp}_Response>();",
        "}  // namespace rosidl_typesupport_sitegen_cpp",
    ]


def _message_support(message: Message) -> list[str]:
    space, name = message.cpp.rsplit("::", 1)
    return [
        "",
        f"namespace {space}",
        "{",
        f"inline void visit_fields(rosidl_typesupport_sitegen_cpp::Cdr & cdr, {name} & message)",
        "{",
        *(f"  {_visit(field)};" for field in message.fields),
        "}",
        f"}}  // namespace {space}",
        "",
        "namespace rosidl_typesupport_cpp",
        "{",
        "template<>",
        "inline const rosidl_message_type_support_t *",
        f"get_message_type_support_handle<{message.cpp}>()",
        "{",
        f"  return rosidl_typesupport_sitegen_cpp::handle_of<{message.cpp}>(",
        f'    "{message.name}", "{message.hash}",',
        f"    {json.dumps(message.definition)});",
        "}",
        "}  // namespace rosidl_typesupport_cpp",
    ]


def _visit(field: Field) -> str:
    if field.bound:
        return f"cdr.bounded(message.{field.name}, {field.bound})"
    return f"cdr(message.{field.name})"
