"""Turn the names that programs write into those of the graph, as rcl does."""

from __future__ import annotations

from dataclasses import replace

from sitegen.commands.wiring.endpoint import Program
from sitegen.model import Node


def resolved(program: Program, node: Node) -> Program:
    """Return `program` as `node` of site.yaml starts it, with full names.

    What gets no name for sure is left out, and the program is open then.
    """
    namespace = _namespace(program, node)
    name = next(iter(program.names)) if len(program.names) == 1 else None
    rules = [(_full(old, namespace, name), new) for old, new in node.remap.items()]
    # A rule may be for some nodes or kinds only, and others may come in by the arguments.
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


def _namespace(program: Program, node: Node) -> str | None:
    """Return the namespace of the program's nodes, ending in `/`; None if nobody can tell."""
    if len(program.namespaces) != 1 or None in program.namespaces:
        return None
    # The one of site.yaml comes as an argument, which goes first.
    given = node.namespace or next(iter(program.namespaces)) or ""
    return f"/{given.strip('/')}/".replace("//", "/")


def _full(name: str, namespace: str | None, node: str | None) -> str | None:
    """Return the full name of `name`, None where that is not known."""
    if "{" in name or not name:
        return None
    if name.startswith("/"):
        return name
    if namespace is None:
        return None
    if name.startswith("~"):
        return f"{namespace}{node}{name[1:]}" if node else None
    return f"{namespace}{name}"
