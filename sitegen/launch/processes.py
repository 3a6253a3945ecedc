"""Turn the command line of a process that a launch file starts into a program of the workspace."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

RUN = ["ros2", "run"]


@dataclass(frozen=True)
class Program:
    """A program of a package, and what stands behind it on the command line."""

    package: str
    executable: str
    words: list[str]


def program(words: list[str], folders: Mapping[str, Path]) -> Program | None:
    """Return what a line of `words` runs, None if that is of no package of `folders`.

    It is run with `ros2 run`, or by the path where the package would install it.
    """
    if words[:2] == RUN and len(words) >= 4:
        return Program(words[2], words[3], words[4:])
    path = Path(words[0]) if words else Path()
    package = path.parent.name
    if package in folders and path == installed(folders[package], package, path.name):
        return Program(package, path.name, words[1:])
    return None


def installed(folder: Path, package: str, executable: str) -> Path:
    """Return the path of an executable where `folder` stands for the prefix of its package."""
    return folder / "lib" / package / executable
