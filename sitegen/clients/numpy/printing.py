"""How numpy writes arrays of floats."""

from __future__ import annotations

import math
from collections.abc import Sequence

PRECISION = 8
# Of a line.
WIDTH = 75


def text_of(
    numbers: Sequence[float], shape: tuple[int, ...], before: str = "", after: str = ""
) -> str:
    """Return the text of numbers in one or two dimensions; `before` and `after` are repr()'s."""
    words = _aligned(numbers)
    separator = ", " if before else " "
    # A bracket for each dimension closes the last line.
    width = WIDTH - len(after) - len(shape)
    indent = " " * (len(before) + len(shape))
    if len(shape) == 1:
        return before + _row(words, separator, indent, width) + after
    rows, columns = shape
    cells = [words[n * columns : (n + 1) * columns] for n in range(rows)]
    lines = [_row(row, separator, indent, width) for row in cells]
    between = separator.rstrip() + "\n" + indent[1:]
    return f"{before}[{between.join(lines)}]{after}"


def _row(words: Sequence[str], separator: str, indent: str, width: int) -> str:
    """Return one row in brackets, on several lines if it is too long for one."""
    text, line = "", indent
    for word in words:
        if len(line) + len(word) > width and len(line) > len(indent):
            text += line.rstrip() + "\n"
            line = indent
        line += word + separator
    text += line.removesuffix(separator)
    return f"[{text.removeprefix(indent)}]"


def _aligned(numbers: Sequence[float]) -> list[str]:
    """Return the texts of numbers, all with their points below each other."""
    finite = [number for number in numbers if math.isfinite(number)]
    sizes = [abs(number) for number in finite if number]
    large, small = max(sizes, default=1.0), min(sizes, default=1.0)
    if large >= 1e8 or small < 1e-4 or large / small > 1000:
        digits = max(_digits(number) for number in finite)
        places = 3 if large >= 1e100 or small < 1e-99 else 2
        texts = [_scientific(number, digits, places) for number in numbers]
    else:
        texts = [_plain(number) for number in numbers]
    points = [text.partition(".") for text in texts]
    right = max((1 + len(rest) for _, point, rest in points if point), default=1)
    padded = [
        text + " " * (right - 1 - len(rest)) if point else text
        for text, (_, point, rest) in zip(texts, points, strict=True)
    ]
    width = max(map(len, padded), default=0)
    return [text.rjust(width) for text in padded]


def _scientific(number: float, digits: int, places: int) -> str:
    """Return a text such as 1.50e-05, with `places` of the exponent, or the name of a number."""
    if not math.isfinite(number):
        return str(number)
    mantissa, _, exponent = f"{number:.{digits}e}".partition("e")
    return f"{mantissa}{'' if digits else '.'}e{int(exponent):+0{places + 1}d}"


def _digits(number: float) -> int:
    """Return how many digits follow the point in the shortest text with an exponent."""
    wanted = float(f"{number:.{PRECISION}e}")
    enough = (d for d in range(PRECISION) if float(f"{number:.{d}e}") in (number, wanted))
    return next(enough, PRECISION)


def _plain(number: float) -> str:
    if not math.isfinite(number):
        return str(number)
    return f"{number:.{PRECISION}f}".rstrip("0")
