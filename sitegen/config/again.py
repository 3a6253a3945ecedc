"""Read a page again if only its text has changed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from sitegen.config import notebooks
from sitegen.config.blocks import front_matter
from sitegen.config.content import Reader
from sitegen.config.document import read
from sitegen.config.page import first_heading
from sitegen.errors import Location, Problems
from sitegen.model import Layout, Markdown, Page, Part, Widget

NOWHERE = Location(Path(), 0)


def read_again(page: Page, root: Path) -> Page | None:
    """Return `page` with the current text of its file; None if anything else changed or is wrong.

    The nodes, the title and the tags of a page affect other pages, too; its text does not.
    """
    if not page.file or any(_is_lab(part) for part in page.leaves):
        # A page with JupyterLab also lists its notebooks, which have pages of their own.
        return None
    problems = Problems(root)
    text = read(page.file, problems)
    front, body = front_matter(text or "")
    if not front.closed or front.text != page.front:
        return None
    reader = Reader(page.nodes, problems, Problems(root), page.file.parent)
    start = Location(page.file, 1 + body.line)
    content = tuple(notebooks.numbered([*reader.markdown(body.text, start, page.file.parent)]))
    if problems.found or _frame(content) != _frame(page.content):
        return None
    if first_heading(content) != first_heading(page.content):
        return None
    return replace(page, content=content)


def _is_lab(part: Part) -> bool:
    return isinstance(part, Widget) and part.kind == notebooks.KIND


def _frame(content: Iterable[Part]) -> list[Part]:
    """Return what surrounds the text, without line numbers, which change when text is edited."""
    return [_nowhere(part) for part in content if not isinstance(part, Markdown)]


def _nowhere(part: Part) -> Part:
    if not isinstance(part, Layout):
        return replace(part, location=NOWHERE)
    cells = (replace(cell, content=tuple(_frame(cell.content))) for cell in part.cells)
    return replace(part, cells=tuple(cells), location=NOWHERE)
