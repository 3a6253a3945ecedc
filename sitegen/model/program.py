"""Programs that are ready to be served, and the files of a site."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from sitegen.model.node import Node


@dataclass(frozen=True)
class Artifact:
    """One file of the site: its path inside `dist/` and where its bytes come from."""

    path: str
    source: Path | bytes

    @property
    def size(self) -> int:
        """Its number of bytes."""
        source = self.source
        return len(source) if isinstance(source, bytes) else source.stat().st_size


# The names of engines in messages.
BROWSERS = {"jspi": "current browsers", "asyncify": "all browsers"}


@dataclass(frozen=True)
class Build:
    """One compiled form of a node: an ES module and its WebAssembly, for one engine.

    `types` is a file with the message types that it uses, by name (MessageType in protocol.js);
    `lines` is a file that maps its code to source lines, or None if it was built without.
    """

    engine: str
    script: Path
    wasm: Path
    types: Path
    lines: Path | None = None


class Program(Protocol):
    """A program that is ready to be served; each kind of node has a class that implements this."""

    @property
    def name(self) -> str:
        """Its name in messages and summaries."""

    @property
    def worker(self) -> str:
        """The worker script of the runtime that runs it, a module below `runtime/workers/`."""

    @property
    def files(self) -> Sequence[Artifact]:
        """The files that it needs in `dist/`; programs may share files."""

    @property
    def written_in(self) -> str:
        """For people: "C++", "Python" or "ROS2WASM"."""

    @property
    def fault(self) -> str:
        """Why it cannot start, in one line; "" if it can."""

    @property
    def sizes(self) -> Mapping[str, Mapping[str, int]]:
        """The sizes of its large files in bytes, by engine and path; "" stands for all engines."""

    def types(self, node: Node) -> Mapping[str, object]:
        """Return the message types that it uses as `node`, by name (MessageType in protocol.js)."""

    def entry(self, node: Node, link: Callable[[str], str]) -> dict[str, object]:
        """Return the description of `node` in page.json (NodeEntry in protocol.js).

        `link` turns a path inside `dist/` into a URL.
        """


# By the key that Node.program returns.
Programs = Mapping[tuple[str, ...], Program]
