"""Turn ROS interface definitions into the C++ headers that nodes compile against.

The message classes come from the real rosidl generator. What sitegen adds is a type support: how to
walk over the fields of a message, from the type description (`*.json`) that rosidl gives each type.
"""

from __future__ import annotations

import importlib
import json
import re
import sys
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROS = Path(__file__).parent / "ros"
KINDS = ("msg", "srv", "action")
RUNTIME = ("rcutils", "rosidl_runtime_c", "rosidl_runtime_cpp", "rosidl_typesupport_interface")

# type_description_interfaces/msg/FieldType: a scalar's number, plus 48 for an array of it, 96 for a
# bounded and 144 for an unbounded sequence.
NESTED = 1
BOUNDED_TEXT = (21, 22)
SCALARS = 48


@dataclass(frozen=True)
class Field:
    """A field of a message: its C++ name, the message it nests if any, its bound if a text."""

    name: str
    nested: str
    bound: int


@dataclass(frozen=True)
class Message:
    """One message class: `std_msgs/msg/Header`, or a part of a service or an action."""

    name: str
    hash: str
    fields: tuple[Field, ...]

    @property
    def package(self) -> str:
        """The package that defines it."""
        return self.name.split("/")[0]

    @property
    def cpp(self) -> str:
        """Its C++ class."""
        return self.name.replace("/", "::")


def read_description(file: Path) -> Iterator[Message]:
    """Yield the messages that the interface of a type description consists of, nested first.

    A message is one; the `.json` of a service also describes its request, response and event.
    """
    data = json.loads(file.read_text())
    description = data["type_description_msg"]
    own = description["type_description"]["type_name"]
    hashes = {entry["type_name"]: entry["hash_string"] for entry in data["type_hashes"]}
    parts = [*description["referenced_type_descriptions"], description["type_description"]]
    messages = [_message(part, hashes) for part in parts]
    mine = {m.name: m for m in messages if m.name == own or m.name.startswith(f"{own}_")}
    if own.split("/")[1] != "msg":
        del mine[own]  # a service or an action is no message itself
    yield from _nested_first(mine)


def _message(part: dict[str, Any], hashes: dict[str, str]) -> Message:
    fields = tuple(_field(field) for field in part["fields"])
    return Message(part["type_name"], hashes[part["type_name"]], fields)


def _field(field: dict[str, Any]) -> Field:
    kind = field["type"]
    scalar = kind["type_id"] % SCALARS
    nested = kind["nested_type_name"] if scalar == NESTED else ""
    bound = kind["string_capacity"] if kind["type_id"] in BOUNDED_TEXT else 0
    return Field(field["name"], nested, bound)


def _nested_first(messages: dict[str, Message]) -> Iterator[Message]:
    done: set[str] = set()

    def visit(message: Message) -> Iterator[Message]:
        if message.name in done:
            return
        done.add(message.name)
        for field in message.fields:
            # An action's services are nested by name only: they are services, no messages.
            if field.nested in messages:
                yield from visit(messages[field.nested])
        yield message

    for message in messages.values():
        yield from visit(message)


def header_name(interface: str) -> str:
    """Return the header stem of `pkg/msg/InterfaceName` as rosidl forms it."""
    package, folder, name = interface.split("/")
    snake = re.sub("(.)([A-Z][a-z]+)", r"\1_\2", name)
    snake = re.sub("([a-z0-9])([A-Z])", r"\1_\2", snake).lower()
    return f"{package}/{folder}/detail/{snake}"


def interface_of(message: str) -> str:
    """Return the interface that defines `message`: `a/srv/B` for `a/srv/B_Request`."""
    package, folder, name = message.split("/")
    return f"{package}/{folder}/{name if folder == 'msg' else name.split('_')[0]}"


def type_support(interface: str, messages: Sequence[Message]) -> str:
    """Write the header `<interface>__type_support.hpp`, in place of rosidl's own."""
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
    return "\n".join(lines) + "\n"


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
        f'    "{message.name}", "{message.hash}");',
        "}",
        "}  // namespace rosidl_typesupport_cpp",
    ]


def _visit(field: Field) -> str:
    if field.bound:
        return f"cdr.bounded(message.{field.name}, {field.bound})"
    return f"cdr(message.{field.name})"


