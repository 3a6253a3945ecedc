"""The keyboard of programs: what a visitor types in their consoles."""

from __future__ import annotations

import io
import os
import select
import termios
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any, TextIO

from rclpy_backend.system import turns
from rclpy_backend.system.blocking import wait

STDIN = 0
# What would be read there is not what a visitor types. Without it, programs read from STDIN.
TERMINAL = Path("/dev/tty")
# How a terminal is set when a program starts, as termios.tcgetattr() gives it: four numbers, two
# speeds, and its special characters.
LOCAL = 3
ATTRIBUTES = [termios.ICRNL, 0, 0, termios.ICANON | termios.ECHO | termios.ISIG, 0, 0]
CHARACTERS = 32

_read = os.read
_select = select.select


class Keyboard(io.RawIOBase):
    """What is typed for `program`, as a stream of bytes."""

    def __init__(self, program: turns.Program) -> None:
        self._program = program
        # What came and was not read; an empty piece is the end.
        self._typed: list[bytes] = []
        self.attributes: list[Any] = [*ATTRIBUTES, [b"\0"] * CHARACTERS]
        self._told = ""

    def readable(self) -> bool:
        """Return that it can be read from."""
        return True

    def isatty(self) -> bool:
        """Return that somebody types."""
        return True

    def fileno(self) -> int:
        """Return what the system would read from."""
        return STDIN

    def readinto(self, buffer: Any) -> int:
        """Wait for what somebody types."""
        for output in self._program.outputs:
            output.end()  # a question has no end of line
        self.look(None)
        first = self._typed.pop(0)
        taken = min(len(first), len(buffer))
        buffer[:taken] = first[:taken]
        if taken < len(first):
            self._typed.insert(0, first[taken:])
        return taken

    def look(self, seconds: float | None) -> bool:
        """Wait until something was typed, at most so long; return whether something was."""
        end = None if seconds is None else time.monotonic() + seconds
        if not self._take():
            self._tell(anew=seconds is None)
        while not self._take():
            left = None if end is None else end - time.monotonic()
            # Who looks again and again lets the page go on.
            wait(None if left is None else max(left, 0))
            if left is not None and left <= 0:
                return self._take()
        return True

    def _take(self) -> bool:
        while (typed := self._program.host.typed()) is not None:
            if typed.op != "complete":  # a prompt has its lines without an end
                text = typed.text if typed.op == "keys" else f"{typed.text}\n"
                self._typed.append(text.encode())
        return bool(self._typed)

    def _tell(self, *, anew: bool) -> None:
        local = self.attributes[LOCAL]
        if local & termios.ICANON:
            how = "lines" if local & termios.ECHO else "hidden"
        else:
            how = "keys" if local & termios.ISIG else "raw"
        if anew or how != self._told:
            self._told = how
            self._program.host.reading(how)


def opened(program: turns.Program) -> TextIO:
    """Return a program's standard input."""
    program.keyboard = Keyboard(program)
    return io.TextIOWrapper(io.BufferedReader(program.keyboard), "utf-8")


def install() -> None:
    """Let programs set their terminal, and look whether there is something to read."""
    replaced = {
        "tcgetattr": lambda _: [*_mine().attributes[:-1], list(_mine().attributes[-1])],
        "tcsetattr": lambda _, __, attributes: _set(attributes),
        **dict.fromkeys(("tcflush", "tcdrain"), lambda *_: None),
    }
    for name, replacement in replaced.items():
        setattr(termios, name, replacement)
    os.read = _bytes
    select.select = _look  # type: ignore[assignment]
    TERMINAL.unlink(missing_ok=True)


def _mine() -> Keyboard:
    mine: Keyboard = turns.running().keyboard
    return mine


def _set(attributes: list[Any]) -> None:
    _mine().attributes = list(attributes)


def _bytes(file: int, size: int) -> bytes:
    """Stand in for os.read()."""
    if file != STDIN:
        return _read(file, size)
    buffer = bytearray(size)
    return bytes(buffer[: _mine().readinto(buffer)])


def _look(
    readers: Sequence[Any],
    writers: Sequence[Any],
    others: Sequence[Any],
    timeout: float | None = None,
) -> tuple[list[Any], list[Any], list[Any]]:
    """Stand in for select.select()."""
    keys = [one for one in readers if _number(one) == STDIN]
    if not keys or len(keys) < len(readers) or writers or others:
        rest = [one for one in readers if one not in keys]
        return _select(rest, writers, others, timeout)
    return (keys if _mine().look(timeout) else []), [], []


def _number(one: Any) -> int:
    return one if isinstance(one, int) else int(one.fileno())
