"""Report the progress of a build."""

from __future__ import annotations

import os
import re
import shutil
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Literal, TextIO

Style = Literal["", "good", "bad", "warning", "weak", "strong"]
CODES = {"good": "32", "bad": "31", "warning": "33", "weak": "2", "strong": "1"}
# A terminal shows at most this many tasks in progress, and the number of the others.
LIVE = 8


class Report:
    """Writes lines; on a terminal, each task in progress has a line that changes."""

    def __init__(self, out: TextIO = sys.stdout, *, colour: bool = False) -> None:
        self._out = out
        self._colour = colour
        self.said: list[str] = []
        self._live: dict[str, str] = {}
        self._drawn = 0
        self._lock = threading.Lock()

    def say(self, line: str, style: Style = "") -> None:
        """Write a permanent line, which a build that finds nothing changed repeats."""
        self.said.append(line)
        self.say_once(line, style)

    def say_once(self, line: str, style: Style = "") -> None:
        """Write a permanent line about this build only."""
        with self._lock:
            self._erase()
            print(paint(line, style, colour=self._colour), file=self._out, flush=True)
            self._draw()

    def show(self, picture: str) -> None:
        """Write a picture of characters, on a terminal only."""
        try:
            picture.encode(self._out.encoding or "utf-8")
        except UnicodeEncodeError:
            return
        if self._moves:
            self.say_once(picture)

    def doing(self, name: str, what: str) -> None:
        """Show that `name` is now at the step `what`."""
        with self._lock:
            self._live[name] = what
            if self._moves:
                self._erase()
                self._draw()
            else:
                print(f"{name}: {what}", file=self._out, flush=True)

    def showing(self, name: str, what: str) -> None:
        """Show on a terminal that `name` is now at the step `what`; say nothing elsewhere."""
        if self._moves:
            self.doing(name, what)

    @contextmanager
    def during(self, name: str, what: str) -> Iterator[None]:
        """Show a step on a terminal while the body of a `with` statement runs."""
        self.showing(name, what)
        try:
            yield
        finally:
            self.done(name)

    def done(self, name: str) -> None:
        """Remove the line of the task `name`."""
        with self._lock:
            self._erase()
            self._live.pop(name, None)
            self._draw()

    @property
    def _moves(self) -> bool:
        """Whether the output is a terminal on which lines can change."""
        return self._out.isatty() and os.environ.get("TERM") != "dumb"

    def _erase(self) -> None:
        if self._drawn:
            self._out.write(f"\x1b[{self._drawn}A\x1b[J")
            self._drawn = 0

    def _draw(self) -> None:
        if not self._moves:
            return
        lines = [f"  {name}: {what}" for name, what in self._live.items()]
        if len(lines) > LIVE:
            lines[LIVE:] = [f"  … and {len(lines) - LIVE} more"]
        # Erasing a line that wraps would leave half of it.
        width = shutil.get_terminal_size().columns - 1
        for line in lines:
            self._out.write(paint(line[:width], "weak", colour=self._colour) + "\n")
        self._drawn = len(lines)
        self._out.flush()


def wants_colour(mode: str, out: TextIO) -> bool:
    """Return whether to write colours to `out`; `mode` is auto, always or never."""
    if mode != "auto":
        return mode == "always"
    # https://no-color.org: any value but the empty one.
    return out.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def paint(text: str, style: Style, *, colour: bool) -> str:
    """Return `text` with the terminal codes for `style`, or unchanged without `colour`."""
    return f"\x1b[{CODES[style]}m{text}\x1b[0m" if colour and style else text


def painted_problem(line: str, style: Style, *, colour: bool) -> str:
    """Return a problem with its file and line in `style`, the rest unchanged."""
    place = re.match(r"[^\s:]+(:\d+)?:(?=\s)", line)
    if not place:
        return line
    return paint(place[0], style, colour=colour) + line[place.end() :]


def size(count: int) -> str:
    """Return a number of bytes as text: "12 kB" or "3.4 MB"."""
    return f"{count / 1000:.0f} kB" if count < 1_000_000 else f"{count / 1_000_000:.1f} MB"


def count(number: int, noun: str) -> str:
    """Return a number and its noun, plural unless the number is one: "2 pages"."""
    return f"{number} {noun}{'s'[: number != 1]}"


def shown(folder: Path) -> str:
    """Return a path relative to the current folder if it is below it, else the whole path."""
    here = Path.cwd()
    path = folder.resolve()
    return f"{path.relative_to(here)}" if path.is_relative_to(here) and path != here else str(path)
