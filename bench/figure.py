"""The plain data of a measurement, and how a table shows it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal


@dataclass(frozen=True)
class Target:
    """What the design promises about a figure, or about its ratio to the bare one."""

    of: Literal["figure", "ratio"]
    bound: Literal["≤", "≥"]
    limit: float

    def met(self, value: float) -> bool:
        """Say whether `value` keeps the promise."""
        return value <= self.limit if self.bound == "≤" else value >= self.limit


@dataclass(frozen=True)
class Figure:
    """A measured number, and what the bare platform takes for the same."""

    name: str
    unit: str
    ours: float
    bare: float | None = None
    target: Target | None = None
    detail: Mapping[str, object] = field(default_factory=dict)

    @property
    def ratio(self) -> float | None:
        """How many times the bare figure ours is."""
        return self.ours / self.bare if self.bare else None

    @property
    def met(self) -> bool | None:
        """Whether the target is met; None where there is none."""
        if self.target is None:
            return None
        value = self.ours if self.target.of == "figure" else self.ratio
        return value is not None and self.target.met(value)

    def row(self) -> list[str]:
        """Return the cells of a table."""
        target = ""
        if self.target:
            limit = number(self.target.limit)
            target = f"{self.target.bound} {limit}" + (
                f" {self.unit}" if self.target.of == "figure" else ""
            )
        return [
            self.name,
            f"{number(self.ours)} {self.unit}",
            f"{number(self.bare)} {self.unit}" if self.bare else "",
            f"{self.ratio:.2f}" if self.ratio else "",
            target,
            {None: "", True: "met", False: "NOT MET"}[self.met],
        ]

    def entry(self) -> dict[str, object]:
        """Return what is kept of it as JSON."""
        return {
            "name": self.name,
            "unit": self.unit,
            "ours": self.ours,
            "bare": self.bare,
            "ratio": self.ratio,
            "met": self.met,
            **self.detail,
        }


def table(figures: Sequence[Figure]) -> str:
    """Write figures as lines of aligned columns, names at the left, numbers at the right."""
    rows = [["figure", "ours", "bare", "ratio", "target", ""], *(f.row() for f in figures)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = []
    for row in rows:
        cells = zip(row, widths, strict=True)
        first, width = next(cells)
        lines.append("  ".join([first.ljust(width), *(c.rjust(w) for c, w in cells)]).rstrip())
    return "\n".join(lines)


def number(value: float) -> str:
    """Write a number with three digits that say something."""
    if value >= 100:
        return f"{value:,.0f}"
    return f"{value:.3g}"
