"""Derive two readable colours from the author's: one for light paper and one for dark."""

from __future__ import annotations

import colorsys

# The backgrounds of the default theme on which text in the accent colour is hardest to read.
LIGHT, DARK = "#e6eaf4", "#232a3d"
# WCAG AA, with a margin for tints.
CONTRAST = 4.6


def shades(colour: str) -> tuple[str, str]:
    """Return `colour`, #rrggbb, darkened for text on light paper and lightened for dark paper."""
    return _readable(colour, LIGHT, -0.01), _readable(colour, DARK, 0.01)


def contrast(one: str, other: str) -> float:
    """Return the contrast of two colours as WCAG defines it, from 1 to 21."""
    a, b = sorted((_luminance(one), _luminance(other)), reverse=True)
    return (a + 0.05) / (b + 0.05)


def _readable(colour: str, paper: str, step: float) -> str:
    hue, lightness, saturation = colorsys.rgb_to_hls(*_channels(colour))
    while contrast(colour, paper) < CONTRAST and 0 <= lightness + step <= 1:
        lightness += step
        channels = colorsys.hls_to_rgb(hue, lightness, saturation)
        colour = "#" + "".join(f"{round(255 * channel):02x}" for channel in channels)
    return colour


def _luminance(colour: str) -> float:
    red, green, blue = (
        c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in _channels(colour)
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def _channels(colour: str) -> tuple[float, float, float]:
    red, green, blue = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    return red, green, blue
