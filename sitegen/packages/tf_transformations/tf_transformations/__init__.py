"""Functions on quaternions, which are lists of x, y, z, w; angles are in radians.

Those on matrices need numpy, so they are loaded when a program uses one.
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Sequence
from typing import Any

Numbers = Sequence[float]
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
DECOMPOSED = ("sxyz", "rzyx")
# The build adds numpy for programs that use these.
OF_MATRICES = {
    *("concatenate_matrices", "euler_from_matrix", "euler_matrix", "identity_matrix"),
    *("inverse_matrix", "is_same_transform", "quaternion_from_matrix", "quaternion_matrix"),
    *("rotation_matrix", "translation_from_matrix", "translation_matrix"),
}


def __getattr__(name: str) -> Any:
    if name not in OF_MATRICES:
        raise AttributeError(f"module 'tf_transformations' has no attribute '{name}'")
    return getattr(importlib.import_module("tf_transformations.matrices"), name)


def quaternion_about_axis(angle: float, axis: Numbers) -> list[float]:
    """Return the rotation about an axis of any length."""
    length = math.hypot(*axis[:3])
    factor = math.sin(angle / 2) / length if length else 0.0
    return [axis[0] * factor, axis[1] * factor, axis[2] * factor, math.cos(angle / 2)]


def quaternion_multiply(quaternion1: Numbers, quaternion0: Numbers) -> list[float]:
    """Return the rotation by `quaternion0` and then by `quaternion1`."""
    ax, ay, az, aw = quaternion1
    bx, by, bz, bw = quaternion0
    return [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by + ay * bw + az * bx - ax * bz,
        aw * bz + az * bw + ax * by - ay * bx,
        aw * bw - ax * bx - ay * by - az * bz,
    ]


def quaternion_conjugate(quaternion: Numbers) -> list[float]:
    """Return the conjugate."""
    return [-quaternion[0], -quaternion[1], -quaternion[2], quaternion[3]]


def quaternion_inverse(quaternion: Numbers) -> list[float]:
    """Return the inverse."""
    square = sum(value * value for value in quaternion)
    return [value / square for value in quaternion_conjugate(quaternion)]


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: str = "sxyz") -> list[float]:
    """Return the rotation by Euler angles about static (s…) or rotating (r…) axes.

    Raises:
        ValueError: if `axes` is invalid.
    """
    frame, names = axes[:1], axes[1:]
    if frame not in ("s", "r") or len(names) != 3 or not set(names) <= set(AXES):
        raise ValueError(f"'{axes}' are not valid axes; expected a form such as 'sxyz'")
    found = [0.0, 0.0, 0.0, 1.0]
    for angle, name in zip((ai, aj, ak), names, strict=True):
        turn = quaternion_about_axis(angle, AXES[name])
        found = (
            quaternion_multiply(turn, found) if frame == "s" else quaternion_multiply(found, turn)
        )
    return found


def euler_from_quaternion(quaternion: Numbers, axes: str = "sxyz") -> tuple[float, float, float]:
    """Return roll, pitch and yaw, or for 'rzyx' yaw, pitch and roll.

    Raises:
        ValueError: if `axes` is unsupported.
    """
    if axes not in DECOMPOSED:
        raise ValueError(f"axes '{axes}' are unsupported; supported axes: {DECOMPOSED}")
    x, y, z, w = quaternion
    roll = math.atan2(2 * (w * x + y * z), w * w - x * x - y * y + z * z)
    pitch = math.asin(max(-1.0, min(1.0, 2 * (w * y - x * z))))
    yaw = math.atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z)
    return (roll, pitch, yaw) if axes == "sxyz" else (yaw, pitch, roll)


def quaternion_slerp(quat0: Numbers, quat1: Numbers, fraction: float) -> list[float]:
    """Interpolate between `quat0` at 0 and `quat1` at 1, along the shorter arc."""
    dot = sum(a * b for a, b in zip(quat0, quat1, strict=True))
    angle = math.acos(min(1.0, abs(dot)))
    if angle == 0:
        return list(quat0)
    first, second = math.sin((1 - fraction) * angle), math.sin(fraction * angle)
    if dot < 0:
        second = -second
    return [(first * a + second * b) / math.sin(angle) for a, b in zip(quat0, quat1, strict=True)]
