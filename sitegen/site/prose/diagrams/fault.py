"""The error of an invalid diagram."""

from __future__ import annotations

# A diagram with more parts than these could not be read, and would take long to place.
MOST_PARTS = 200
MOST_LINES = 500


class DiagramError(ValueError):
    """`line`, as the author wrote it, is invalid or unsupported."""

    def __init__(self, line: str, fault: str) -> None:
        super().__init__(fault)
        self.line = line
