"""Describe a Python program for page.json."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from sitegen.model import Artifact, Node
from sitegen.nodes.python.missing import Missing
from sitegen.nodes.python.pyodide import download_size


@dataclass(frozen=True)
class Archive:
    """An archive that pages unpack: its path inside `dist/` and its bytes."""

    path: str
    data: bytes

    @cached_property
    def version(self) -> str:
        """Return a digest of the archive."""
        return hashlib.sha256(self.data).hexdigest()[:10]


@dataclass(frozen=True)
class PythonProgram:
    """A Python program.

    `target` is its entry point ("module:function") or the path of its script; `archives` are
    unpacked in this order; `modules` names the modules of the workspace in them; `messages` are the
    message types that it may use. With modules that are `missing`, it is on its page and cannot
    start.
    """

    package: str
    executable: str
    target: str
    archives: Sequence[Archive]
    modules: Sequence[str]
    messages: Mapping[str, object]
    missing: Missing = field(default_factory=dict)

    worker = "python/pythonNode"
    written_in = "Python"

    @property
    def name(self) -> str:
        """Return its name as `ros2 run` takes it."""
        return f"{self.package}/{self.executable}"

    @property
    def fault(self) -> str:
        """Return where it imports the first module that is missing, and what to do."""
        return next((f"{place}: {message}" for message, place in self.missing.items()), "")

    @property
    def files(self) -> Sequence[Artifact]:
        """Return its archives."""
        return [Artifact(archive.path, archive.data) for archive in self.archives]

    @property
    def sizes(self) -> Mapping[str, Mapping[str, int]]:
        """Return the size of its archives."""
        return {"": {archive.path: len(archive.data) for archive in self.archives}}

    @property
    def _archived(self) -> int:
        return sum(len(archive.data) for archive in self.archives)

    def types(self, node: Node) -> Mapping[str, object]:
        """Return the message types that its modules import."""
        return self.messages

    def entry(self, node: Node, link: Callable[[str], str]) -> dict[str, object]:
        """Return the NodeEntry of `node`, with the URLs of its archives or the fault."""
        module, _, attribute = self.target.partition(":")
        python = {
            # The digest changes the URL with the archive, so that browsers can cache it forever.
            "bundles": [f"{link(one.path)}?v={one.version}" for one in self.archives],
            "size": download_size() + self._archived,
            "module": module,
            "attribute": attribute,
            "own": list(self.modules),
            **({"group": node.group} if node.group else {}),
        }
        return {
            "package": self.package,
            "executable": self.executable,
            "arguments": node.command_line(),
            **({"environment": dict(node.environment)} if node.environment else {}),
            **({"fault": self.fault} if self.fault else {"python": python}),
        }
