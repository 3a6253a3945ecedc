"""How one looks at a 3D view: the camera, what was framed, and the ground."""

from __future__ import annotations

from typing import Literal

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from scenes import at, emit, pixel, pixels, view
from stage import add, show
from waiting import until


def test_the_page_scrolls_until_the_view_is_selected(stage: Tab) -> None:
    """By the wheel and by a finger; the view says how it is moved."""
    panel = view(stage, {"kind": "grid"})
    stage.evaluate("document.body.style.paddingBlockEnd = '3000px'")
    box = panel.locator("canvas").bounding_box()
    assert box
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    note = panel.locator(".ros-scene-note")
    client = stage.context.new_cdp_session(stage)
    client.send("Emulation.setTouchEmulationEnabled", {"enabled": True})

    def swipe() -> None:
        kinds = ["touchStart", *["touchMove"] * 12]
        for step, kind in enumerate(kinds):
            finger = {"x": middle[0], "y": middle[1] - 12 * step}
            client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [finger]})
        client.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    stage.mouse.move(*middle)
    stage.mouse.wheel(0, 50)
    expect(note).to_have_text("Click the view to zoom with the wheel")
    # Browsers scroll smoothly; this is its end.
    stage.wait_for_function("scrollY === 50")
    stage.evaluate("scrollTo(0, 0)")
    panel.locator("canvas").focus()
    before = stage.evaluate("ros.kept().view")
    swipe()
    changed = "(view) => JSON.stringify(ros.kept().view) !== JSON.stringify(view)"
    stage.wait_for_function(changed, arg=before)
    assert stage.evaluate("scrollY") == 0
    panel.locator("summary").focus()
    swipe()
    stage.wait_for_function("scrollY > 100")
    expect(note).to_have_text("Tap the view, then move it with one finger")


def test_the_camera_is_moved_by_keys(stage: Tab) -> None:
    panel = view(stage, {"kind": "axes", "length": 1, "radius": 0.2})
    assert at(pixels(panel), 0.7, 0) == "red"
    panel.locator("canvas").press("ArrowRight")
    moved = stage.evaluate("ros.kept().view")
    assert moved["target"][0] > 0
    panel.locator("canvas").press("+")
    assert stage.evaluate("ros.kept().view.zoom") > moved["zoom"]
    panel.get_by_role("button", name="Top").click()
    assert stage.evaluate("ros.kept().view.top") is False


def test_a_view_fills_the_screen(stage: Tab) -> None:
    panel = view(stage, {"kind": "grid"})
    canvas = panel.locator("canvas")
    before = canvas.bounding_box()
    panel.get_by_role("button", name="Full screen").click()
    stage.wait_for_function("() => document.fullscreenElement?.className === 'ros-panel'")
    stage.evaluate("frames()")
    after = canvas.bounding_box()
    assert before
    assert after
    assert after["height"] > before["height"] * 1.2
    panel.get_by_role("button", name="Full screen").click()
    stage.wait_for_function("() => !document.fullscreenElement")
    # Where browsers refuse, it fills the window.
    stage.evaluate("() => { Element.prototype.requestFullscreen = async () => { throw 0; }; }")
    panel.get_by_role("button", name="Full screen").click()
    expect(stage.locator(".ros-panel")).to_have_class("ros-panel ros-filling")
    panel.get_by_role("button", name="Full screen").click()
    expect(stage.locator(".ros-panel")).to_have_class("ros-panel")


def test_a_view_begins_from_above_if_asked(stage: Tab) -> None:
    panel = show(stage, "3d", {"top": True, "displays": [{"kind": "grid"}]})
    expect(panel.get_by_role("button", name="Top")).to_have_attribute("aria-pressed", "true")


@pytest.mark.parametrize(("scheme", "dark"), [("light", True), ("dark", False)])
def test_white_is_ink_on_the_ground_of_the_theme(
    stage: Tab, scheme: Literal["light", "dark"], dark: bool
) -> None:
    """White is what RViz begins with, and it would not be seen on a light ground."""
    stage.emulate_media(color_scheme="dark" if scheme == "light" else "light")
    panel = view(stage, {"kind": "point_cloud", "topic": "/t", "size": 0.1}, background=None)
    add(stage, "publisher", "/scanner", "/t", "sensor_msgs/msg/PointCloud2")
    emit(stage, "/t", "cloud(square(1, 0))")
    # What is drawn follows the page, and so does the ground.
    stage.emulate_media(color_scheme=scheme)

    def contrast() -> int:
        image = pixels(panel)
        point, ground = (sum(pixel(image, x, 0)) for x in (1, -1))
        return ground - point if dark else point - ground

    until(lambda: contrast() > 300, told=contrast)


def test_a_narrow_panel_shows_what_was_framed(stage: Tab) -> None:
    """A box at the edge of the view in the proportions of RViz's window."""
    stage.set_viewport_size({"width": 300, "height": 900})
    framed = {"top": False, "eye": [-5, 0, 0.1], "target": [0, 0, 0], "zoom": 1}
    panel = view(stage, {"kind": "markers", "topic": "/t"}, view=framed)
    add(stage, "publisher", "/robot", "/t", "visualization_msgs/msg/Marker")
    emit(stage, "/t", "marker({ pose: pose(0, -2.3), scale: { x: 0.3, y: 0.6, z: 0.6 } })")

    def red() -> int:
        data = pixels(panel).tobytes()
        points = zip(data[::3], data[1::3], data[2::3], strict=True)
        return sum(r > 100 and g < 60 and b < 60 for r, g, b in points)

    until(red)
    # It is the author's, and not a part of links, until the visitor moves it.
    assert not stage.evaluate("ros.kept().view")
    panel.locator("canvas").press("ArrowLeft")
    assert stage.evaluate("ros.kept().view")


def test_what_is_seen_from_above_fills_the_view(stage: Tab) -> None:
    panel = view(stage, {"kind": "markers", "topic": "/t"}, view=None)
    add(stage, "publisher", "/robot", "/t", "visualization_msgs/msg/Marker")
    emit(stage, "/t", "marker({ pose: pose(3, 1), scale: { x: 4, y: 2, z: 0.1 } })")
    panel.get_by_role("button", name="Top").click()

    def filled() -> float:
        image = pixels(panel)
        column = image.getchannel("R").crop(
            (image.width // 2, 0, image.width // 2 + 1, image.height)
        )
        return sum(value > 60 for value in column.tobytes()) / image.height

    until(lambda: 0.86 < filled() < 0.94, told=filled)


def test_the_floor_fades_towards_its_edge(stage: Tab) -> None:
    grid = {"kind": "grid", "cells": 4, "size": 1, "color": "#ffffff", "alpha": 1}
    panel = view(stage, grid)

    def brightness() -> list[int]:
        image = pixels(panel)
        near = [[pixel(image, x, y / 100)[0] for y in range(-3, 4)] for x in (0.2, 1.3, 1.9)]
        return [max(each) for each in near]

    def fades() -> bool:
        middle, way, edge = brightness()
        return middle > way + 30 and way > edge + 30

    until(fades, told=brightness)
