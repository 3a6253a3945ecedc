"""Standard input: the text that a visitor types in the console of a program."""

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
# Opening the terminal device would not read the console; without it, programs read from STDIN.
TERMINAL = Path("/dev/tty")
# Terminal attributes at the start of a program, as termios.tcgetattr() returns them: four flags,
# two speeds, and the control characters.
LOCAL = 3
ATTRIBUTES = [termios.ICRNL, 0, 0, termios.ICANON | termios.ECHO | termios.ISIG, 0, 0]
CHARACTERS = 32

_read = os.read
_select = select.select


class Keyboard(io.RawIOBase):
    """The input of `program`, as a stream of bytes."""

    def __init__(self, program: turns.Program) -> None:
        self._program = program
        # Input that has not been read; an empty piece is the end of input.
        self._typed: list[bytes] = []
        self.attributes: list[Any] = [*ATTRIBUTES, [b"\0"] * CHARACTERS]
        self._told = ""

    def readable(self) -> bool:
        """Return True."""
        return True

    def isatty(self) -> bool:
        """Return True: the console is a terminal."""
        return True

    def fileno(self) -> int:
        """Return the file descriptor of standard input."""
        return STDIN

    def readinto(self, buffer: Any) -> int:
        """Read into `buffer`, waiting for input."""
        for output in self._program.outputs:
            output.end()  # print a question that has no end of line
        self.look(None)
        first = self._typed.pop(0)
        taken = min(len(first), len(buffer))
        buffer[:taken] = first[:taken]
        if taken < len(first):
            self._typed.insert(0, first[taken:])
        return taken

    def look(self, seconds: float | None) -> bool:
        """Wait up to `seconds` for input; return whether there is some."""
        end = None if seconds is None else time.monotonic() + seconds
        if not self._take():
            self._tell(anew=seconds is None)
        while not self._take():
            left = None if end is None else end - time.monotonic()
            # A program that polls must yield to the page.
            wait(None if left is None else max(left, 0))
            if left is not None and left <= 0:
                return self._take()
        return True

    def _take(self) -> bool:
        while (typed := self._program.host.typed()) is not None:
            if typed.op != "complete":  # completion is for prompts only
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
    """Replace the functions of termios, os and select that programs read the keyboard with."""
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
    """Replace os.read()."""
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
    """Replace select.select()."""
    keys = [one for one in readers if _number(one) == STDIN]
    if not keys or len(keys) < len(readers) or writers or others:
        rest = [one for one in readers if one not in keys]
        return _select(rest, writers, others, timeout)
    return (keys if _mine().look(timeout) else []), [], []


def _number(one: Any) -> int:
    return one if isinstance(one, int) else int(one.fileno())
