"""The error of an invalid diagram."""

from __future__ import annotations


class DiagramError(ValueError):
    """`line`, as the author wrote it, is invalid or unsupported."""

    def __init__(self, line: str, fault: str) -> None:
        super().__init__(fault)
        self.line = line
