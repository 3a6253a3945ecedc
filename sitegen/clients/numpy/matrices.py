"""The matrices of numpy, for programs that calculate with transforms.

Elements are floats. As in numpy, slices are views: what is assigned to them is assigned to the
matrix.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from .numbers import ADVICE as OF_NUMBERS
from .numbers import Number
from .printing import text_of

__all__ = ["dot", "eye", "identity", "matmul"]

ADVICE = OF_NUMBERS.replace("functions of single numbers", "matrices of transforms")
# The places of the numbers of a matrix, or of one row, among those of the whole.
Places = Sequence[Any]


class Matrix:
    """Numbers in one or two dimensions; or a view of those at `places` of others."""

    __hash__ = None  # type: ignore[assignment]

    def __init__(self, numbers: list[float], places: Places) -> None:
        self._numbers = numbers
        self._places = places

    @property
    def ndim(self) -> int:
        """Number of dimensions."""
        return 2 if self._places and isinstance(self._places[0], list) else 1

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of rows and of columns, or of numbers."""
        return (len(self), len(self._places[0])) if self.ndim == 2 else (len(self),)

    @property
    def size(self) -> int:
        """Number of numbers."""
        return len(self._flat())

    @property
    def T(self) -> Matrix:
        """The transposed matrix, as a view."""
        if self.ndim == 1:
            return self
        return Matrix(self._numbers, [list(column) for column in zip(*self._places, strict=True)])

    def __len__(self) -> int:
        return len(self._places)

    def __iter__(self) -> Iterator[Any]:
        return (self[index] for index in range(len(self)))

    def __getitem__(self, key: Any) -> Any:
        places = self._at(key)
        if isinstance(places, int):
            return Number(self._numbers[places])
        return Matrix(self._numbers, places)

    def __setitem__(self, key: Any, value: Any) -> None:
        places = self._at(key)
        if isinstance(places, int):
            self._numbers[places] = _number(value)
            return
        target = Matrix(self._numbers, places)
        for place, number in zip(target._flat(), _spread(value, target.shape), strict=True):
            self._numbers[place] = number

    def _at(self, key: Any) -> Any:
        keys = key if isinstance(key, tuple) else (key,)
        if not keys or any(type(one) not in (int, slice) for one in keys):
            raise TypeError(f"{key!r} is no index or slice: {ADVICE}")
        if len(keys) > self.ndim:
            raise IndexError(
                f"too many indices for array: array is {self.ndim}-dimensional, "
                f"but {len(keys)} were indexed"
            )
        for axis, (one, size) in enumerate(zip(keys, self.shape, strict=False)):
            if isinstance(one, int) and not -size <= one < size:
                raise IndexError(f"index {one} is out of bounds for axis {axis} with size {size}")
        first, *second = keys
        found = self._places[first]
        if not second:
            return found
        return found[second[0]] if isinstance(first, int) else [row[second[0]] for row in found]

    def _flat(self) -> list[int]:
        if self.ndim == 1:
            return list(self._places)
        return [place for row in self._places for place in row]

    def _values(self) -> list[float]:
        return [self._numbers[place] for place in self._flat()]

    def copy(self) -> Matrix:
        """Return a matrix with the same numbers, which is no view."""
        return _made(self._values(), self.shape)

    def transpose(self) -> Matrix:
        """Return the transposed matrix, as a view."""
        return self.T

    def tolist(self) -> list[Any]:
        """Return the numbers as a list, of rows if there are two dimensions."""
        return [row.tolist() for row in self] if self.ndim == 2 else self._values()

    def dot(self, other: object) -> Any:
        """Return the product of matrices, or that with a number."""
        return dot(self, other)

    def __matmul__(self, given: object) -> Any:
        other = _matrix(given)
        rows = self if self.ndim == 2 else [self]
        columns = other.T if other.ndim == 2 else [other]
        inner, length = self.shape[-1], other.shape[0]
        if inner != length:
            raise ValueError(
                f"shapes {self.shape} and {other.shape} not aligned: {inner} is not {length}"
            )
        found = [_sum_of_products(row, column) for row in rows for column in columns]
        shape = self.shape[:-1] + other.shape[1:]
        return _made(found, shape) if shape else Number(found[0])

    def __rmatmul__(self, given: object) -> Any:
        return _matrix(given) @ self

    def __neg__(self) -> Matrix:
        return _made([-value for value in self._values()], self.shape)

    def __eq__(self, other: object) -> Any:
        raise TypeError(f"matrices are not compared: {ADVICE}")

    __ne__ = __lt__ = __le__ = __gt__ = __ge__ = __eq__

    def __bool__(self) -> bool:
        if self.size == 1:
            return bool(self._values()[0])
        raise ValueError(
            "The truth value of an array with more than one element is ambiguous. "
            "Use a.any() or a.all()"
        )

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"a matrix has no '{name}': {ADVICE}")

    def __repr__(self) -> str:
        return text_of(self._values(), self.shape, "array(", ")")

    def __str__(self) -> str:
        return text_of(self._values(), self.shape)


