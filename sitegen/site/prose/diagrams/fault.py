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


def check_size(line: str, parts: int, lines: int, names: tuple[str, str]) -> None:
    """Raise a DiagramError if there are too many parts or lines, which are called `names`."""
    if parts > MOST_PARTS or lines > MOST_LINES:
        limits = f"{MOST_PARTS} {names[0]} and {MOST_LINES} {names[1]}"
        raise DiagramError(line, f"too large; at most {limits} are supported")
