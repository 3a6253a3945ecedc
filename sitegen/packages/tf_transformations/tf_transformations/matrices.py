"""Functions on matrices of 4 by 4, which are arrays of numpy, or of sitegen's part of numpy.

Angles are in radians.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy

from tf_transformations import (
    Numbers,
    euler_from_quaternion,
    quaternion_about_axis,
    quaternion_from_euler,
)

SIZE = 4
# Columns in which no number is larger than this are taken for empty.
TINY = 1e-12


def _matrix(rows: Sequence[Numbers]) -> Any:
    """Return the matrix of up to four rows of up to four numbers; the rest is the identity's."""
    found = numpy.identity(SIZE)
    for i, row in enumerate(rows):
        for j, value in enumerate(row):
            found[i, j] = value
    return found


def identity_matrix() -> Any:
    """Return the identity."""
    return _matrix([])


def translation_matrix(direction: Numbers) -> Any:
    """Return the translation by x, y, z."""
    x, y, z = direction[:3]
    return _matrix([(1, 0, 0, x), (0, 1, 0, y), (0, 0, 1, z)])


def translation_from_matrix(matrix: Any) -> Any:
    """Return x, y, z of the translation."""
    return matrix[:3, 3].copy()


def rotation_matrix(angle: float, direction: Numbers, point: Numbers | None = None) -> Any:
    """Return the rotation about an axis through `point`, or through the origin."""
    turn = quaternion_matrix(quaternion_about_axis(angle, direction))
    if point is None:
        return turn
    there, back = translation_matrix(point), translation_matrix([-value for value in point[:3]])
    return concatenate_matrices(there, turn, back)


def euler_matrix(ai: float, aj: float, ak: float, axes: str = "sxyz") -> Any:
    """Return the rotation by Euler angles.

    Raises:
        ValueError: if `axes` is invalid.
    """
    return quaternion_matrix(quaternion_from_euler(ai, aj, ak, axes))


def euler_from_matrix(matrix: Any, axes: str = "sxyz") -> tuple[float, float, float]:
    """Return the Euler angles of a rotation.

    Raises:
        ValueError: if `axes` is unsupported.
    """
    return euler_from_quaternion(quaternion_from_matrix(matrix), axes)


def quaternion_matrix(quaternion: Numbers) -> Any:
    """Return the rotation by a quaternion of any length; the identity if all is zero."""
    x, y, z, w = quaternion
    square = x * x + y * y + z * z + w * w
    if square < TINY:
        return identity_matrix()
    s = 2 / square
    return _matrix(
        [
            (1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)),
            (s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)),
            (s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)),
        ]
    )


def quaternion_from_matrix(matrix: Any) -> list[float]:
    """Return the rotation of a matrix, with w of at least 0."""
    m = [[float(matrix[i, j]) for j in range(3)] for i in range(3)]
    trace = m[0][0] + m[1][1] + m[2][2]
    # The largest component first, so that nothing is divided by a small number.
    i = max(range(3), key=lambda k: m[k][k])
    if trace > m[i][i]:
        found = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1], 1 + trace]
    else:
        j, k = (i + 1) % 3, (i + 2) % 3
        found = [0.0, 0.0, 0.0, m[k][j] - m[j][k]]
        found[i] = 1 + m[i][i] - m[j][j] - m[k][k]
        found[j] = m[i][j] + m[j][i]
        found[k] = m[i][k] + m[k][i]
    length = math.copysign(math.hypot(*found), found[3])
    return [value / length for value in found]


def inverse_matrix(matrix: Any) -> Any:
    """Return the inverse, by Gauss-Jordan elimination.

    Raises:
        ValueError: if there is none.
    """
    rows = [[float(matrix[i, j]) for j in range(SIZE)] for i in range(SIZE)]
    rows = [row + [float(i == j) for j in range(SIZE)] for i, row in enumerate(rows)]
    for column in range(SIZE):
        pivot = max(range(column, SIZE), key=lambda i: abs(rows[i][column]))
        if abs(rows[pivot][column]) < TINY:
            raise ValueError("the matrix has no inverse")
        rows[column], rows[pivot] = rows[pivot], rows[column]
        factor = rows[column][column]
        rows[column] = [value / factor for value in rows[column]]
        for i in range(SIZE):
            if i != column:
                factor = rows[i][column]
                pairs = zip(rows[i], rows[column], strict=True)
                rows[i] = [a - factor * b for a, b in pairs]
    return _matrix([row[SIZE:] for row in rows])


def concatenate_matrices(*matrices: Any) -> Any:
    """Return the product of matrices, of which the last is applied first."""
    found = identity_matrix()
    for matrix in matrices:
        found = numpy.dot(found, matrix)
    return found


def is_same_transform(matrix0: Any, matrix1: Any) -> bool:
    """Return whether two matrices are the same, up to a factor and small differences."""
    first, second = (
        [float(one[i, j] / one[3, 3]) for i in range(SIZE) for j in range(SIZE)]
        for one in (matrix0, matrix1)
    )
    pairs = zip(first, second, strict=True)
    return all(abs(a - b) <= 1e-8 + 1e-5 * abs(b) for a, b in pairs)
