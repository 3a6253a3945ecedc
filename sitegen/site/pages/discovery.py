"""Write the files by which pages are found: sitemap.xml, robots.txt, and a feed."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from urllib.parse import quote

from markupsafe import escape

from sitegen.model import Artifact, Page, Site

FEED = "feed.xml"
NEWEST = 30
XML = '<?xml version="1.0" encoding="utf-8"?>\n'


def artifacts(site: Site, changed: Mapping[Path, str]) -> list[Artifact]:
    """Return these files if the URL of the site is known; `changed` has the day of each source."""
    if not site.url:
        return []
    found = [
        Artifact("sitemap.xml", _sitemap(site, changed).encode()),
        Artifact(
            "robots.txt", f"User-agent: *\nAllow: /\nSitemap: {site.url}sitemap.xml\n".encode()
        ),
    ]
    if site.feed:
        found.append(Artifact(FEED, _feed(site).encode()))
    return found


def _sitemap(site: Site, changed: Mapping[Path, str]) -> str:
    rows = []
    for page in site.pages:
        day = changed.get(page.file, "") if page.file else ""
        last = f"<lastmod>{day}</lastmod>" if day else ""
        rows.append(f"<url><loc>{escape(url(site, page))}</loc>{last}</url>\n")
    schema = "http://www.sitemaps.org/schemas/sitemap/0.9"
    return f'{XML}<urlset xmlns="{schema}">\n{"".join(rows)}</urlset>\n'


def _feed(site: Site) -> str:
    """Return an Atom feed of the pages with a date, the newest first."""
    dated = sorted((page for page in site.pages if page.date), key=lambda page: page.path)
    dated = sorted(dated, key=lambda page: page.date, reverse=True)[:NEWEST]
    newest = dated[0].date if dated else "1970-01-01"
    entries = "".join(_entry(site, page) for page in dated)
    return (
        f'{XML}<feed xmlns="http://www.w3.org/2005/Atom" xml:lang="{escape(site.language)}">\n'
        f"<title>{escape(site.title)}</title>\n<id>{escape(site.url)}</id>\n"
        f'<link href="{escape(site.url)}"/>\n'
        f'<link rel="self" href="{escape(site.url + FEED)}"/>\n'
        f"<author><name>{escape(site.title)}</name></author>\n"
        f"<updated>{newest}T00:00:00Z</updated>\n{entries}</feed>\n"
    )


def _entry(site: Site, page: Page) -> str:
    address = escape(url(site, page))
    summary = f"<summary>{escape(page.description)}</summary>\n" if page.description else ""
    return (
        f"<entry>\n<title>{escape(page.title)}</title>\n<id>{address}</id>\n"
        f'<link href="{address}"/>\n<updated>{page.date}T00:00:00Z</updated>\n'
        f"{summary}</entry>\n"
    )


def url(site: Site, page: Page) -> str:
    """Return the address of a page on the web."""
    return site.url + quote(page.path)
