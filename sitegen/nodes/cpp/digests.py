"""Identify what a C++ program is made from."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path

from sitegen.cache.digest import digest_of
from sitegen.model import Package
from sitegen.nodes.cpp.cmake import CLIENT
from sitegen.nodes.cpp.sources import LibrarySources
from sitegen.shipped import INTERFACES, PACKAGE, ROS

# What a program depends on besides its sources, the library and the compiler.
GENERATOR = (
    "interfaces/cheaders.py",
    "interfaces/definitions.py",
    "interfaces/generator.py",
    "interfaces/messages.py",
    "interfaces/rosidl.py",
    "interfaces/typesupport.py",
    "interfaces/values.py",
    "nodes/cpp/cmake.py",
    "nodes/cpp/flags.py",
    "nodes/cpp/libraries.py",
    "nodes/cpp/loadable.py",
    "nodes/cpp/objectfile.py",
    "nodes/cpp/precompiled.py",
    "nodes/cpp/repaired.py",
    "nodes/cpp/sourcemap.py",
    "workspace/libraries.py",
    "workspace/manifestcmake.py",
)


def sources() -> list[Path]:
    """Return the files and folders of sitegen that determine the result of a compilation."""
    return [CLIENT, *(PACKAGE / name for name in GENERATOR), ROS / ".digest", INTERFACES]


class Digests:
    """Digests of packages together with the packages that they need.

    `base` is that of the tools. Tools write folders of their own into `roots`, which are not
    sources of a package. If programs record source lines, these are relative to `root`.
    """

    def __init__(
        self,
        base: str,
        roots: Collection[Path],
        root: Path | None,
        sources: LibrarySources,
    ) -> None:
        self._base = base
        self._roots = roots
        self._root = root
        self._sources = sources
        self._found: dict[Path, str] = {}

    def of(self, package: Package, needs: Sequence[Package]) -> str:
        """Return the digest of `package` and its `needs`, whose sources are downloaded first."""
        all_of_them = [*sorted(needs, key=lambda need: need.name), package]
        places = ["lines", *map(self.shown, all_of_them)] if self._root else []
        return digest_of([], self._base, *map(self._of_one, all_of_them), *places)

    def _of_one(self, package: Package) -> str:
        if package.path not in self._found:
            folders = [package.path, *self._sources.of(package)]
            settings = package.settings.lines
            self._found[package.path] = digest_of(folders, *settings, roots=self._roots)
        return self._found[package.path]

    def shown(self, package: Package) -> str:
        """Return the path that programs show for a package's folder: its name without `root`."""
        if self._root and package.path.is_relative_to(self._root):
            return package.path.relative_to(self._root).as_posix()
        return package.name
