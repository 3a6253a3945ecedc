"""Write the meshes of the arm: bodies of revolution, as binary STL files in metres."""

import itertools
import math
import struct
from pathlib import Path

SEGMENTS = 36
# Radius and height of the corners of each outline, from the bottom to the top.
OUTLINES = {
    "base": [(0, 0), (0.13, 0), (0.13, 0.025), (0.095, 0.045), (0.08, 0.1), (0, 0.1)],
    "shoulder": [(0, 0), (0.08, 0), (0.088, 0.02), (0.088, 0.1), (0.07, 0.13), (0, 0.14)],
    "upper": [
        (0, -0.06),
        (0.04, -0.05),
        (0.058, 0),
        (0.05, 0.08),
        (0.04, 0.3),
        (0.05, 0.4),
        (0.046, 0.44),
        (0.03, 0.455),
        (0, 0.46),
    ],
    "fore": [
        (0, -0.045),
        (0.03, -0.04),
        (0.045, 0),
        (0.04, 0.06),
        (0.03, 0.26),
        (0.036, 0.33),
        (0.03, 0.35),
        (0, 0.355),
    ],
    "hand": [(0, 0), (0.034, 0), (0.04, 0.015), (0.04, 0.04), (0.026, 0.06), (0, 0.065)],
}


def triangles(outline):
    """Yield the triangles of the body that an outline makes when it is turned around z."""
    turns = [2 * math.pi * step / SEGMENTS for step in range(SEGMENTS + 1)]
    for (r, z), (s, y) in itertools.pairwise(outline):
        for one, two in itertools.pairwise(turns):
            a = (r * math.cos(one), r * math.sin(one), z)
            b = (r * math.cos(two), r * math.sin(two), z)
            c = (s * math.cos(two), s * math.sin(two), y)
            d = (s * math.cos(one), s * math.sin(one), y)
            if r:
                yield a, b, c
            if s:
                yield a, c, d


def normal(a, b, c):
    """Return the direction that a triangle faces."""
    u, v = [q - p for p, q in zip(a, b, strict=False)], [q - p for p, q in zip(a, c, strict=False)]
    cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = math.hypot(*cross) or 1
    return [part / length for part in cross]


for name, outline in OUTLINES.items():
    found = list(triangles(outline))
    data = bytearray(80) + struct.pack("<I", len(found))
    for triangle in found:
        corners = [part for corner in triangle for part in corner]
        data += struct.pack("<12fH", *normal(*triangle), *corners, 0)
    Path(__file__).with_name(f"{name}.stl").write_bytes(data)
