"""The paper of widgets: consoles are dark, and all others have that of the page."""

from __future__ import annotations

from typing import Literal

import pytest
from playwright.sync_api import Page as Tab
from stage import show

# The lightness (0 to 1) of the background that an element has or lies on, and of its text.
LIGHTNESS = """(element) => {
  const context = new OffscreenCanvas(1, 1).getContext("2d");
  const lightness = (colour) => {
    context.clearRect(0, 0, 1, 1);
    context.fillStyle = colour;
    context.fillRect(0, 0, 1, 1);
    const [red, green, blue, alpha] = context.getImageData(0, 0, 1, 1).data;
    return alpha < 255 ? undefined : (red + green + blue) / 765;
  };
  let at = element;
  while (lightness(getComputedStyle(at).backgroundColor) === undefined) at = at.parentElement;
  return [getComputedStyle(at).backgroundColor, getComputedStyle(element).color].map(lightness);
}"""
SCHEMES: tuple[Literal["light", "dark"], ...] = ("light", "dark")
PAPER = (
    *("3d", "actions", "bag", "diagnostics", "graph", "image", "joints", "lifecycle"),
    *("nodes", "parameters", "plot", "publish", "services", "teleop", "tf", "topics", "value"),
)


@pytest.mark.parametrize("kind", PAPER)
def test_panels_are_light_in_light_mode_and_dark_in_dark_mode(stage: Tab, kind: str) -> None:
    panel = show(stage, kind, {"value": {"path": "/a.b"}}.get(kind))
    for scheme in SCHEMES:
        stage.emulate_media(color_scheme=scheme)
        paper = int(scheme == "light")
        ground, ink = panel.evaluate(LIGHTNESS)
        assert abs(ground - paper) < 0.2, (kind, scheme)
        assert abs(ink - paper) > 0.7, (kind, scheme)


def test_the_log_is_dark_like_a_terminal(stage: Tab) -> None:
    panel = show(stage, "log")
    for scheme in SCHEMES:
        stage.emulate_media(color_scheme=scheme)
        ground, ink = panel.evaluate(LIGHTNESS)
        assert ground < 0.2
        assert ink > 0.7
