"""Read the colours, fonts, logo and footer of a site."""

from __future__ import annotations

from pathlib import Path

from sitegen.config.files import locate
from sitegen.config.section import Section
from sitegen.errors import Problems
from sitegen.model import Look, Markdown

FONTS = (".woff2", ".woff", ".ttf", ".otf")
IMAGES = (".svg", ".png", ".webp", ".jpg", ".jpeg", ".gif", ".avif")


def look(site: Section, problems: Problems) -> Look:
    """Return the look of the site; invalid values are left out."""
    footer = site.get("footer")
    logo = site.get("logo")
    if logo and not logo.text.lower().endswith(IMAGES):
        message = (
            f"'{logo.text}' is not a supported image; use a file that ends in {', '.join(IMAGES)}"
        )
        problems.add(logo.location, logo.key, message)
    return Look(
        accent=site.text("accent").lower(),
        font=_font("font", site, problems),
        code_font=_font("code_font", site, problems),
        logo=locate(logo, problems) if logo else None,
        footer=Markdown(footer.text, problems.root, footer.text_start) if footer else None,
    )


def _font(name: str, site: Section, problems: Problems) -> Path | str:
    """Return a font file, or font names in CSS syntax that cannot end the CSS rule."""
    given = site.get(name)
    if given is None:
        return ""
    if given.text.lower().endswith(FONTS):
        return locate(given, problems) or ""
    if any(letter in given.text for letter in "{};<>\\/@"):
        message = f"'{given.text}' is not a valid list of fonts; write it like 'Georgia, serif'"
        problems.add(given.location, given.key, message)
    return given.text
