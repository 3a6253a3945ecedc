"""3D views in a graph that does what the test says, and what their pixels show."""

from __future__ import annotations

import io
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from paths import ROOT
from PIL import Image
from playwright.sync_api import Locator
from playwright.sync_api import Page as Tab
from stage import show
from waiting import until

TYPES = sorted(
    {
        *("tf2_msgs/msg/TFMessage", "nav_msgs/msg/Path", "map_msgs/msg/OccupancyGridUpdate"),
        *(
            each
            for kind in json.loads((ROOT / "sitegen/bundles/displays.json").read_text()).values()
            for each in kind["types"]
        ),
    }
)
# Metres from the middle of the view to its upper edge.
REACH = 2.0
# Looks straight down on the origin.
ABOVE = {"top": True, "eye": [0, 0, 50], "target": [0, 0, 0], "zoom": 1 / REACH}
HELPERS = (Path(__file__).parent / "panels/messages.js").read_text()


def view(tab: Tab, *displays: dict[str, Any], **options: Any) -> Locator:
    """Show a 3D view from above; its fixed frame is `map`."""
    tab.evaluate(HELPERS)
    tab.evaluate(
        "(types) => { for (const type of types) ros.types[type] ??= ros.fields(''); }", TYPES
    )
    given = {"view": ABOVE, "frame": "map", "background": "#000000", "displays": list(displays)}
    return show(tab, "3d", {**given, **options})


def emit(tab: Tab, topic: str, message: str) -> None:
    """Let a message come, which is given as JavaScript."""
    tab.evaluate(f"async () => {{ ros.emit({topic!r}, {message}); await frames(3); }}")


def pixels(panel: Locator) -> Image.Image:
    """Return what the view shows now."""
    canvas = panel.locator(".ros-scene canvas")
    # The tools lie over it. The policy of pages forbids the screenshot's own styles.
    tools = panel.locator(".ros-scene-tools")
    tools.evaluate("(tools) => void (tools.style.visibility = 'hidden')")
    data = canvas.screenshot()
    tools.evaluate("(tools) => void (tools.style.visibility = '')")
    return Image.open(io.BytesIO(data)).convert("RGB")


def expect_colors(panel: Locator, colors: Mapping[tuple[float, float], str]) -> None:
    """Wait until points of the floor, in metres from the middle, have these colours."""

    def found() -> dict[tuple[float, float], str]:
        image = pixels(panel)
        return {(x, y): at(image, x, y) for x, y in colors}

    until(lambda: found() == colors, told=found)


def pixel(image: Image.Image, x: float, y: float) -> tuple[int, int, int]:
    """Return red, green and blue (0 to 255) at a point of the floor, in metres from the middle."""
    scale = image.height / (2 * REACH)
    place = (round(image.width / 2 + x * scale), round(image.height / 2 - y * scale))
    found = image.getpixel(place)
    assert isinstance(found, tuple)
    red, green, blue = found[:3]
    return red, green, blue


def at(image: Image.Image, x: float, y: float) -> str:
    """Return the colour at a point of the floor, in metres from the middle."""
    red, green, blue = pixel(image, x, y)
    if max(red, green, blue) < 40:
        return "black"
    names = {
        (1, 0, 0): "red",
        (0, 1, 0): "green",
        (0, 0, 1): "blue",
        (1, 1, 0): "yellow",
        (0, 1, 1): "cyan",
        (1, 0, 1): "magenta",
        (1, 1, 1): "white",
    }
    # Light makes colours darker or paler, and leaves which part is strong.
    limit = (max(red, green, blue) + min(red, green, blue)) / 2
    pale = max(red, green, blue) - min(red, green, blue) < 40
    strong = (1, 1, 1) if pale else (int(red > limit), int(green > limit), int(blue > limit))
    return names[strong]
