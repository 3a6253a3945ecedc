"""Find the endpoints in the sources of a program, in C++ or Python."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise

from sitegen.commands.wiring import cpp, python
from sitegen.commands.wiring.endpoint import Program
from sitegen.commands.wiring.names import resolved
from sitegen.model import Component, Container, Node, Package


def read(package: Package, executable: str) -> Program:
    """Return what the sources of `executable` tell, with names as they are written there."""
    if package.setup and executable in package.setup.scripts:
        return python.read(package.setup, executable)
    return cpp.read(package, executable)


def read_container(container: Container, packages: Mapping[str, Package]) -> Program:
    """Return what the sources of the components in a container tell, with full names."""
    program = Program()
    for component in container.components:
        package = packages.get(component.package)
        told = cpp.read_component(package, component.plugin) if package else Program(open=True)
        told = replace(told, namespaces=told.namespaces or {""})
        program.take(resolved(told, _node(component)))
    return program


def _node(component: Component) -> Node:
    """Return the node that a component becomes."""
    rules = dict(
        rule.split(":=", 1) for flag, rule in pairwise(component.arguments) if flag == "-r"
    )
    namespace, name = rules.pop("__ns", ""), rules.pop("__node", "")
    location = component.location
    return Node(name, component.package, "", location, namespace=namespace, remap=rules)
