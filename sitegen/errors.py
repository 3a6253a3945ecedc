"""Report what is wrong with a site, one line for each problem."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Location:
    """A file and a line in it, counted from 1."""

    file: Path
    line: int


class SiteError(Exception):
    """The author made a mistake; each of `lines` is a complete message or the output of a tool."""

    def __init__(self, lines: list[str]) -> None:
        super().__init__("\n".join(lines))
        self.lines = lines


@dataclass
class Problems:
    """Collects problems; messages show paths relative to `root`."""

    root: Path
    found: list[tuple[str, int, str]] = field(default_factory=list)

    @property
    def lines(self) -> list[str]:
        """All problems as complete messages, ordered by file and line."""
        ordered = sorted(dict.fromkeys(self.found), key=lambda problem: problem[:2])
        return [f"{file}:{line}: {text}" for file, line, text in ordered]

    def add(self, location: Location, key: str, message: str) -> None:
        """Add a problem: `key`, written at `location`, is wrong as `message` says."""
        text = f"{key}: {message}".replace("\n", " ")
        self.found.append((relative(location.file, self.root), location.line, text))

    def where(self, location: Location) -> str:
        """Return `location` as text, for use inside a message."""
        return f"{relative(location.file, self.root)}:{location.line}"

    def raise_if_any(self) -> None:
        """Raise a SiteError with all problems, ordered by file and line, if there are any."""
        if self.found:
            raise SiteError(self.lines)


def relative(file: Path, root: Path) -> str:
    """Return the path of `file` relative to `root` if it is below it, else the whole path."""
    return file.relative_to(root).as_posix() if file.is_relative_to(root) else str(file)


def nearest(name: str, known: Iterable[str]) -> str:
    """Return the end of a message about an unknown name: the nearest known name, or all of them."""
    names = sorted(known)
    close = difflib.get_close_matches(name, names, n=1)
    if close:
        return f"did you mean '{close[0]}'?"
    return f"known: {', '.join(names)}" if names else "there are none"
