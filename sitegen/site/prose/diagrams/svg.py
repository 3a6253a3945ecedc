"""The elements of a drawing. The theme sets colours and fonts: every element has a class."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from markupsafe import escape

# Points are pixels, x to the right and y down.
Point = tuple[float, float]

LINE = 20.0
_BREAK = re.compile(r"\s*<br\s*/?>\s*|\\n")
_NARROW, _WIDE = frozenset("fijlrt.,:;'|!()[] /"), frozenset("mwMWOQ@%")


def lines(text: str) -> list[str]:
    """Return the lines of a label."""
    return _BREAK.split(text.strip())


def width(text: str) -> float:
    """Return the approximate width of a label at 14 px; the visitor's font may differ."""
    return max(sum(_advance(letter) for letter in line) for line in lines(text))


def height(text: str) -> float:
    """Return the height of a label."""
    return LINE * len(lines(text))


def _advance(letter: str) -> float:
    if ord(letter) > 0x2E80:
        return 14.5
    return 5.0 if letter in _NARROW else 12.5 if letter in _WIDE or letter.isupper() else 8.2


def label(text: str, x: float, y: float, name: str = "", anchor: str = "middle") -> str:
    """Return a text centred at the point."""
    rows = lines(text)
    top = y - LINE * (len(rows) - 1) / 2
    spans = "".join(
        f'<tspan x="{number(x)}" y="{number(top + LINE * row)}">{escape(line)}</tspan>'
        for row, line in enumerate(rows)
    )
    name = f"label {name}".strip()
    return f'<text class="{name}" text-anchor="{anchor}" dy="0.35em">{spans}</text>'


def path(points: Sequence[Point], name: str, *, smooth: bool = False) -> str:
    """Return a line through the points."""
    return f'<path class="{name}" d="{_curve(points) if smooth else _straight(points)}"/>'


def polygon(points: Sequence[Point], name: str) -> str:
    """Return a filled shape."""
    return f'<path class="{name}" d="{_straight(points)}Z"/>'


def rectangle(x: float, y: float, w: float, h: float, name: str, radius: float = 0) -> str:
    """Return a rectangle with its top left corner at `x` and `y`."""
    at = f'x="{number(x)}" y="{number(y)}" width="{number(w)}" height="{number(h)}"'
    corner = f' rx="{number(radius)}"' if radius else ""
    return f'<rect class="{name}" {at}{corner}/>'


def arrow(tip: Point, start: Point) -> str:
    """Return the head of an arrow that comes from `start`."""
    length = math.dist(tip, start) or 1
    x, y = (tip[0] - start[0]) / length, (tip[1] - start[1]) / length
    back = tip[0] - 9 * x, tip[1] - 9 * y
    sides = (back[0] - 4.5 * y, back[1] + 4.5 * x), (back[0] + 4.5 * y, back[1] - 4.5 * x)
    return polygon((tip, *sides), "head")


def drawing(parts: Sequence[str], w: float, h: float, says: str) -> str:
    """Return the complete drawing; `says` describes it to screen readers."""
    size = f'width="{math.ceil(w)}" height="{math.ceil(h)}" viewBox="0 0 {number(w)} {number(h)}"'
    svg = f'<svg aria-hidden="true" {size}>{"".join(parts)}</svg>'
    return f'<div class="diagram" role="img" aria-label="{escape(says)}" tabindex="0">{svg}</div>'


def number(value: float) -> str:
    """Return a length as short text."""
    return f"{value:.1f}".removesuffix(".0")


def _straight(points: Sequence[Point]) -> str:
    return "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)


def _curve(points: Sequence[Point]) -> str:
    """Return a smooth curve through the points."""
    if len(points) < 3:
        return _straight(points)
    first, *_ = points
    drawn = [f"M{number(first[0])} {number(first[1])}"]
    for i in range(len(points) - 1):
        before, a = points[max(i - 1, 0)], points[i]
        b, after = points[i + 1], points[min(i + 2, len(points) - 1)]
        one = a[0] + (b[0] - before[0]) / 6, a[1] + (b[1] - before[1]) / 6
        two = b[0] - (after[0] - a[0]) / 6, b[1] - (after[1] - a[1]) / 6
        drawn.append("C" + " ".join(f"{number(x)} {number(y)}" for x, y in (one, two, b)))
    return "".join(drawn)
