"""Shadows in a 3D view: of robots and markers, on the floor and on each other."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Locator
from playwright.sync_api import Page as Tab
from scenes import at, emit, pixel, pixels, view
from stage import add

MARKERS = "visualization_msgs/msg/MarkerArray"
FLOOR = {"kind": "grid", "alpha": 0}
# A cube a metre above the floor, and where the light lets its shadow fall.
BOX = "pose: pose(0, 0, 1), scale: { x: 0.4, y: 0.4, z: 0.4 }"
SHADE = (0.45, -0.25)
LIT = (-0.45, 0.25)


def boxes(tab: Tab, *markers: str, floor: dict[str, Any] = FLOOR) -> Locator:
    add(tab, "publisher", "/node", "/t", MARKERS)
    panel = view(tab, floor, {"kind": "markers", "topic": "/t"}, background="#ffffff")
    emit(tab, "/t", f"{{ markers: [{', '.join(markers)}] }}")
    return panel


def brightness(panel: Locator, *points: tuple[float, float]) -> list[int]:
    image = pixels(panel)
    return [sum(pixel(image, *point)) for point in points]


def test_what_is_above_the_floor_casts_a_shadow_on_it(stage: Tab) -> None:
    panel = boxes(stage, f"marker({{ {BOX} }})")
    shade, lit = brightness(panel, SHADE, LIT)
    assert lit == 3 * 255
    assert lit / 2 < shade < 0.9 * lit


def test_what_is_above_something_casts_a_shadow_on_it(stage: Tab) -> None:
    below = "pose: pose(0, 0, -0.5), scale: { x: 4, y: 4, z: 1 }, color: color(0, 1, 0)"
    panel = boxes(stage, f"marker({{ {BOX} }})", f"marker({{ id: 1, {below} }})")
    shade, lit = brightness(panel, SHADE, LIT)
    assert shade < 0.9 * lit
    # Nothing is so dark that its color is not seen.
    assert at(pixels(panel), *SHADE) == "green"


@pytest.mark.parametrize(
    ("box", "floor"),
    [
        (f"{BOX}, color: color(1, 0, 0, 0.5)", FLOOR),
        (BOX, {**FLOOR, "plane": "XZ"}),
        (BOX, {**FLOOR, "enabled": False}),
    ],
    ids=["transparent", "wall", "hidden"],
)
def test_what_casts_no_shadow(stage: Tab, box: str, floor: dict[str, Any]) -> None:
    panel = boxes(stage, f"marker({{ {box} }})", floor=floor)
    shade, lit = brightness(panel, SHADE, LIT)
    assert shade == lit == 3 * 255


def test_a_frame_of_very_many_triangles_has_no_shadows(stage: Tab) -> None:
    small = "scale: { x: 0.01, y: 0.01, z: 0.01 }"
    many = f"{small}, points: Array.from({{ length: 40000 }}, () => ({{ x: 1.5, y: 1.5, z: 0 }}))"
    panel = boxes(stage, f"marker({{ {BOX} }})", f"marker({{ id: 1, type: 6, {many} }})")
    stage.evaluate("frames(3)")
    shade, lit = brightness(panel, SHADE, LIT)
    assert shade == lit
    emit(stage, "/t", "{ markers: [marker({ id: 1, action: 2 })] }")
    stage.evaluate("frames(3)")
    shade, lit = brightness(panel, SHADE, LIT)
    assert shade < 0.9 * lit
