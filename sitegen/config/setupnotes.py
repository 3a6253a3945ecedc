"""Note what is doubtful in the build files of packages."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sitegen.config.nodes import with_kind
from sitegen.errors import Problems
from sitegen.model import Node, Package, Python


def note_setups(nodes: Iterable[Node], packages: Mapping[str, Package], notes: Problems) -> None:
    """Add notes about the packages that Python nodes come with."""
    own = {node.package for node in nodes if isinstance(with_kind(node, packages).kind, Python)}
    waiting, seen = [*own], set[str]()
    while waiting:
        name = waiting.pop()
        package = packages.get(name)
        if package is None or name in seen:
            continue
        seen.add(name)
        waiting += package.depends
        setup = package.setup
        if setup and setup.files:
            # The faults in a node's own package are problems.
            for fault in (*setup.notes, *(() if name in own else setup.faults)):
                notes.add(fault.location, fault.key, fault.message)
