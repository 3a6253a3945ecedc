"""Describe a C++ program for page.json."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from sitegen.cache.digest import digest_of
from sitegen.model import Artifact, Build, Node
from sitegen.nodes.share import Share


@dataclass(frozen=True)
class CppProgram:
    """A C++ program, compiled here or elsewhere.

    `builds` has one build for each of `engines`, or is empty if the programs were only checked.
    With a `fault`, which says why it did not compile, it is on its page and cannot start.
    `licences` are those of libraries, which the site contains; `share` are the files of packages,
    if it opens any.
    """

    package: str
    executable: str
    engines: Sequence[str]
    builds: Sequence[Build] = ()
    fault: str = ""
    licences: Sequence[Artifact] = ()
    share: Share | None = None

    worker = "cpp/cppNode"
    written_in = "C++"

    @property
    def name(self) -> str:
        """Return its name as `ros2 run` takes it."""
        return f"{self.package}/{self.executable}"

    @cached_property
    def files(self) -> Sequence[Artifact]:
        """Return the module, the WebAssembly and, with `debug`, the source lines of each build."""
        artifacts = [*self.licences, *(self.share.artifacts if self.share else ())]
        for build in self.builds:
            stem = self._stem(build.engine)
            artifacts.append(Artifact(f"{stem}.js", build.script))
            artifacts.append(Artifact(f"{stem}.wasm", build.wasm))
            if build.lines:
                artifacts.append(Artifact(f"{stem}.lines.json", build.lines))
        return artifacts

    @property
    def sizes(self) -> Mapping[str, Mapping[str, int]]:
        """Return the size of its WebAssembly for each engine."""
        return {
            build.engine: {f"{self._stem(build.engine)}.wasm": build.wasm.stat().st_size}
            for build in self.builds
        }

    def types(self, node: Node) -> Mapping[str, object]:
        """Return the message types that its WebAssembly names."""
        if not self.builds:
            return {}
        found: dict[str, object] = json.loads(self.builds[0].types.read_text())
        return found

    def entry(self, node: Node, link: Callable[[str], str]) -> dict[str, object]:
        """Return the NodeEntry of `node`, with the URLs of each build or the fault."""
        builds = {engine: self._addresses(engine, link) for engine in self.engines}
        return {
            "package": self.package,
            "executable": self.executable,
            "arguments": node.command_line(),
            **({"environment": dict(node.environment)} if node.environment else {}),
            **({"share": link(self.share.listing.path)} if self.share else {}),
            **({"fault": self.fault} if self.fault else {"builds": builds}),
        }

    def _addresses(self, engine: str, link: Callable[[str], str]) -> dict[str, str]:
        stem = link(self._stem(engine))
        version, has_lines = self._versions.get(engine, ("", False))
        # The hash changes the URL with the program, so that browsers can cache it forever.
        query = f"?v={version}" if version else ""
        found = {"script": f"{stem}.js{query}", "wasm": f"{stem}.wasm{query}"}
        return found | ({"lines": f"{stem}.lines.json{query}"} if has_lines else {})

    @cached_property
    def _versions(self) -> dict[str, tuple[str, bool]]:
        return {
            build.engine: (digest_of([build.script, build.wasm])[:10], build.lines is not None)
            for build in self.builds
        }

    def _stem(self, engine: str) -> str:
        return f"nodes/{self.package}/{self.executable}.{engine}"
