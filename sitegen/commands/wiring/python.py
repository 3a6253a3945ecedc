"""Find the endpoints in the sources of a Python program."""

from __future__ import annotations

import ast
import re
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from sitegen.commands.wiring.endpoint import (
    ACTION,
    ACTION_CLIENT,
    CLIENT,
    KINDS,
    LIFECYCLE,
    OPTIONS,
    PARAMETERS,
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    TRANSFORMS,
    Endpoint,
    Program,
)
from sitegen.config.cellsources import CellSource
from sitegen.errors import Location
from sitegen.model import Setup

_CREATE = {f"create_{kind}": kind for kind in KINDS}
_ACTIONS = {"ActionServer": ACTION, "ActionClient": ACTION_CLIENT}
# The keyword arguments that give the type and the name of an endpoint.
_KEYWORDS = {
    **dict.fromkeys((PUBLISHER, SUBSCRIPTION), ("msg_type", "topic")),
    **dict.fromkeys((SERVICE, CLIENT), ("srv_type", "srv_name")),
    **dict.fromkeys((ACTION, ACTION_CLIENT), ("action_type", "action_name")),
}
_INTERFACE = re.compile(r"(\w+)\.(msg|srv|action)\.(\w+)")
# Names whose mention tells what a program uses.
_USES = {
    **{"declare_parameter": PARAMETERS, "declare_parameters": PARAMETERS},
    **{"LifecycleNode": LIFECYCLE, "ArgumentParser": OPTIONS},
    **{"TransformBroadcaster": TRANSFORMS, "StaticTransformBroadcaster": TRANSFORMS},
}
# Modules that create no endpoints; other modules may.
_HARMLESS = {"ament_index_python", "numpy", "rclpy", "typing_extensions", "yaml"}
_HARMLESS |= sys.stdlib_module_names - {"importlib"}
_UNCLEAR = {"exec", "eval", "__import__"}

_Definition = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef


@dataclass(frozen=True)
class _Module:
    """A source file: `imports` maps each imported name to its full dotted name."""

    file: Path
    tree: ast.Module
    imports: dict[str, str]
    texts: dict[str, str]


def read(setup: Setup, executable: str) -> Program:
    """Return what the module of an entry point, or a program, and the modules it imports tell."""
    program = Program()
    target = setup.scripts[executable]
    name, _, attribute = (target, "", "") if target in setup.files else target.partition(":")
    modules = _modules(name, setup, program)
    used = _used(modules, name, attribute)
    for module in modules.values():
        for statement in module.tree.body:
            sure = not isinstance(statement, _Definition) or statement.name in used
            _read(statement, module, program, sure=sure)
    return program


def read_cells(source: CellSource) -> Program:
    """Return what the cells of a notebook tell, as if all of them were run."""
    tree = source.tree
    module = _Module(source.file, tree, dict(_imports(tree, "")), dict(_texts(tree)))
    program = Program()
    for statement in tree.body:
        _read(statement, module, program, sure=True)
    program.endpoints = [
        replace(each, location=source.location(each.location.line)) for each in program.endpoints
    ]
    return program


def _modules(first: str, setup: Setup, program: Program) -> dict[str, _Module]:
    """Return the package's modules that `first` needs; other modules may leave the program open."""
    found: dict[str, _Module] = {}
    waiting = [first]
    while waiting:
        name = waiting.pop()
        stem = f"python/{name.replace('.', '/')}"
        paths = (name, f"{stem}.py", f"{stem}/__init__.py")
        file = next((setup.files[path] for path in paths if path in setup.files), None)
        if name in found or file is None:
            program.open |= name == first and file is None
            continue
        try:
            tree = ast.parse(file.read_bytes())
        except (OSError, SyntaxError, ValueError):
            program.open = True
            continue
        package = name if file.name == "__init__.py" else name.rpartition(".")[0]
        imports = dict(_imports(tree, package))
        found[name] = _Module(file, tree, imports, dict(_texts(tree)))
        for full in imports.values():
            parts = full.split(".")
            own = [".".join(parts[:size]) for size in range(1, len(parts) + 1)]
            own = [one for one in own if f"python/{one.replace('.', '/')}" in _stems(setup)]
            waiting += own
            harmless = parts[0] in _HARMLESS or bool({"msg", "srv", "action"} & set(parts[1:2]))
            if (not own and not harmless) or full.startswith("rclpy.lifecycle"):
                program.open = True
    return found


def _stems(setup: Setup) -> set[str]:
    return {path.removesuffix(".py").removesuffix("/__init__") for path in setup.files}


def _imports(tree: ast.Module, package: str) -> Iterator[tuple[str, str]]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield alias.asname or alias.name, alias.name
        elif isinstance(node, ast.ImportFrom):
            above = package.split(".")
            base = ".".join(above[: len(above) - node.level + 1]) if node.level else ""
            origin = ".".join(filter(None, (base, node.module)))
            for alias in node.names:
                yield alias.asname or alias.name, f"{origin}.{alias.name}"


