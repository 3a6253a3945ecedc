"""Rotations as quaternions (x, y, z, w), translations as (x, y, z), and poses of both."""

from __future__ import annotations

import math
from typing import NamedTuple

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]


class Pose(NamedTuple):
    """A rotation followed by a translation."""

    rotation: Quaternion
    translation: Vector


IDENTITY = Pose((0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0))


def multiplied(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the product `a` `b`: the rotation by `b` and then by `a`."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by + ay * bw + az * bx - ax * bz,
        aw * bz + az * bw + ax * by - ay * bx,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def conjugated(q: Quaternion) -> Quaternion:
    """Return the inverse rotation."""
    return (-q[0], -q[1], -q[2], q[3])


def rotated(q: Quaternion, v: Vector) -> Vector:
    """Return a rotated vector."""
    x, y, z, _ = multiplied(multiplied(q, (*v, 0.0)), conjugated(q))
    return (x, y, z)


def moved(pose: Pose, v: Vector) -> Vector:
    """Return a point rotated and translated by a pose."""
    x, y, z = rotated(pose.rotation, v)
    return (x + pose.translation[0], y + pose.translation[1], z + pose.translation[2])


def chained(a: Pose, b: Pose) -> Pose:
    """Return the pose that applies `b` and then `a`."""
    return Pose(multiplied(a.rotation, b.rotation), moved(a, b.translation))


def inverted(pose: Pose) -> Pose:
    """Return the inverse pose."""
    back = conjugated(pose.rotation)
    x, y, z = rotated(back, pose.translation)
    return Pose(back, (-x, -y, -z))


def between(a: Pose, b: Pose, ratio: float) -> Pose:
    """Return the interpolation between `a` at 0 and `b` at 1: linear, along the shorter arc."""
    x, y, z = (p + (q - p) * ratio for p, q in zip(a.translation, b.translation, strict=True))
    return Pose(slerp(a.rotation, b.rotation, ratio), (x, y, z))


def slerp(a: Quaternion, b: Quaternion, ratio: float) -> Quaternion:
    """Return the rotation between `a` at 0 and `b` at 1, along the shorter arc."""
    dot = sum(p * q for p, q in zip(a, b, strict=True))
    angle = math.acos(min(1.0, abs(dot)))
    if angle == 0:
        return a
    first, second = math.sin((1 - ratio) * angle), math.sin(ratio * angle)
    if dot < 0:
        second = -second
    x, y, z, w = ((first * p + second * q) / math.sin(angle) for p, q in zip(a, b, strict=True))
    return (x, y, z, w)
