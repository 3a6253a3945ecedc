"""The nodes of a page: what each runs, and how it is started."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from sitegen.errors import Location
from sitegen.model.package import Setup


@dataclass(frozen=True)
class Cpp:
    """A C++ executable of the workspace."""


@dataclass(frozen=True)
class Python:
    """A Python executable of the workspace: `setup` says what its package installs."""

    setup: Setup


@dataclass(frozen=True)
class Component:
    """A component that a container loads: its class, and the arguments of the node it becomes."""

    package: str
    plugin: str
    arguments: tuple[str, ...]
    location: Location

    @property
    def words(self) -> list[str]:
        """Return what the container's command line says about it."""
        return ["--component", self.plugin, str(len(self.arguments)), *self.arguments]


@dataclass(frozen=True)
class Container:
    """A component container: a C++ program that its components are linked into."""

    components: tuple[Component, ...]


@dataclass(frozen=True)
class Prebuilt:
    """A C++ program from an archive, which is at a URL or below the site's folder.

    `sha256` is the expected hash of the archive; `package` and `executable` choose one of its
    programs. All three may be empty. `location` and `key` say where the author wrote it.
    """

    source: str | Path
    sha256: str
    package: str
    executable: str
    location: Location
    key: str


@dataclass(frozen=True)
class Ros2wasm:
    """A program compiled by the ROS2WASM project: its worker script and the files it loads.

    `types` maps the names of its topics and services to interfaces: `package/msg/Name` or
    `package/srv/Name`.
    """

    script: Path
    files: tuple[Path, ...]
    types: Mapping[str, str]


# The kinds of nodes. The configuration decides once which kind a node is.
Kind = Cpp | Python | Container | Prebuilt | Ros2wasm


@dataclass(frozen=True)
class Node:
    """A node of a page: an executable and how it is started.

    A ROS2WASM program has no package and no executable; a prebuilt program gets them when its
    archive has been read. Python nodes with the same `group` share an interpreter. `needs` names
    the nodes without which it only waits. `urdf` is the file with the robot description among its
    `parameters`.
    """

    name: str
    package: str
    executable: str
    location: Location
    namespace: str = ""
    remap: Mapping[str, str] = field(default_factory=dict)
    parameters: Mapping[str, str] = field(default_factory=dict)
    arguments: tuple[str, ...] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    group: str = ""
    needs: tuple[str, ...] = ()
    urdf: Path | None = None
    kind: Kind = Cpp()

    @property
    def program(self) -> tuple[str, ...]:
        """A key that identifies the program; nodes with the same key share one program."""
        if isinstance(self.kind, Ros2wasm):
            types = (f"{name} {kind}" for name, kind in sorted(self.kind.types.items()))
            return ("ros2wasm", str(self.kind.script), *types)
        return (self.package, self.executable)

    def command_line(self) -> list[str]:
        """Return the arguments that `ros2 run` would be given for this node."""
        rules = [f"{old}:={new}" for old, new in self.remap.items()]
        if self.namespace:
            rules.append(f"__ns:={self.namespace}")
        ros = [word for rule in rules for word in ("-r", rule)]
        for name, value in self.parameters.items():
            ros += ["-p", f"{name}:={value}"]
        own = [*self.arguments, *(["--ros-args", *ros] if ros else [])]
        components = self.kind.components if isinstance(self.kind, Container) else ()
        return [*own, *(word for component in components for word in component.words)]
