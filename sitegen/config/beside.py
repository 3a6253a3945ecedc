"""Put the nodes and panels of another page beside JupyterLab, as `page` asks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from sitegen.config.connect import KIND as CONNECT
from sitegen.config.notebooks import KIND
from sitegen.errors import Problems, nearest
from sitegen.model import Cell, Layout, Page, Part, Widget

# Shares of the width: a notebook needs more than the panels.
PANELS, LAB = 2, 3


def with_pages_beside(pages: Sequence[Page], problems: Problems) -> tuple[Page, ...]:
    """Return the pages; those whose JupyterLab names a page have its content, too."""
    known = {page.path: page for page in pages}
    return tuple(_page(page, known, problems) for page in pages)


def _page(page: Page, known: Mapping[str, Page], problems: Problems) -> Page:
    wanted = [lab for lab in _labs(page) if lab.options.get("page") is not None]
    for lab in wanted:
        other = _named(str(lab.options["page"]), page, known)
        if fault := _fault(page, other, known, str(lab.options["page"])):
            problems.add(lab.location, f"{KIND}.page", fault)
        elif other and lab is wanted[0]:
            page = _joined(page, other, lab)
    return page


def _labs(page: Page) -> list[Widget]:
    return [one for one in page.leaves if isinstance(one, Widget) and one.kind == KIND]


def _named(path: str, page: Page, known: Mapping[str, Page]) -> Page | None:
    """Return the page at `path`, in the language of `page` if there is a translation."""
    path = path.removeprefix("/")
    translated = known.get(f"{page.language.lower()}/{path}") if page.language else None
    return translated or known.get(path)


def _fault(page: Page, other: Page | None, known: Mapping[str, Page], written: str) -> str:
    if other is None:
        return f"no page '{written}'; {nearest(written, [path for path in known if path])}"
    if other is page:
        return "a page cannot be beside itself; add its widgets to 'content', or name another page"
    if _labs(other):
        return f"'{written}' shows JupyterLab itself; name a page without it"
    for name, node in other.nodes.items():
        mine = page.nodes.get(name)
        if mine and (mine.program, mine.location) != (node.program, node.location):
            return f"'{written}' and this page have different nodes '{name}'; rename one of them"
    if page.launch and other.launch:
        return f"'{written}' and this page have a launch file each; keep one of them"
    return ""


def _joined(page: Page, other: Page, lab: Widget) -> Page:
    """Return `page` with the content of `other` beside `lab`, and the nodes of both."""
    shown = other.content
    joins = any(isinstance(one, Widget) and one.kind == CONNECT for one in other.leaves)
    content = _without_connect(page.content) if joins else page.content
    return replace(
        page,
        content=tuple(_placed(content, shown, lab)),
        nodes={**other.nodes, **page.nodes},
        scripts=tuple(dict.fromkeys([*other.scripts, *page.scripts])),
        launch=page.launch or other.launch,
        connect=page.connect or other.connect,
    )


def _placed(parts: Iterable[Part], shown: Sequence[Part], lab: Widget) -> Iterator[Part]:
    for part in parts:
        if part is lab:
            cells = (Cell(tuple(shown), size=PANELS), Cell((lab,), size=LAB))
            yield Layout("columns", cells, lab.location)
        elif isinstance(part, Layout):
            inside = (
                replace(cell, content=tuple(_placed(cell.content, shown, lab)))
                for cell in part.cells
            )
            yield replace(part, cells=tuple(inside))
        else:
            yield part


def _without_connect(parts: Iterable[Part]) -> list[Part]:
    """Return the parts without the widget for gateways, which the other page shows."""
    return [one for one in parts if not (isinstance(one, Widget) and one.kind == CONNECT)]
