"""Find the ROS packages that a package requires and that neither workspace nor sitegen has."""

from __future__ import annotations

from collections.abc import Collection
from functools import cache

from sitegen.model import Package
from sitegen.shipped import CLIENTS, INTERFACES, PACKAGES, ROS
from sitegen.workspace import cmakelists, libraries
from sitegen.workspace.repositories import repository

NO_BUILD = "which has no build for the page"
NOT_HERE = "which is not in the workspace"


def absent(package: Package, workspace: Collection[str]) -> list[str]:
    """Return the names of packages without which CMake cannot configure `package`.

    `workspace` are the names of the packages of the workspace. Only dependencies that package.xml
    names are considered: CMake may find other ones on the computer of the author.
    """
    file = package.path / "CMakeLists.txt"
    if not file.is_file():
        return []
    known = {*workspace, *_available(), package.name}
    required = cmakelists.read(file, package.name, package.settings).requires
    return [
        each for each in dict.fromkeys(required) if each in package.depends and each not in known
    ]


def clone(name: str) -> str:
    """Return the end of a message about a package that is absent."""
    known = repository(name)
    how = f": {known.command}" if known else ""
    return f"{NOT_HERE}; clone its sources there{how}"


def without(library: libraries.Library) -> str:
    """Return the end of a message about a library that is absent."""
    return f"which is not installed ({library.install})" if library.install else NO_BUILD


@cache
def _available() -> frozenset[str]:
    folders = (CLIENTS / "cpp" / "share", INTERFACES, PACKAGES, ROS / "include")
    packages = (path.name for folder in folders for path in folder.iterdir())
    return frozenset([*packages, *libraries.PACKAGES])
