"""Draw the preview of a page for links on other sites (Open Graph), 1200 by 630 pixels."""

from __future__ import annotations

import functools
import hashlib
import importlib.resources
import io
from collections.abc import Iterator
from typing import TYPE_CHECKING

from sitegen.model import Artifact, Page, Site
from sitegen.site.pages.colours import shades

if TYPE_CHECKING:
    from PIL.ImageFont import FreeTypeFont

WIDTH, HEIGHT, MARGIN = 1200, 630, 84
PAPER, INK, QUIET = "#10141f", "#f4f6fb", "#a0aabf"
ACCENT = "#2b4bd8"
TITLE_SIZES = (96, 84, 70, 58)
ROWS = 3
# Increased when the drawing changes, because the name of a picture is a digest of its contents.
DESIGN = "1"


def path(site: Site, page: Page) -> str:
    """Return the path of the picture in `dist/`, which is a digest of what it shows."""
    shown = "\0".join((DESIGN, *_shown(site, page)))
    return f"media/preview.{hashlib.sha256(shown.encode()).hexdigest()[:10]}.png"


def artifact(site: Site, page: Page) -> Artifact:
    """Return the picture of a page."""
    return Artifact(path(site, page), _drawn(*_shown(site, page)))


def _shown(site: Site, page: Page) -> tuple[str, str, str, str]:
    name = "" if page.title == site.title else site.title
    return page.title, name, page.description, site.look.accent or ACCENT


@functools.cache
def _drawn(title: str, name: str, description: str, accent: str) -> bytes:
    # It takes a tenth of a second to load, and only sites with a url need it.
    from PIL import Image, ImageDraw

    image = Image.new("RGB", (WIDTH, HEIGHT), PAPER)
    draw = ImageDraw.Draw(image)
    colour = shades(accent)[1]
    draw.rectangle((0, 0, WIDTH, 14), fill=colour)
    _graph(draw, colour)
    if name:
        draw.text((MARGIN, 78), known(name), font=font(40, "Semibold"), fill=colour)
    size, rows = _fitting(known(title))
    y = 158
    for row in rows:
        draw.text((MARGIN, y), row, font=font(size, "Bold"), fill=INK)
        y += round(1.12 * size)
    for row in list(_wrapped(known(description), font(38), WIDTH - 2 * MARGIN))[:2]:
        draw.text((MARGIN, y + 26), row, font=font(38), fill=QUIET)
        y += 48
    file = io.BytesIO()
    image.quantize(64, dither=Image.Dither.NONE).save(file, "PNG", optimize=False)
    return file.getvalue()


def _graph(draw: object, colour: str) -> None:
    """Draw a small graph: two nodes and the topic between them."""
    x, y, step = WIDTH - MARGIN - 150, HEIGHT - 96, 75
    draw.line((x, y, x + 2 * step, y), fill=QUIET, width=4)  # type: ignore[attr-defined]
    for number, fill in enumerate((colour, PAPER, colour)):
        middle = x + number * step
        box = (middle - 17, y - 17, middle + 17, y + 17)
        draw.ellipse(box, fill=fill, outline=colour, width=5)  # type: ignore[attr-defined]


def _fitting(title: str) -> tuple[int, list[str]]:
    """Return the largest font size at which a title fits, and its lines."""
    for size in TITLE_SIZES:
        rows = list(_wrapped(title, font(size, "Bold"), WIDTH - 2 * MARGIN))
        if len(rows) <= ROWS:
            return size, rows
    return size, [*rows[: ROWS - 1], rows[ROWS - 1] + " …"]


def _wrapped(text: str, font: FreeTypeFont, width: int) -> Iterator[str]:
    row = ""
    for word in text.split():
        longer = f"{row} {word}".strip()
        if row and font.getlength(longer) > width:
            yield row
            row = word
        else:
            row = longer
    if row:
        yield row


def known(text: str) -> str:
    """Return the text without characters that the font lacks."""
    missing = _glyph("\uffff")
    return "".join(c for c in text if c.isspace() or _glyph(c) != missing)


@functools.cache
def _glyph(letter: str) -> bytes:
    return bytes(font(40).getmask(letter))


@functools.cache
def font(size: int, weight: str = "Regular") -> FreeTypeFont:
    """Return the font of previews."""
    from PIL import ImageFont

    # From PyPI, so that it is the same on every machine.
    folder = importlib.resources.files("font_source_sans_pro") / "files"
    return ImageFont.truetype(str(folder / f"SourceSansPro-{weight}.ttf"), size)