def write_package(prefix: Path, package: str, descriptions: Iterable[Path]) -> None:
    """Add `package` to the CMake prefix: its type supports and its CMake configuration.

    Rosidl's headers of the package are already in `prefix/include/<package>` or in ROS.
    """
    depends: set[str] = set()
    for file in sorted(descriptions):
        interface = f"{package}/{file.parent.name}/{file.stem}"
        messages = list(read_description(file))
        header = prefix / "include" / package / f"{header_name(interface)}__type_support.hpp"
        header.parent.mkdir(parents=True, exist_ok=True)
        header.write_text(type_support(interface, messages))
        depends |= {field.nested.split("/")[0] for m in messages for field in m.fields}
    config = prefix / "share" / package / "cmake" / f"{package}Config.cmake"
    config.parent.mkdir(parents=True, exist_ok=True)
    config.write_text(_cmake_config(prefix, package, sorted(depends - {package, ""})))


def _cmake_config(prefix: Path, package: str, depends: Sequence[str]) -> str:
    # Ours first: it has the type supports in place of rosidl's.
    folders = [prefix / "include" / package, ROS / "include" / package]
    folders += [ROS / "include" / runtime for runtime in RUNTIME]
    include = ";".join(folder.as_posix() for folder in folders if folder.exists())
    target = f"{package}::{package}"
    typesupport = f"{target}__rosidl_typesupport_cpp"
    return "\n".join(
        [
            "include_guard(GLOBAL)",
            "include(CMakeFindDependencyMacro)",
            *(f"find_dependency({depend})" for depend in depends),
            f"add_library({target} INTERFACE IMPORTED GLOBAL)",
            f"set_target_properties({target} PROPERTIES",
            f'  INTERFACE_INCLUDE_DIRECTORIES "{include}"',
            f'  INTERFACE_LINK_LIBRARIES "{";".join(f"{d}::{d}" for d in depends)}")',
            f"add_library({typesupport} ALIAS {target})",
            f"set({package}_TARGETS {target})",
            f"set({package}_LIBRARIES {target})",
            f'set({package}_INCLUDE_DIRS "{include}")',
            "",
        ]
    )


def write_ros(prefix: Path) -> None:
    """Add the interface packages that come with sitegen to the CMake prefix."""
    for share in sorted((ROS / "share").iterdir()):
        descriptions = [file for kind in KINDS for file in share.glob(f"{kind}/*.json")]
        if descriptions:
            write_package(prefix, share.name, descriptions)


def generate(prefix: Path, package: str, folder: Path, files: Sequence[str]) -> None:
    """Generate the C++ headers of a workspace package and add it to the CMake prefix.

    `files` are its `.msg`, `.srv`, `.action` and `.idl` files, relative to `folder`.
    """
    sys.path.insert(0, str(ROS / "python"))  # rosidl is vendored, as its wheels name one platform
    adapter = importlib.import_module("rosidl_adapter")
    description = importlib.import_module("rosidl_generator_type_description")
    cpp = importlib.import_module("rosidl_generator_cpp")
    share = prefix / "share" / package
    share.mkdir(parents=True, exist_ok=True)
    idls = []
    for name in files:
        if name.endswith(".idl"):
            idls.append(f"{folder}:{name}")
        else:
            idl = adapter.convert_to_idl(folder, package, Path(name), share)
            idls.append(f"{share}:{Path(idl).relative_to(share).as_posix()}")
    arguments = {
        "package_name": package,
        "idl_tuples": idls,
        "include_paths": [
            f"{path.name}:{path}"
            for shares in (ROS / "share", prefix / "share")
            for path in sorted(shares.iterdir())
            if path.name != package
        ],
        "output_dir": str(share),
        "template_dir": str(ROS / "share" / "rosidl_generator_cpp" / "resource"),
        "target_dependencies": [],
    }
    _run(description.generate_type_hash, arguments)
    _run(cpp.generate_cpp, arguments | {"output_dir": str(prefix / "include" / package / package)})
    # Beside those of the interfaces it has written one for each part of a service or action.
    descriptions = [share / idl.rpartition(":")[2] for idl in idls]
    write_package(prefix, package, (file.with_suffix(".json") for file in descriptions))


def _run(generator: Any, arguments: dict[str, Any]) -> None:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "arguments.json"
        file.write_text(json.dumps(arguments))
        generator(str(file))


if __name__ == "__main__":
    # Called by rosidl_generate_interfaces() while CMake configures a package.
    generate(Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3]), sys.argv[4:])
