"""Show each notebook of a JupyterLab as a page: its text, its code and its saved outputs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from urllib.parse import quote

from sitegen.config import ipynb, notebooks
from sitegen.config.blocks import heading
from sitegen.config.paths import segment
from sitegen.errors import Location, Problems
from sitegen.model import Markdown, Page, Part, Site, Widget
from sitegen.shipped import DEFAULT_THEME
from sitegen.site.jupyter.outputs import shown
from sitegen.site.pages.texts import texts

# A heading of the first level at the start of a text.
_TITLE = re.compile(r"\s*#[ \t]+[^\n]*(?:\n|$)")


def with_pages(site: Site) -> Site:
    """Return the site with a page for each notebook of its labs, and links to these in the labs.

    Raises: SiteError if another page has the path of such a page.
    """
    problems = Problems(site.root)
    taken = {page.path for page in site.pages}
    found: list[Page] = []
    for page in site.pages:
        said = texts((DEFAULT_THEME, site.theme), page.language or site.language)
        own = [*_notebooks(site, page, said)]
        for one in own:
            if one.path in taken:
                message = f"its page has the path '{one.path}', as another one; rename the notebook"
                problems.add(one.location, "notebook", message)
            taken.add(one.path)
        found += [_with_links(page, own, said) if own else page, *own]
    problems.raise_if_any()
    return replace(site, pages=tuple(found))


def _notebooks(site: Site, page: Page, said: SimpleNamespace) -> Iterator[Page]:
    widgets = (one for one in page.leaves if isinstance(one, Widget))
    folders = {one.options.get("notebooks") for one in widgets if one.kind == notebooks.KIND}
    for folder in sorted(str(each) for each in folders if each):
        for file in notebooks.files(site.root / folder):
            yield _page(page, file, file.relative_to(site.root / folder), said)


def _page(lab: Page, file: Path, name: Path, said: SimpleNamespace) -> Page:
    segments = [segment(part) or "notebook" for part in name.with_suffix("").parts]
    path = f"{lab.path}{'/'.join(segments)}/"
    back = f"{'../' * len(segments)}?notebook={quote(name.as_posix())}"
    parts = [*_parts(file, f"[{said.notebook_open}]({back})")]
    titles = (heading(part.text) for part in parts)
    title = next(filter(None, titles), name.stem)
    location = Location(file, 1)
    return Page(path, title, "", {}, tuple(parts), "", location, language=lab.language)


def _parts(file: Path, link: str) -> Iterator[Markdown]:
    """Yield the cells as Markdown, with `link` after the title or at the top."""
    first = True
    for cell in ipynb.cells(file):
        location = Location(file, cell.line)
        text = cell.text
        if first and cell.kind == "markdown" and (title := _TITLE.match(text)):
            yield Markdown(title[0], file.parent, location)
            text = text[title.end() :]
        if first:
            yield Markdown(link, file.parent, location)
        first = False
        if cell.kind == "code":
            yield Markdown(_fenced(text), file.parent, location)
            for output in cell.outputs:
                yield Markdown(shown(output), file.parent, location)
        elif text.strip():
            yield Markdown(text, file.parent, location)
    if first:
        yield Markdown(link, file.parent, Location(file, 1))


def _fenced(code: str) -> str:
    """Return code in a fence that no line of it can close."""
    edge = max(re.findall("`{3,}", code), key=len, default="``") + "`"
    return f"{edge}python\n{code}\n{edge}"


def _with_links(page: Page, own: Iterable[Page], said: SimpleNamespace) -> Page:
    """Return the page of a JupyterLab with links to its notebooks below it."""
    depth = len(page.path)
    lines = [f"- [{_plain(one.title)}]({quote(one.path[depth:])})" for one in own]
    text = "\n".join([said.notebook_pages, "", *lines])
    folder = page.file.parent if page.file else page.location.file.parent
    below: Part = Markdown(text, folder, page.location)
    return replace(page, content=(*page.content, below))


def _plain(title: str) -> str:
    return re.sub(r"([\[\]\\`*_<>])", r"\\\1", title)
