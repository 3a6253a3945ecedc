"""Write lines with their time; a flood of them is cut short."""

from __future__ import annotations

import time
from collections.abc import Callable

# Lines in a second; those beyond are counted.
MOST = 100


class Log:
    """The log of a gateway."""

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say = say
        self._second = 0
        self._lines = 0

    def write(self, line: str) -> None:
        """Write a line."""
        now = int(time.monotonic())
        if now != self._second:
            left_out = self._lines - MOST
            self._second, self._lines = now, 0
            if left_out > 0:
                self._out(f"{left_out} more lines were left out")
        self._lines += 1
        if self._lines <= MOST:
            self._out(line)

    def _out(self, line: str) -> None:
        self._say(f"{time.strftime('%H:%M:%S')} {line}")
