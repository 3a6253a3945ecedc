"""The plain data of a measurement, and how a table shows it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal


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
class Kept:
    """What is compared with an earlier run: a ratio without unit, or a figure where there is none.

    `noise` is how far single runs were from this median of them, as a part of it.
    """

    value: float
    unit: str
    noise: float | None = None

    def __str__(self) -> str:
        return f"{number(self.value)} {self.unit}" if self.unit else f"{self.value:.2f}"


@dataclass(frozen=True)
class Figure:
    """A measured number, and what the bare platform takes for the same."""

    name: str
    unit: str
    ours: float
    bare: float | None = None
    target: Target | None = None
    detail: Mapping[str, object] = field(default_factory=dict)
    # How far single runs were from this median of them, as a part of it.
    noise: float | None = None

    @property
    def higher(self) -> bool:
        """Whether more is better."""
        return self.unit == "/s"

    @property
    def compared(self) -> float:
        """What other runs are compared by: machines differ less in the ratio."""
        return self.ratio or self.ours

    @property
    def promise(self) -> str:
        """The target as text; "" where there is none."""
        if self.target is None:
            return ""
        unit = f" {self.unit}" if self.target.of == "figure" else ""
        return f"{self.target.bound} {number(self.target.limit)}{unit}".strip()

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
        return [
            *cells(self.entry()),
            self.promise,
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
            "target": self.promise,
            "met": self.met,
            "noise": self.noise,
            **self.detail,
        }


def table(figures: Sequence[Figure], kept: Mapping[str, Kept] = MappingProxyType({})) -> str:
    """Write figures as lines of aligned columns, with those that were kept, if there are any.

    Names are at the left, numbers at the right.
    """
    rows = [["figure", "ours", "bare", "ratio", "target", ""], *(f.row() for f in figures)]
    if kept:
        rows[0].insert(4, "before")
        for figure, row in zip(figures, rows[1:], strict=True):
            row.insert(4, str(kept[figure.name]) if figure.name in kept else "")
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = []
    for row in rows:
        cells = zip(row, widths, strict=True)
        first, width = next(cells)
        lines.append("  ".join([first.ljust(width), *(c.rjust(w) for c, w in cells)]).rstrip())
    return "\n".join(lines)


def cells(entry: Mapping[str, Any]) -> list[str]:
    """Return the name and the numbers of a figure's `entry` as texts."""
    ours, bare, unit, ratio = (entry[key] for key in ("ours", "bare", "unit", "ratio"))
    return [
        entry["name"],
        f"{number(ours)} {unit}".strip(),
        f"{number(bare)} {unit}".strip() if bare else "",
        f"{ratio:.2f}" if ratio else "",
    ]


def number(value: float) -> str:
    """Write a number with three digits that say something."""
    if value >= 100:
        return f"{value:,.0f}"
    return f"{value:.3g}"
