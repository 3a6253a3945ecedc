"""Arrays of fixed length: the part of numpy that generated message classes use.

numpy takes megabytes to load, so generated classes import this module under its name. So do
programs that use only the names in `__all__`. Other operations on arrays raise an error.
"""

from __future__ import annotations

import array as numbers
from collections.abc import Iterable
from math import pi
from typing import Any

__all__ = ["array", "empty", "float32", "float64", "ndarray", "number", "pi", "zeros"]


class dtype:
    """A type of elements."""

    def __init__(self, name: str, code: str) -> None:
        self.name = name
        self.code = code

    def __repr__(self) -> str:
        return f"dtype('{self.name}')"

    def __str__(self) -> str:
        return self.name


float32, float64 = dtype("float32", "f"), dtype("float64", "d")
int8, int16, int32, int64 = (
    *(dtype("int8", "b"), dtype("int16", "h"), dtype("int32", "i"), dtype("int64", "q")),
)
uint8, uint16, uint32, uint64 = (
    *(dtype("uint8", "B"), dtype("uint16", "H"), dtype("uint32", "I"), dtype("uint64", "Q")),
)
_NAMED = {
    **{"float": float32, "double": float64},
    **{t.name: t for t in (int8, int16, int32, int64, uint8, uint16, uint32, uint64)},
}


def named(name: str) -> dtype:
    """Return the type with this name in IDL."""
    return _NAMED[name]


class number:
    """The base of numpy's numbers. Nothing is one: the elements of these arrays are Python's."""


class ndarray(numbers.array[Any]):
    """A one-dimensional array of numbers."""

    dtype: dtype

    @property
    def size(self) -> int:
        """Number of elements."""
        return len(self)

    @property
    def shape(self) -> tuple[int]:
        """Number of elements, as a tuple."""
        return (len(self),)

    def __eq__(self, other: object) -> Any:
        return self._compare(other, equal=True)

    def __ne__(self, other: object) -> Any:
        return self._compare(other, equal=False)

    __hash__ = None
    # numpy's operators work by element; those of Python's arrays would concatenate.
    __add__: Any = None
    __iadd__: Any = None
    __mul__: Any = None
    __rmul__: Any = None
    __imul__: Any = None

    def _compare(self, other: Any, *, equal: bool) -> list[bool]:
        return [(a == b) is equal for a, b in zip(self, other, strict=True)]

    def __repr__(self) -> str:
        usual = self.dtype in (float64, int64)
        kind = "" if usual else f", dtype={self.dtype.name}"
        return f"array([{', '.join(map(_written, self))}]{kind})"

    def __str__(self) -> str:
        return f"[{' '.join(map(_written, self))}]"


def _written(number: float) -> str:
    text = repr(number)
    return text.removesuffix("0") if text.endswith(".0") else text


def array(values: Iterable[Any], dtype: dtype | None = None) -> ndarray:
    """Return an array of `values`."""
    given = list(values)
    whole = given and all(type(each) is int for each in given)
    kind = dtype or (int64 if whole else float64)
    made = ndarray(kind.code, given)
    made.dtype = kind
    return made


def zeros(shape: int | tuple[int], dtype: dtype = float64) -> ndarray:
    """Return a one-dimensional array of zeros."""
    [size] = shape if isinstance(shape, tuple) else (shape,)
    return array([0] * size, dtype)


empty = zeros
