"""What to compile, and what came of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sitegen.model import Artifact, Build, Package


@dataclass(frozen=True)
class Job:
    """What to compile: executables of one package, after the packages that it needs."""

    package: Package
    executables: tuple[str, ...]
    needs: tuple[Package, ...]


# By package and executable.
Builds = Mapping[tuple[str, str], Sequence[Build]]


@dataclass(frozen=True)
class Compiled:
    """The builds of the programs that compiled, and why the others did not, in one line each.

    `licences` are those of the libraries that the programs may contain.
    """

    builds: Builds
    faults: Mapping[tuple[str, str], str]
    licences: Sequence[Artifact] = ()
