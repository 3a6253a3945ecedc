"""Describe ROS2WASM programs for page.json."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitegen.interfaces import messages
from sitegen.interfaces.descriptions import described
from sitegen.model import Artifact, Node, Ros2wasm, Site

# The page publishes the log of such a program on /rosout.
LOG = "rcl_interfaces/msg/Log"


@dataclass(frozen=True)
class Ros2wasmProgram:
    """A ROS2WASM program: `root` is the site's folder, `messages` the types that it uses."""

    program: Ros2wasm
    root: Path
    messages: Mapping[str, object]

    worker = "ros2wasm/ros2wasmNode"
    written_in = "ROS2WASM"
    fault = ""

    @property
    def name(self) -> str:
        """Return its script, relative to the site's folder."""
        return self.program.script.relative_to(self.root).as_posix()

    @property
    def files(self) -> Sequence[Artifact]:
        """Return its files at unchanged paths, because they refer to each other."""
        return [Artifact(self._path(file), file) for file in self.program.files]

    @property
    def sizes(self) -> Mapping[str, Mapping[str, int]]:
        """Return the size of its files."""
        return {"": {self._path(file): file.stat().st_size for file in self.program.files}}

    def types(self, node: Node) -> Mapping[str, object]:
        """Return the message types that the author names."""
        return self.messages

    def entry(self, node: Node, link: Callable[[str], str]) -> dict[str, object]:
        """Return the NodeEntry of `node`, with the URL of its script."""
        return {
            "package": "ros2wasm",
            "executable": self.program.script.name,
            "arguments": [],
            "ros2wasm": {
                "script": link(self._path(self.program.script)),
                "topics": dict(self.program.types),
                "types": self.messages,
            },
        }

    def _path(self, file: Path) -> str:
        return f"ros2wasm/{file.relative_to(self.root).as_posix()}"


def ros2wasm_programs(
    site: Site, nodes: Sequence[Node], *, cache: Path
) -> dict[tuple[str, ...], Ros2wasmProgram]:
    """Return the programs among `nodes` that the ROS2WASM project compiled.

    Raises: SiteError if interface definitions of the workspace are wrong.
    """
    found = {node.program: node.kind for node in nodes if isinstance(node.kind, Ros2wasm)}
    if not found:
        return {}
    packages = {name.partition("/")[0] for one in found.values() for name in one.types.values()}
    prefixes = [described(site, sorted(packages), cache=cache)]
    return {
        program: Ros2wasmProgram(one, site.root, messages.types(_parts(one), prefixes))
        for program, one in found.items()
    }


def _parts(program: Ros2wasm) -> Iterator[str]:
    """Yield the message types of the topics and services of `program`."""
    yield LOG
    for name in program.types.values():
        parts = ("_Request", "_Response") if "/srv/" in name else ("",)
        yield from (f"{name}{part}" for part in parts)
