"""What a terminal needs to launch the launch file of a page with other arguments.

The page reads the file anew, with the Python modules that read it for the build; see
launch/again.py.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import xacro
import yaml

from sitegen import shipped, workspace
from sitegen.ignored import TOOLS
from sitegen.launch.shares import shares
from sitegen.model import Artifact, Launch, Package, Page, Site, Widget
from sitegen.nodes.python.wheel import archived

# The modules that launch/again.py imports, in the folder of sitegen.
MODULES = (
    *("__init__.py", "errors.py", "ignored.py", "pagepath.py", "rclyaml.py", "shipped.py"),
    *("yamlnodes.py", "launch/*.py", "model/*.py", "workspace/*.py"),
)
# What launch files read: other launch files, parameters, and descriptions of robots.
READ = {".launch", ".py", ".srdf", ".txt", ".urdf", ".xacro", ".xml", ".yaml", ".yml"}
# The folders of a package whose files they do not read.
SOURCES = {"build", "include", "meshes", "src", "test"}
# Longer ones are data, in bytes.
LONGEST = 1_000_000
WORD = re.compile(rb"[A-Za-z]\w+")


@dataclass(frozen=True)
class Reading:
    """The two archives that a page unpacks to read its launch file: the reader, and the files."""

    reader: Artifact
    files: Artifact


def reading(site: Site, page: Page) -> Reading | None:
    """Return what reads the launch file of a page, if visitors can launch it with arguments."""
    if not page.launch or not reads(page):
        return None
    return Reading(_artifact(_reader()), _artifact(archived(_files(page.launch, site))))


def reads(page: Page) -> bool:
    """Return whether visitors of a page can launch its launch file with other arguments."""
    kinds = {part.kind for part in page.leaves if isinstance(part, Widget)}
    launch = page.launch
    return bool(launch and launch.arguments and launch.path and "terminal" in kinds)


def _artifact(content: bytes) -> Artifact:
    return Artifact(f"nodes/launch-{hashlib.sha256(content).hexdigest()[:10]}.zip", content)


@cache
def _reader() -> bytes:
    """Return the modules of the reader; those of libraries are plain Python, too."""
    found = {
        f"python/sitegen/{file.relative_to(shipped.PACKAGE).as_posix()}": file.read_bytes()
        for pattern in MODULES
        for file in shipped.PACKAGE.glob(pattern)
    }
    for library in (xacro, yaml):
        folder = Path(str(library.__file__)).parent
        for file in folder.glob("*.py"):
            found[f"python/{folder.name}/{file.name}"] = file.read_bytes()
    return archived(found)


def _files(launch: Launch, site: Site) -> Mapping[str, bytes]:
    """Return the files of the launch file's package, and of those that these files name."""
    packages = {**workspace.shipped_packages(), **site.packages}
    found: dict[str, bytes] = {}
    with shares(packages) as folders:
        waiting, seen = [launch.package], {launch.package}
        while waiting:
            name = waiting.pop()
            for path, content in _read(packages[name], folders[name]):
                found[f"share/{name}/{path}"] = content
                named = {word.decode() for word in WORD.findall(content)} & packages.keys() - seen
                waiting += sorted(named)
                seen |= named
    return found


def _read(package: Package, folder: Path) -> Iterator[tuple[str, bytes]]:
    """Yield the files of a package that launch files may read, by path in its share folder."""
    yield "package.xml", (package.path / "package.xml").read_bytes()
    for here, below, names in os.walk(folder, followlinks=True):
        at_top = Path(here) == folder
        below[:] = sorted(
            each
            for each in below
            if each not in TOOLS and not each.startswith(".") and not (at_top and each in SOURCES)
        )
        for name in sorted(names):
            file = Path(here) / name
            if at_top or file.suffix not in READ or file.stat().st_size > LONGEST:
                continue
            yield file.relative_to(folder).as_posix(), file.read_bytes()
