"""Publish the files that packages install to share/: compiled programs load them on opening.

Python programs have those of their packages in their archives.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from sitegen import workspace
from sitegen.launch.shares import PREFIX
from sitegen.model import Artifact, Build, Container, Node, Package, Site

# What names a package in the arguments of a node: its folder in the page, or the URL of a file.
NAMED = re.compile(rf"(?:{PREFIX}/share/|package://)([A-Za-z]\w*)")
# In the scripts of programs that look for files: the functions by which they do, and the one that
# gives the page their file system (clients/cpp/src/platform/host_pre.js).
LOOKS = re.compile(rb"___syscall_(open|stat64|lstat64|fstatat64|access|faccessat|chdir)")
FILES = b"rosFiles"
# The files that views load, and that programs hardly ever read.
MESHES = (".stl", ".dae", ".obj", ".gltf", ".glb")


@dataclass(frozen=True)
class Share:
    """The files that the compiled programs of a site can open, by their path below `/ros`."""

    files: Mapping[str, Path]

    @cached_property
    def listing(self) -> Artifact:
        """The list that programs load: the size in bytes and the hash of each file, by path."""
        found = {}
        for path, file in sorted(self.files.items()):
            content = file.read_bytes()
            found[path] = (len(content), hashlib.sha256(content).hexdigest()[:10])
        text = json.dumps(found, separators=(",", ":"), ensure_ascii=False).encode()
        # The hash changes the URL with the files, so that browsers can cache it forever.
        return Artifact(f"nodes/share-{hashlib.sha256(text).hexdigest()[:10]}.json", text)

    @cached_property
    def artifacts(self) -> Sequence[Artifact]:
        """The list and the files; their paths are relative to the list."""
        files = (Artifact(_published(path), file) for path, file in self.files.items())
        return [self.listing, *files]


def listed(listing: bytes) -> list[str]:
    """Return the paths in `dist/` of the files on a list of Share."""
    return [_published(path) for path in json.loads(listing)]


def _published(path: str) -> str:
    # A package may bring anything. By this name, no server takes it for a page or a setting.
    return f"nodes/{path}.bin"


def opens_files(builds: Sequence[Build]) -> bool:
    """Return whether a program, in any of its builds, looks for files."""
    scripts = (build.script.read_bytes() for build in builds)
    return any(FILES in script and LOOKS.search(script) for script in scripts)


def share_of(
    site: Site, programs: Collection[tuple[str, ...]], prebuilt: Mapping[str, Path]
) -> Share:
    """Return the files of the packages that the nodes which run `programs` may read.

    These are their own packages, those that their arguments name, that of the launch file, and all
    that these depend on. `prebuilt` are the files that came with programs from archives.
    """
    names: dict[str, None] = {}
    for page in site.pages:
        nodes = [node for node in page.nodes.values() if node.program in programs]
        if nodes and page.launch:
            names[page.launch.package] = None
        for node in nodes:
            names |= dict.fromkeys([node.package, *_components(node), *named(node)])
    return Share({**prebuilt, **files_of(site.packages, names)})


def files_of(packages: Mapping[str, Package], names: Iterable[str]) -> Mapping[str, Path]:
    """Return the files below `share/` of packages and of all that these depend on, by path."""
    needs = (need for name in names for need in workspace.with_dependencies(packages, name))
    return {path: file for need in needs for path, file in need.share.items()}


def named(node: Node) -> list[str]:
    """Return the packages that the arguments and the environment of a node name."""
    texts = [*node.command_line(), *node.environment.values()]
    return sorted({name for text in texts for name in NAMED.findall(text)})


def _components(node: Node) -> Iterator[str]:
    if isinstance(node.kind, Container):
        yield from (component.package for component in node.kind.components)
