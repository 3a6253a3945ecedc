"""Read the pages of a site again whose text alone has changed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from sitegen import config
from sitegen.build import Made
from sitegen.model import Markdown, Page


def edited(made: Made, changed: Sequence[Path]) -> Made | None:
    """Return the site with the current text of its pages; None if more than text has changed."""
    site = made.site
    fresh: dict[str, Page] = {}
    for file in {file.resolve() for file in changed}:
        pages = [page for page in site.pages if _says(page, file)]
        new = config.read_again(pages[0], site.root) if len(pages) == 1 else None
        if not new or new.file != file:
            return None
        fresh[new.path] = new
    if not fresh:
        return None
    site = replace(site, pages=tuple(fresh.get(page.path, page) for page in site.pages))
    rendered = [
        made.renderer.page(fresh[each.page.path]) if each.page.path in fresh else each
        for each in made.rendered
    ]
    artifacts = [*made.renderer.site_artifacts(rendered), *made.others]
    return replace(made, site=site, rendered=rendered, artifacts=artifacts)


def _says(page: Page, file: Path) -> bool:
    """Return whether `file` holds text of `page`: its own file, or one that its content names."""
    return any(part.location.file == file for part in page.leaves if isinstance(part, Markdown))
