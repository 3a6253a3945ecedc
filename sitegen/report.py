"""Turn the progress of a build into lines for its author."""

from __future__ import annotations

import sys
import threading
from pathlib import Path
from typing import TextIO


class Report:
    """Writes lines; on a terminal, one live line for each task in progress."""

    def __init__(self, out: TextIO = sys.stdout) -> None:
        self._out = out
        self.said: list[str] = []
        self._live: dict[str, str] = {}
        self._drawn = 0
        self._lock = threading.Lock()

    def say(self, line: str) -> None:
        """Write a permanent line."""
        with self._lock:
            self.said.append(line)
            self._erase()
            print(line, file=self._out, flush=True)
            self._draw()

    def doing(self, name: str, what: str) -> None:
        """Show that `name` is now doing `what`, in place of its last live line."""
        with self._lock:
            self._live[name] = what
            if self._out.isatty():
                self._erase()
                self._draw()
            else:
                print(f"{name}: {what}", file=self._out, flush=True)

    def done(self, name: str) -> None:
        """Remove the live line of `name`."""
        with self._lock:
            self._erase()
            self._live.pop(name, None)
            self._draw()

    def _erase(self) -> None:
        if self._drawn:
            self._out.write(f"\x1b[{self._drawn}A\x1b[J")
            self._drawn = 0

    def _draw(self) -> None:
        if self._out.isatty():
            for name, what in self._live.items():
                self._out.write(f"  {name}: {what}\n")
            self._drawn = len(self._live)
            self._out.flush()


def size(count: int) -> str:
    """Return a number of bytes for people: "12 kB" or "3.4 MB"."""
    return f"{count / 1000:.0f} kB" if count < 1_000_000 else f"{count / 1_000_000:.1f} MB"


def count(number: int, noun: str) -> str:
    """Return a number and its noun, in the plural unless it is one: "2 pages"."""
    return f"{number} {noun}{'s'[: number != 1]}"


def shown(folder: Path) -> str:
    """Return a path relative to the current folder if it is below it, else the whole path."""
    here = Path.cwd()
    path = folder.resolve()
    return f"{path.relative_to(here)}" if path.is_relative_to(here) and path != here else str(path)
