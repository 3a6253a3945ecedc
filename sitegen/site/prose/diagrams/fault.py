"""What can be wrong with a diagram."""

from __future__ import annotations


class DiagramError(ValueError):
    """`line`, as the author wrote it, is nothing that can be drawn."""

    def __init__(self, line: str, fault: str) -> None:
        super().__init__(fault)
        self.line = line
