"""Make 404.html, the page that a server shows for an unknown address."""

from __future__ import annotations

from types import SimpleNamespace
from urllib.parse import urlsplit

from sitegen.errors import Location
from sitegen.model import Markdown, Page, Site

PATH = "404.html"


def missing(site: Site, said: SimpleNamespace) -> Page:
    """Return the page, in the language of the site; `said` has the texts of its theme.

    The server shows it at any depth, so its URLs start at the site's folder on the server: the path
    of `url`. Without `url`, the site is assumed to be at the root of its server, with its versions
    in folders.
    """
    home = next((page for page in site.pages if not page.path), site.pages[0])
    text = f"{said.missing_text}\n\n[{said.missing_home}](/{home.path})\n"
    location = Location(site.root / "site.yaml", 1)
    base = urlsplit(site.url).path or (f"/{site.version}/" if site.version else "/")
    content = (Markdown(text, site.root, location),)
    return Page(PATH, said.missing, "", {}, content, "", location, base=base)
