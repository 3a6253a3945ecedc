"""The packages of a workspace."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from sitegen.errors import Location


class Fault(NamedTuple):
    """A problem in the build files of a package; `hides` says whether it may hide a program."""

    location: Location
    key: str
    message: str
    hides: bool = True


@dataclass(frozen=True)
class Setup:
    """What a Python package installs.

    `scripts` maps the names of executables to entry points ("module:function") or to paths of
    programs. `files` maps paths below the prefix to files; modules are in `python/`. `faults` says
    where and why its build files cannot be read, and `notes` what is doubtful in them.
    """

    scripts: Mapping[str, str]
    files: Mapping[str, Path]
    faults: tuple[Fault, ...] = ()
    notes: tuple[Fault, ...] = ()


@dataclass(frozen=True)
class BuildSettings:
    """What CMake gets for one package: definitions (`-DNAME=value`) and environment variables.

    `location` is where site.yaml says so.
    """

    cmake: tuple[str, ...] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    location: Location | None = field(default=None, compare=False)

    @property
    def definitions(self) -> dict[str, str]:
        """Return the values of the definitions, by name and without types."""
        pairs = (one.removeprefix("-D").partition("=") for one in self.cmake)
        return {name.partition(":")[0]: value for name, _, value in pairs}

    @property
    def lines(self) -> list[str]:
        """Return all of them in lines, which identify the settings."""
        return [*self.cmake, *(f"{name}={value}" for name, value in self.environment.items())]


@dataclass(frozen=True)
class Package:
    """A ROS package of the workspace, as described by its `package.xml` and its build files.

    `executables` is None if only CMake can tell their names; `sources` maps executables to their
    source files, where these are known, and `libraries` to the source files of libraries of the
    package that they are linked to. `share` has the files that it installs to `share/`, by path
    below the prefix. `plugins` names the packages that it provides plugins for, and `linked` the
    packages whose plugins are linked into its programs. A `windowed` package needs Qt, which pages
    do not have. `settings` are those of its build.
    """

    name: str
    path: Path
    build_type: str
    depends: tuple[str, ...]
    executables: tuple[str, ...] | None
    interfaces: tuple[str, ...]
    version: str = ""
    description: str = ""
    sources: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    libraries: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    setup: Setup | None = None
    share: Mapping[str, Path] = field(default_factory=dict)
    plugins: tuple[str, ...] = ()
    linked: tuple[str, ...] = ()
    windowed: bool = False
    settings: BuildSettings = BuildSettings()
