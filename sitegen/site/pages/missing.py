"""Make the page that a server shows where no page is: 404.html."""

from __future__ import annotations

from types import SimpleNamespace
from urllib.parse import urlsplit

from sitegen.errors import Location
from sitegen.model import Markdown, Page, Site

PATH = "404.html"


def missing(site: Site, said: SimpleNamespace) -> Page:
    """Return the page, in the language of the site; `said` is what its theme says.

    It is shown at any depth, so its addresses begin at the site's folder on the server: the path
    of `url`. A site that does not say where it lives is taken to have a server of its own, with its
    versions in folders.
    """
    home = next((page for page in site.pages if not page.path), site.pages[0])
    text = f"{said.missing_text}\n\n[{said.missing_home}](/{home.path})\n"
    location = Location(site.root / "site.yaml", 1)
    base = urlsplit(site.url).path or (f"/{site.version}/" if site.version else "/")
    content = (Markdown(text, site.root, location),)
    return Page(PATH, said.missing, "", {}, content, "", location, base=base)
