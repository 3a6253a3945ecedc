"""Make a site installable as an app: its manifest and its icons."""

from __future__ import annotations

import functools
import hashlib
import io
import json
import re
from pathlib import Path
from typing import TYPE_CHECKING

from sitegen.model import Artifact, Site
from sitegen.site.pages.colours import shades
from sitegen.site.pages.preview import ACCENT, font, known

if TYPE_CHECKING:
    from PIL.Image import Image

MANIFEST = "manifest.webmanifest"
PAPER = "#ffffff"
SIZES = (192, 512)
# The part of an icon that is visible on every device, whatever shape it is cut to.
SAFE = 0.8


def artifacts(site: Site) -> list[Artifact]:
    """Return the manifest and the icons of a site that works without a network."""
    if not site.offline:
        return []
    icons = [(size, purpose) for size in SIZES for purpose in ("any", "maskable")]
    drawn = [(_drawn(site, size, purpose), size, purpose) for size, purpose in icons]
    paths = [f"media/icon-{size}.{_digest(icon)}.png" for icon, size, _ in drawn]
    manifest = {
        "name": site.title,
        "short_name": site.title if len(site.title) <= 12 else site.title.split()[0][:12],
        "description": site.description,
        "lang": site.language,
        "id": "./",
        "start_url": "./",
        "scope": "./",
        "display": "standalone",
        "background_color": PAPER,
        "theme_color": PAPER,
        "icons": [
            {"src": path, "sizes": f"{size}x{size}", "type": "image/png", "purpose": purpose}
            for path, (_, size, purpose) in zip(paths, drawn, strict=True)
        ],
    }
    written = json.dumps({key: value for key, value in manifest.items() if value}, indent=1)
    found = [Artifact(path, icon) for path, (icon, _, _) in zip(paths, drawn, strict=True)]
    return [Artifact(MANIFEST, written.encode()), *found]


def _drawn(site: Site, size: int, purpose: str) -> bytes:
    logo = site.look.logo
    # Pillow cannot draw SVG.
    if logo and logo.suffix.lower() != ".svg":
        return _png_of_logo(logo, size, purpose)
    return _png_of_letters(_initials(site.title), site.look.accent or ACCENT, size, purpose)


def _initials(title: str) -> str:
    """Return the first letters of the first two words of a title."""
    words = re.findall(r"\w+", known(title))
    return "".join(word[0].upper() for word in words[:2]) or "?"


@functools.cache
def _png_of_letters(letters: str, accent: str, size: int, purpose: str) -> bytes:
    from PIL import Image, ImageDraw

    # Drawn larger and reduced, which smooths the corners.
    large = 2 * size
    image = Image.new("RGBA", (large, large), (0, 0, 0, 0))
    draw = ImageDraw.Draw(image)
    box, colour = (0, 0, large - 1, large - 1), shades(accent)[0]
    if purpose == "maskable":
        draw.rectangle(box, fill=colour)
    else:
        draw.rounded_rectangle(box, radius=large // 5, fill=colour)
    room = large * (SAFE if purpose == "maskable" else 1)
    letter = font(round(room * (0.62 if len(letters) == 1 else 0.5)), "Bold")
    draw.text((large / 2, large / 2), letters, font=letter, fill="#ffffff", anchor="mm")
    return _png(image.resize((size, size)))


@functools.cache
def _png_of_logo(logo: Path, size: int, purpose: str) -> bytes:
    from PIL import Image, ImageOps

    paper = PAPER if purpose == "maskable" else (0, 0, 0, 0)
    image = Image.new("RGBA", (size, size), paper)
    room = round(size * (SAFE * 0.8 if purpose == "maskable" else 1))
    with Image.open(logo) as opened:
        drawn = ImageOps.contain(opened.convert("RGBA"), (room, room))
    image.alpha_composite(drawn, ((size - drawn.width) // 2, (size - drawn.height) // 2))
    return _png(image)


def _png(image: Image) -> bytes:
    file = io.BytesIO()
    image.save(file, "PNG")
    return file.getvalue()


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:10]
