"""Find the endpoints in the sources of a C++ program."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

from sitegen.commands.wiring.cpptext import Text, literal
from sitegen.commands.wiring.endpoint import (
    ACTION,
    ACTION_CLIENT,
    LIFECYCLE,
    OPTIONS,
    PARAMETERS,
    TRANSFORMS,
    Endpoint,
    Program,
)
from sitegen.errors import Location
from sitegen.model import Package
from sitegen.shipped import INTERFACES, PACKAGES, ROS
from sitegen.workspace import components

_CREATE = re.compile(
    r"(?P<scope>\brclcpp(?:_action)?\s*::\s*)?"
    r"\bcreate_(?P<generic>generic_)?(?P<kind>publisher|subscription|service|client|server)\b"
)
# How nodes are created: `: Node("talker")`, `Node::make_shared("talker")`,
# `make_shared<Node>("talker")`.
_NODE = re.compile(r"\bNode\b\s*(?:::\s*make_shared\b|>)?\s*(?:\w+\s*)?(?=\(|\{\s*\")")
_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">\n]+)[">]', re.MULTILINE)
_GUARD = re.compile(r"\A\s*#\s*ifndef\s+(\w+)\s*\n\s*#\s*define\s+\1\b")
_CONDITION = re.compile(r"^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else)\b", re.MULTILINE)
# With these, names may differ from those in the source.
_RENAMES = re.compile(
    r"\bcreate_sub_node\b|\.\s*arguments\s*\(|\buse_global_arguments\b|--ros-args"
)
_INTERFACE = re.compile(r"(\w+)::(msg|srv|action)::(\w+)")
_ACTIONS = {"server": ACTION, "client": ACTION_CLIENT}
_USES = {
    PARAMETERS: re.compile(r"\bdeclare_parameters?\b"),
    LIFECYCLE: re.compile(r"\bLifecycleNode\b"),
    TRANSFORMS: re.compile(r"\b(Static)?TransformBroadcaster\b"),
    OPTIONS: re.compile(r"\bgetopt(_long)?\b|\bremove_ros_arguments\b|\binit_and_remove_ros"),
}
_ARGUMENT = re.compile(
    r"(?P<number>\b(ato[ifl]l?|sto(i|l|ll|f|d|u?ll?)|strto\w+)\s*\(\s*)?"
    r"\bargv\s*\[\s*(?P<position>[1-9]\d?)\s*\]"
)
_ALIAS = re.compile(
    r"\busing\s+(?P<new>\w+)\s*=\s*(?P<old>[\w:]+)\s*;"
    r"|\btypedef\s+(?P<old2>[\w:]+)\s+(?P<new2>\w+)\s*;"
    r"|\bnamespace\s+(?P<new3>\w+)\s*=\s*(?P<old3>[\w:]+)\s*;"
    r"|\busing\s+(?P<old4>[\w:]+::(?P<new4>\w+))\s*;"
)
# Headers that create no endpoints; headers of other libraries may.
_HARMLESS = re.compile(
    r"(rclcpp|rclcpp_action|rclcpp_components|rcutils|rcpputils|rmw|rcl|ament_index_cpp|Eigen|tf2"
    r"|sys)/.+|\w+_msgs/.+|\w+/(msg|srv|action)/.+|[\w.]+"
)
_SOURCES = (".cpp", ".cc", ".cxx", ".c++", ".c")
_HEADERS = (".hpp", ".h", ".hh", ".hxx")


def read(package: Package, executable: str) -> Program:
    """Return what the sources of `executable`, with its headers and libraries, tell."""
    program = Program()
    names = package.sources.get(executable, ())
    shared = [name for one, used in package.sources.items() if one != executable for name in used]
    program.open = not names
    seen: set[Path] = set()
    for name in names:
        # Of sources that several programs share, one program may use only a part.
        _take(package.path / name, package, program, seen, sure=name not in shared)
    _take_libraries(package, executable, program, seen)
    told = {package.path / name for used in package.sources.values() for name in used}
    # The program may be linked to these in a way that only CMake knows.
    others = Program()
    for file in sorted(package.path.rglob("*")):
        if file.suffix in _SOURCES and file not in told and not _is_test(file, package):
            _take(file, package, others, seen, sure=False)
    others.endpoints = [replace(endpoint, foreign=True) for endpoint in others.endpoints]
    program.take(replace(others, uses=set(), arguments={}))
    return _with_known_types(program, package)


def read_component(package: Package, plugin: str) -> Program:
    """Return what the source that registers a component tells, with its headers."""
    program, seen = Program(), set[Path]()
    files = components.sources(package.path, {plugin: plugin}).get(plugin, [])
    program.open = not files
    for name in files:
        _take(package.path / name, package, program, seen, sure=False)
    return _with_known_types(program, package)


def _with_known_types(program: Program, package: Package) -> Program:
    known = {package.name, *package.depends, *_interface_packages()}
    program.endpoints = [_with_known_type(endpoint, known) for endpoint in program.endpoints]
    return program


def _take_libraries(package: Package, executable: str, program: Program, seen: set[Path]) -> None:
    """Add what the libraries of the package that a program is linked to tell of it.

    Of a library that several programs are linked to, these are the sources of the headers that the
    program includes.
    """
    others = {name for one, used in package.libraries.items() if one != executable for name in used}
    left = [*package.libraries.get(executable, ())]
    while True:
        included = {file.stem for file in seen if file.suffix in _HEADERS}
        chosen = [name for name in left if name not in others or Path(name).stem in included]
        if not chosen:
            return
        left = [name for name in left if name not in chosen]
        for name in chosen:
            _take(package.path / name, package, program, seen, sure=False)


def _with_known_type(endpoint: Endpoint, packages: Collection[str]) -> Endpoint:
    """Return an endpoint; the package of its type may be an alias that another header defines."""
    known = endpoint.type.partition("/")[0] in packages
    return endpoint if known else replace(endpoint, type="")


@cache
def _interface_packages() -> frozenset[str]:
    """Return the packages of interfaces that every workspace can use."""
    shares = (*(ROS / "share").iterdir(), *PACKAGES.iterdir(), *INTERFACES.iterdir())
    return frozenset(share.name for share in shares)


def _is_test(file: Path, package: Package) -> bool:
    return bool({"test", "tests"} & set(file.relative_to(package.path).parts))


def _take(file: Path, package: Package, program: Program, seen: set[Path], *, sure: bool) -> None:
    if file in seen:
        return
    seen.add(file)
    try:
        text = Text.of(file.read_text(encoding="utf-8-sig"))
    except (OSError, UnicodeDecodeError):
        program.open = True
        return
    guarded = _GUARD.match(text.bare)
    conditions = len(_CONDITION.findall(text.bare)) - bool(guarded)
    found = _program(text, file)
    if conditions or not sure:
        # It depends on the preprocessor, or on how the header is used.
        found.endpoints = [replace(endpoint, sure=False) for endpoint in found.endpoints]
    program.take(found)
    for mark, name in _INCLUDE.findall(text.code):
        own = [file.parent / name, package.path / "include" / name, package.path / "src" / name]
        header = next((path for path in own if path.is_file()), None)
        if header:
            _take(header.resolve(), package, program, seen, sure=False)
        elif not _HARMLESS.fullmatch(name) or (mark == '"' and "/" not in name):
            program.open = True


def _program(text: Text, file: Path) -> Program:
    program = Program(renames=bool(_RENAMES.search(text.code)))
    program.uses = {use for use, pattern in _USES.items() if pattern.search(text.bare)}
    for found in _ARGUMENT.finditer(text.bare):
        program.take(Program(arguments={int(found["position"]): bool(found["number"])}))
    aliases = _aliases(text)
    for found in _CREATE.finditer(text.bare):
        scope = (found["scope"] or "").replace("::", "").strip()
        if found["kind"] == "server" and scope != "rclcpp_action":
            # A function of another library.
            continue
        types, end = text.template(found.end())
        arguments = text.arguments(end) or []
        if scope == "rclcpp_action":
            # The name comes after the node, or after its interfaces.
            kind = _ACTIONS.get(found["kind"], "")
            name = next(filter(None, map(literal, arguments)), None)
        else:
            # The first argument of the function is the node.
            arguments = arguments[1:] if scope else arguments
            kind, name = found["kind"], literal(arguments[0]) if arguments else None
        if name is None or not kind:
            program.open = True
            continue
        if found["generic"]:
            type = literal(arguments[1]) or "" if len(arguments) > 1 else ""
        else:
            type = _type(types[0], aliases) if types else ""
        location = Location(file, text.line(found.start("kind")))
        program.endpoints.append(Endpoint(kind, name, type, location))
    for name, namespace in _nodes(text):
        program.names.add(name)
        program.namespaces.add(namespace)
    return program


def _nodes(text: Text) -> Iterator[tuple[str | None, str | None]]:
    """Yield name and namespace of each node that is created; None if they are not literals."""
    for found in _NODE.finditer(text.bare):
        name, *rest = text.arguments(found.end()) or [""]
        if not rest or "option" in rest[0].lower():
            yield literal(name), ""
        else:
            yield literal(name), literal(rest[0])


def _aliases(text: Text) -> dict[str, str]:
    found: dict[str, str] = {}
    for match in _ALIAS.finditer(text.bare):
        new = match["new"] or match["new2"] or match["new3"] or match["new4"]
        old = match["old"] or match["old2"] or match["old3"] or match["old4"]
        # The same name for two types can only be resolved with scopes.
        found[new] = old.removeprefix("::") if found.get(new, old) == old else ""
    return found


def _type(written: str, aliases: dict[str, str]) -> str:
    """Return a type as ROS writes it, or nothing if the name does not tell."""
    name = re.sub(r"\s+", "", written).removeprefix("::")
    for _ in range(3):
        first, mark, rest = name.partition("::")
        name = f"{aliases[first]}{mark}{rest}" if first in aliases else name
    found = _INTERFACE.fullmatch(name)
    return "/".join(found.groups()) if found else ""
