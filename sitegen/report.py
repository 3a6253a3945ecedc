"""Tell the author what happens during a build."""

from __future__ import annotations

import sys
import threading
from pathlib import Path
from typing import TextIO


class Report:
    """Writes lines; on a terminal, it keeps one live line for each thing under way."""

    def __init__(self, out: TextIO = sys.stdout) -> None:
        self._out = out
        self.said: list[str] = []
        self._live: dict[str, str] = {}
        self._drawn = 0
        self._lock = threading.Lock()

    def say(self, line: str) -> None:
        """Write a line that stays."""
        with self._lock:
            self.said.append(line)
            self._erase()
            print(line, file=self._out, flush=True)
            self._draw()

    def doing(self, name: str, what: str) -> None:
        """Show that `name` is at `what` now; replaces what was shown for it."""
        with self._lock:
            self._live[name] = what
            if self._out.isatty():
                self._erase()
                self._draw()
            else:
                print(f"{name}: {what}", file=self._out, flush=True)

    def done(self, name: str) -> None:
        """Take away the live line of `name`."""
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
    """Write a number of bytes as a person would."""
    return f"{count / 1000:.0f} kB" if count < 1_000_000 else f"{count / 1_000_000:.1f} MB"


def count(number: int, noun: str) -> str:
    """Write `number` of `noun`."""
    return f"{number} {noun}{'s'[: number != 1]}"


def shown(folder: Path) -> str:
    """Write a path as one would type it in the current folder."""
    here = Path.cwd()
    path = folder.resolve()
    return f"{path.relative_to(here)}" if path.is_relative_to(here) and path != here else str(path)
