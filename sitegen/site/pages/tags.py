"""Make the pages that list what has a tag."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from markdown.extensions.toc import slugify_unicode

from sitegen.errors import Location
from sitegen.model import Markdown, Page, Site
from sitegen.shipped import DEFAULT_THEME
from sitegen.site.pages.texts import texts


def with_tags(site: Site) -> Site:
    """Return the site with a page for each tag, and a page of all tags, in each language."""
    languages = (site.language, *site.languages)
    made = [page for language in languages for page in _pages(site, language)]
    return replace(site, pages=(*site.pages, *made)) if made else site


def links(site: Site) -> Callable[[Page], list[tuple[str, str]]]:
    """Return a function that returns the tags of a page and the paths of their pages."""

    def of(page: Page) -> list[tuple[str, str]]:
        language = page.language or site.language
        return [(tag, _path(tag, site, language)) for tag in page.tags]

    return of


def _pages(site: Site, language: str) -> Iterator[Page]:
    tagged: dict[str, list[Page]] = {}
    for page in site.pages:
        if (page.language or site.language) == language:
            for tag in page.tags:
                tagged.setdefault(tag, []).append(page)
    if not tagged:
        return
    said = texts((DEFAULT_THEME, site.theme), language)
    names = sorted(tagged, key=str.casefold)
    lines = [
        f"- [{_escaped(tag)}](/{_path(tag, site, language)}) ({len(tagged[tag])})" for tag in names
    ]
    yield _page(site, language, _path("", site, language), said.tags, lines)
    for tag in names:
        rows = [
            f"- [{_escaped(page.title)}](/{page.path})"
            + (f"<br>{_escaped(page.description)}" if page.description else "")
            for page in tagged[tag]
        ]
        yield _page(site, language, _path(tag, site, language), said.tagged.format(tag), rows)


def _path(tag: str, site: Site, language: str) -> str:
    start = "" if language == site.language else f"{language.lower()}/"
    name = slugify_unicode(tag.replace("+", "p").replace("#", "sharp"), "-") if tag else ""
    return f"{start}tags/{name}/" if name else f"{start}tags/"


def _page(site: Site, language: str, path: str, title: str, lines: list[str]) -> Page:
    location = Location(site.root / "site.yaml", 1)
    text = Markdown("\n".join(lines), site.root, location)
    own = "" if language == site.language else language
    return Page(path, title, "", {}, (text,), "", location, language=own, original=path)


def _escaped(text: str) -> str:
    return "".join(f"\\{letter}" if letter in "\\`*_{}[]()<>#+-.!|" else letter for letter in text)
