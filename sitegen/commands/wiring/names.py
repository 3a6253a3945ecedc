"""Resolve the names that programs use to full names, as rcl does."""

from __future__ import annotations

from dataclasses import replace

from sitegen.commands.wiring.endpoint import Program
from sitegen.model import Node


def resolved(program: Program, node: Node) -> Program:
    """Return `program` with full names, started as `node` of site.yaml.

    Endpoints whose names cannot be resolved are left out, and the program is marked as open.
    """
    namespace = _namespace(program, node)
    name = next(iter(program.names)) if len(program.names) == 1 else None
    rules = [(_full(old, namespace, name), new) for old, new in node.remap.items()]
    # A rule may be for some nodes or kinds only, and the arguments may contain other rules.
    unclear = any(old is None or ":" in f"{old}{new}" for old, new in rules)
    if unclear or program.renames or "--ros-args" in node.arguments:
        return replace(program, endpoints=[], open=True)
    found = []
    for endpoint in program.endpoints:
        full = _full(endpoint.name, namespace, name)
        rule = next((new for old, new in rules if old == full), None)
        full = full if rule is None else _full(rule, namespace, name)
        if full is not None:
            found.append(replace(endpoint, name=full))
    missing = len(found) < len(program.endpoints)
    return replace(program, endpoints=found, open=program.open or missing)


def of_nodes(program: Program, node: Node) -> frozenset[str] | None:
    """Return the full names of the nodes of `program`, started as `node`; None if one is unknown.

    It may be a node that another program of the package creates in the same source.
    """
    namespace = _namespace(program, node)
    given = node.remap.get("__node")
    names = {given} if given else program.names
    unclear = program.renames or "--ros-args" in node.arguments or None in names or not names
    if namespace is None or unclear:
        return None
    return frozenset(f"{namespace}{name}" for name in names)


def _namespace(program: Program, node: Node) -> str | None:
    """Return the namespace of the program's nodes, ending in `/`; None if it is unknown."""
    if len(program.namespaces) != 1 or None in program.namespaces:
        return None
    # The namespace in site.yaml is passed as an argument, which takes precedence.
    given = node.namespace or next(iter(program.namespaces)) or ""
    return f"/{given.strip('/')}/".replace("//", "/")


def _full(name: str, namespace: str | None, node: str | None) -> str | None:
    """Return the full name of `name`, None if it is unknown."""
    if "{" in name or not name:
        return None
    if name.startswith("/"):
        return name
    if namespace is None:
        return None
    if name.startswith("~"):
        return f"{namespace}{node}{name[1:]}" if node else None
    return f"{namespace}{name}"
