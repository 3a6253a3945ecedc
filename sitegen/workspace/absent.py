"""Find the ROS packages that a package requires and that neither workspace nor sitegen has."""

from __future__ import annotations

import re
from collections.abc import Collection
from functools import cache

from sitegen.errors import Problems
from sitegen.model import Package
from sitegen.shipped import CLIENTS, INTERFACES, PACKAGES, ROS
from sitegen.workspace import cmakelists, libraries
from sitegen.workspace.manifest import read_manifest
from sitegen.workspace.repositories import repository

CATKIN = "catkin"
# The tags whose packages ament_auto_find_build_dependencies() finds.
BUILT_WITH = ("depend", "build_depend")
# Packages that programs are compiled without: of Python, of tools and of the middleware.
NO_HEADERS = re.compile(
    r"ament_.*|launch.*|rclpy|ros2.*|rosidl_.*|rmw_.*|rviz2|.*_(py|python|tools)"
)
NO_BUILD = "which has no build for the page"
NOT_HERE = "which is not in the workspace"


def absent(package: Package, workspace: Collection[str]) -> list[str]:
    """Return the names of packages without which `package` cannot be configured and compiled.

    `workspace` are the names of the packages of the workspace. Only dependencies that package.xml
    names are considered: CMake may find other ones on the computer of the author.
    """
    file = package.path / "CMakeLists.txt"
    # Packages of ROS 1 need those of ROS 1, which no page has.
    if not file.is_file() or package.build_type == CATKIN:
        return []
    known = {*workspace, *_available(), package.name}
    listing = cmakelists.read(file, package.name, package.settings)
    required = [each for each in listing.requires if each in package.depends]
    if listing.finds_all:
        named = (each for each in _built_with(package) if not NO_HEADERS.fullmatch(each))
        required += [each for each in named if repository(each)]
    return [each for each in dict.fromkeys(required) if each not in known]


def _built_with(package: Package) -> list[str]:
    """Return what package.xml says a package is compiled with."""
    manifest = read_manifest(package.path / "package.xml", Problems(package.path))
    return [name for tag, name in manifest.tags if tag in BUILT_WITH] if manifest else []


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