def _operator(result: Callable[[Any, Any], Any], *, swapped: bool) -> Callable[..., Any]:
    def operate(self: Matrix, other: object) -> Matrix:
        ours, theirs = self._values(), _spread(other, self.shape)
        pairs = zip(*((theirs, ours) if swapped else (ours, theirs)), strict=True)
        return _made([result(Number(a), b) for a, b in pairs], self.shape)

    return operate


def _in_place(result: Callable[[Any, Any], Any]) -> Callable[..., Any]:
    def operate(self: Matrix, other: object) -> Matrix:
        self[:] = result(self, other)
        return self

    return operate


for _name, _result in {
    **{"add": operator.add, "sub": operator.sub, "mul": operator.mul},
    "truediv": operator.truediv,
}.items():
    setattr(Matrix, f"__{_name}__", _operator(_result, swapped=False))
    setattr(Matrix, f"__r{_name}__", _operator(_result, swapped=True))
    setattr(Matrix, f"__i{_name}__", _in_place(_result))


def _number(value: object) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool):
        raise TypeError(f"'{type(value).__name__}' is not a number: {ADVICE}")
    return float(value)


def _matrix(value: Any) -> Matrix:
    if not isinstance(value, Matrix | list | tuple):
        raise TypeError(f"'{type(value).__name__}' is no matrix: {ADVICE}")
    return value if isinstance(value, Matrix) else matrix_of(value)


def _spread(value: Any, shape: tuple[int, ...]) -> list[float]:
    """Return the numbers of a matrix, a row, lists or one number for each place of `shape`."""
    rows, columns = shape if len(shape) == 2 else (1, *shape)
    if not isinstance(value, Matrix | list | tuple):
        return [_number(value)] * (rows * columns)
    matrix = _matrix(value)
    if matrix.shape == shape:
        return matrix._values()
    if matrix.ndim == 1 and matrix.shape == shape[1:]:
        return matrix._values() * rows
    raise ValueError(f"no array of shape {shape} from one of shape {matrix.shape}: {ADVICE}")


def _sum_of_products(row: Matrix, column: Matrix) -> float:
    return sum(a * b for a, b in zip(row._values(), column._values(), strict=True))


def _made(numbers: list[Any], shape: tuple[int, ...]) -> Matrix:
    own = [float(number) for number in numbers]
    if len(shape) == 1:
        return Matrix(own, range(len(own)))
    rows, columns = shape
    return Matrix(own, [list(range(n * columns, (n + 1) * columns)) for n in range(rows)])


def matrix_of(rows: Sequence[Any]) -> Matrix:
    """Return the matrix of rows, or of numbers in one dimension."""
    if rows and isinstance(rows[0], Matrix | list | tuple):
        lists = [row.tolist() if isinstance(row, Matrix) else row for row in rows]
        if len({len(row) for row in lists}) > 1:
            raise ValueError("rows have different numbers of elements")
        return _made([_number(one) for row in lists for one in row], (len(lists), len(lists[0])))
    return _made([_number(one) for one in rows], (len(rows),))


def eye(size: int, columns: int | None = None) -> Matrix:
    """Return a matrix with ones in its diagonal."""
    shape = (size, size if columns is None else columns)
    return _made([float(i == j) for i in range(shape[0]) for j in range(shape[1])], shape)


def identity(size: int) -> Matrix:
    """Return the identity matrix."""
    return eye(size)


def matmul(first: Any, second: Any) -> Any:
    """Return the product of matrices."""
    return _matrix(first) @ second


def dot(first: Any, second: Any) -> Any:
    """Return the product of matrices, or of a matrix and a number."""
    if isinstance(first, int | float) or isinstance(second, int | float):
        return first * second
    return matmul(first, second)
