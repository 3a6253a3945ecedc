"""The keyboard of programs. Nobody types, so who reads it waits, as at a terminal left alone."""

from __future__ import annotations

import io
import select
import sys
import termios
from collections.abc import Sequence
from typing import Any, TextIO

from rclpy_backend import turns
from rclpy_backend.blocking import sleep, wait

NOBODY = "Nobody types for a program in a page: what it reads from the keyboard never comes"
# What a terminal would be set to: four numbers, two speeds, and its special characters.
ATTRIBUTES = [0, 0, 0, 0, 0, 0]
CHARACTERS = 32
STDIN = 0

_select = select.select
# The programs that were told.
_told: set[turns.Program] = set()


class Keyboard(io.RawIOBase):
    """A stream of bytes from which none ever come."""

    def readable(self) -> bool:
        """Return that it can be read from."""
        return True

    def fileno(self) -> int:
        """Return what the system would read from."""
        return STDIN

    def readinto(self, buffer: Any) -> int:
        """Wait for what somebody types."""
        for output in turns.running().outputs:
            output.end()  # a question has no end of line
        _tell()
        while True:
            wait(None)


def opened() -> TextIO:
    """Return a program's standard input."""
    return io.TextIOWrapper(io.BufferedReader(Keyboard()), "utf-8")


def install() -> None:
    """Let programs set their terminal, and look whether there is something to read."""
    replaced = {
        "tcgetattr": lambda _: [*ATTRIBUTES, [b"\0"] * CHARACTERS],
        **dict.fromkeys(("tcsetattr", "tcflush", "tcdrain"), lambda *_: None),
    }
    for name, replacement in replaced.items():
        setattr(termios, name, replacement)
    select.select = _look  # type: ignore[assignment]


def _look(
    readers: Sequence[Any],
    writers: Sequence[Any],
    others: Sequence[Any],
    timeout: float | None = None,
) -> tuple[list[Any], list[Any], list[Any]]:
    """Stand in for select.select()."""
    rest = [one for one in readers if _number(one) != STDIN]
    if len(rest) == len(readers) or writers or others or rest:
        return _select(rest, writers, others, timeout)
    _tell()
    if timeout is not None:
        sleep(timeout)
        return [], [], []
    while True:
        wait(None)


def _number(one: Any) -> int:
    return one if isinstance(one, int) else int(one.fileno())


def _tell() -> None:
    program = turns.running()
    if program not in _told:
        _told.add(program)
        print(NOBODY, file=sys.stderr)
