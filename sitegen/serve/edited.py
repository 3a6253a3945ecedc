"""Render again those pages of a site whose text alone has changed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from sitegen import config
from sitegen.build import Made
from sitegen.errors import Place
from sitegen.model import Markdown, Page

NOWHERE = Place(Path(), 0)


def edited(made: Made, folder: Path, changed: Sequence[Path]) -> Made | None:
    """Return the site with the text of pages as it is now, None if more than text has changed.

    What a page runs, is called or is tagged with concerns other files; its text only its own.
    """
    texts = {part.place.file.resolve() for page in made.site.pages for part in _texts(page)}
    if not changed or not {file.resolve() for file in changed} <= texts:
        return None
    site = replace(config.load(folder / "site.yaml"), offline=None)
    before = made.site
    if replace(site, pages=(), notes=()) != replace(before, pages=(), notes=()):
        return None
    if [_frame(page) for page in site.pages] != [_frame(page) for page in before.pages]:
        return None
    fresh = {
        page.path: made.renderer.page(page)
        for page, old in zip(site.pages, before.pages, strict=True)
        if page != old
    }
    rendered = [fresh.get(each.page.path, each) for each in made.rendered]
    artifacts = [*made.renderer.site_artifacts(rendered), *made.others]
    return replace(made, site=site, rendered=rendered, artifacts=artifacts)


def _texts(page: Page) -> list[Markdown]:
    return [part for part in page.content if isinstance(part, Markdown)]


def _frame(page: Page) -> Page:
    """Return a page without its text, and without lines, which move when text is written."""
    content = tuple(
        replace(part, place=NOWHERE) for part in page.content if not isinstance(part, Markdown)
    )
    nodes = {name: replace(node, place=NOWHERE) for name, node in page.nodes.items()}
    return replace(page, content=content, nodes=nodes, place=NOWHERE)