def _texts(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """Yield the constants: names that are assigned a string once, at the top of the module."""
    stored = Counter(
        node.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    )
    for statement in tree.body:
        value = getattr(statement, "value", None)
        if isinstance(statement, ast.Assign) and isinstance(value, ast.Constant):
            names = [target.id for target in statement.targets if isinstance(target, ast.Name)]
            if isinstance(value.value, str):
                yield from ((name, value.value) for name in names if stored[name] == 1)


def _used(modules: dict[str, _Module], first: str, entry: str) -> set[str]:
    """Return the definitions that the program may reach, by name, in any module.

    The program begins with the function `entry` of the module `first`, or, if `entry` is empty,
    with the module itself.
    """
    definitions: dict[str, list[_Definition]] = {}
    used: set[str] = set()
    waiting = {entry.partition(".")[0]}
    for name, module in modules.items():
        runs = name == first and not entry
        for statement in module.tree.body:
            if isinstance(statement, _Definition):
                definitions.setdefault(statement.name, []).append(statement)
            elif runs or "__name__" not in _mentioned([statement]):
                waiting |= _mentioned([statement])
    while waiting:
        name = waiting.pop()
        if name in definitions and name not in used:
            used.add(name)
            waiting |= _mentioned(definitions[name])
    return used


def _mentioned(statements: Iterable[ast.stmt]) -> set[str]:
    nodes = [node for statement in statements for node in ast.walk(statement)]
    names = {node.id for node in nodes if isinstance(node, ast.Name)}
    return names | {node.attr for node in nodes if isinstance(node, ast.Attribute)}


def _read(statement: ast.stmt, module: _Module, program: Program, *, sure: bool) -> None:
    calls = [node for node in ast.walk(statement) if isinstance(node, ast.Call)]
    called = {id(call.func) for call in calls}
    if sure:
        program.uses |= {_USES[name] for name in _USES.keys() & _mentioned([statement])}
        for position, is_number in _arguments(statement, module):
            program.take(Program(arguments={position: is_number}))
    for node in ast.walk(statement):
        name = getattr(node, "attr", None) or getattr(node, "id", None)
        named = isinstance(node, ast.FunctionDef) and node.name in _CREATE
        hidden = isinstance(node, ast.Constant) and node.value in _CREATE
        if named or hidden or (name in _CREATE and id(node) not in called) or name in _UNCLEAR:
            program.open = True
    for call in calls:
        name = call.func.attr if isinstance(call.func, ast.Attribute) else ""
        action = _ACTIONS.get(_name(call.func).rpartition(".")[2])
        if kind := _CREATE.get(name) or action:
            _create(call, kind, module, program, sure=sure)
        elif name == "init" and _has_list(call):
            program.renames = True
    for call, keywords in _nodes(statement, calls):
        given = call.args[0] if call.args else keywords.get("node_name")
        program.names.add(_text(given, module))
        namespace = keywords.get("namespace")
        none = isinstance(namespace, ast.Constant) and namespace.value is None
        program.namespaces.add("" if not namespace or none else _text(namespace, module))
        if {"cli_args", "use_global_arguments", ""} & keywords.keys():
            program.renames = True


def _create(call: ast.Call, kind: str, module: _Module, program: Program, *, sure: bool) -> None:
    keywords = {keyword.arg: keyword.value for keyword in call.keywords}
    of_type, of_name = _KEYWORDS[kind]
    # The first argument of an action is its node.
    given = call.args[1:] if kind in _ACTIONS.values() else call.args
    type = given[0] if given else keywords.get(of_type)
    name = _text(given[1] if len(given) > 1 else keywords.get(of_name), module)
    if name is None:
        program.open = True
        return
    location = Location(module.file, call.lineno)
    endpoint = Endpoint(kind, name, _type(type, module), location, sure=sure, foreign=not sure)
    program.endpoints.append(endpoint)


def _arguments(statement: ast.stmt, module: _Module) -> Iterator[tuple[int, bool]]:
    """Yield the positions of `sys.argv` that are read, and whether each becomes a number."""
    numbers = {
        id(call.args[0])
        for call in ast.walk(statement)
        if isinstance(call, ast.Call) and _name(call.func) in ("int", "float") and call.args
    }
    for node in ast.walk(statement):
        if not isinstance(node, ast.Subscript) or not isinstance(node.slice, ast.Constant):
            continue
        position, of = node.slice.value, _name(node.value)
        first, mark, rest = of.partition(".")
        if f"{module.imports.get(first, first)}{mark}{rest}" != "sys.argv":
            continue
        if isinstance(position, int) and position > 0:
            yield position, id(node) in numbers


def _nodes(
    statement: ast.stmt, calls: Iterable[ast.Call]
) -> Iterator[tuple[ast.Call, dict[str, ast.expr]]]:
    """Yield the calls that create a node, with their keyword arguments; "" for unpacked ones."""
    is_node = isinstance(statement, ast.ClassDef) and any(
        _mentions_node(base) for base in statement.bases
    )
    for call in calls:
        function = ast.unparse(call.func)
        if function in ("Node", "rclpy.node.Node", "rclpy.create_node", "create_node") or (
            is_node and function in ("super().__init__", "Node.__init__")
        ):
            yield call, {keyword.arg or "": keyword.value for keyword in call.keywords}


def _name(function: ast.expr) -> str:
    """Return a name or a dotted name as it is written, else nothing."""
    return ast.unparse(function) if isinstance(function, ast.Name | ast.Attribute) else ""


def _has_list(call: ast.Call) -> bool:
    """Return whether arguments are given as a list in place of the program's own."""
    given = [*call.args, *(keyword.value for keyword in call.keywords)]
    return any(isinstance(value, ast.List | ast.BinOp) for value in given)


def _mentions_node(base: ast.expr) -> bool:
    return ast.unparse(base).rpartition(".")[2].endswith("Node")


def _text(given: ast.expr | None, module: _Module) -> str | None:
    if isinstance(given, ast.Constant) and isinstance(given.value, str):
        return given.value
    return module.texts.get(given.id) if isinstance(given, ast.Name) else None


def _type(given: ast.expr | None, module: _Module) -> str:
    """Return a type as ROS writes it, or nothing if the name does not tell."""
    if given is None:
        return ""
    first, mark, rest = ast.unparse(given).partition(".")
    found = _INTERFACE.fullmatch(f"{module.imports.get(first, first)}{mark}{rest}")
    return "/".join(found.groups()) if found else ""
