"""The programs of pages, with what their sources tell."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from sitegen.commands.init.turtle import KEY, turtlesim
from sitegen.commands.wiring import programs
from sitegen.commands.wiring.common import is_common
from sitegen.commands.wiring.endpoint import OPPOSITE, Endpoint, Program
from sitegen.commands.wiring.names import resolved
from sitegen.model import Container, Node, Package


@dataclass(frozen=True)
class Member:
    """A program as a node of a page: `name` is that of the node, `told` has full names.

    `source` is the language of its source file, "" if the file is not in the workspace; `urdf` is
    the file with the robot description that it is given. `components` are the classes that a
    component container loads.
    """

    name: str
    package: str
    executable: str
    told: Program
    source: str = ""
    urdf: str = ""
    components: tuple[str, ...] = ()

    @property
    def shown(self) -> str:
        """What it runs, for lists of programs."""
        if self.components:
            return ", ".join(each.rpartition("::")[2] for each in self.components)
        return Path(self.urdf).name if self.urdf else self.executable

    @property
    def key(self) -> tuple[str, str]:
        """What identifies the program."""
        return self.package, self.executable

    def endpoints(self, *kinds: str) -> Iterator[Endpoint]:
        """Yield the program's own endpoints of these kinds, without those that every node has."""
        for endpoint in self.told.endpoints:
            if endpoint.kind in kinds and not endpoint.foreign and not is_common(endpoint.name):
                yield endpoint

    def answers(self, endpoint: Endpoint) -> bool:
        """Return whether an endpoint of this program communicates with `endpoint`."""
        return any(
            each.names & endpoint.names and len({each.type, endpoint.type} - {""}) < 2
            for each in self.endpoints(OPPOSITE[endpoint.kind])
        )


def member(node: Node, packages: Mapping[str, Package], own: Mapping[str, Package]) -> Member:
    """Return the program of a node of `packages`; `own` are those of the workspace."""
    if isinstance(node.kind, Container):
        told = programs.read_container(node.kind, packages)
        classes = tuple(component.plugin for component in node.kind.components)
        return Member(node.name, node.package, node.executable, told, components=classes)
    package = packages.get(node.package)
    told = programs.read(package, node.executable) if package else Program(open=True)
    if (node.package, node.executable) == KEY:
        told = turtlesim()
    if not told.namespaces:
        # How its node is created is unknown; most are in the root namespace.
        told = replace(told, namespaces={""})
    language = _language(own[node.package], node.executable) if node.package in own else ""
    return Member(node.name, node.package, node.executable, resolved(told, node), language)


def _language(package: Package, executable: str) -> str:
    """Return the language of the source file of a program, "" if it cannot be shown."""
    name = next(iter(package.sources.get(executable, ())), "")
    if not name or not any(file.is_file() for file in package.path.rglob(Path(name).name)):
        return ""
    return "Python" if package.setup and executable in package.setup.scripts else "C++"
