"""Find the program of the workspace that a command line in a launch file runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

RUN = ["ros2", "run"]


@dataclass(frozen=True)
class Program:
    """A program of a package and its arguments."""

    package: str
    executable: str
    words: list[str]


def program(words: list[str], folders: Mapping[str, Path]) -> Program | None:
    """Return the program that the command line `words` runs, None if no package has it.

    The command line uses `ros2 run`, or the path at which the package would be installed.
    """
    if words[:2] == RUN and len(words) >= 4:
        return Program(words[2], words[3], words[4:])
    path = Path(words[0]) if words else Path()
    package = path.parent.name
    if package in folders and path == installed(folders[package], package, path.name):
        return Program(package, path.name, words[1:])
    return None


def installed(folder: Path, package: str, executable: str) -> Path:
    """Return the path of an executable below `folder`, which stands for the package's prefix."""
    return folder / "lib" / package / executable
