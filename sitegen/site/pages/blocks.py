"""Turn the content of a page into the blocks that the template shows: text and rows of panels."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from markupsafe import Markup

from sitegen.errors import Problems
from sitegen.model import Cell, Layout, Markdown, Page, Part, Site, Source, Widget
from sitegen.site.ownpanels import KIND as OWN
from sitegen.site.pages.source import shown
from sitegen.site.prose import Prose


@dataclass(frozen=True)
class Slot:
    """The place of a widget in the page: the `id` of its element, which page.json refers to."""

    id: str
    kind: str


@dataclass(frozen=True)
class Panel:
    """Neighbouring widgets of one node, shown as one panel, or a widget about all nodes.

    `source` is the HTML of a source file beside them; there may be no slots then. Panels of a page
    with the same title are numbered, because screen readers list them by these names.
    """

    title: str
    slots: tuple[Slot, ...]
    source: str = ""

    @property
    def edits(self) -> bool:
        """Whether it is an editor, which is named apart from the panel of the node's buttons."""
        return any(slot.kind == "editor" for slot in self.slots)


@dataclass(frozen=True)
class ShownCell:
    """A cell of a layout, ready to be shown: `title` and `size` are those of the Cell.

    `id` is the id of its tab, if it has one.
    """

    blocks: tuple[Block, ...]
    title: str
    size: int
    id: str


@dataclass(frozen=True)
class Block:
    """A block of the page: text, a row of panels, or a layout of the kind `layout`.

    A `docked` panel is not shown before a visitor needs it.
    """

    html: str = ""
    panels: tuple[Panel, ...] = ()
    docked: bool = False
    layout: str = ""
    cells: tuple[ShownCell, ...] = ()


def blocks(site: Site, page: Page, prose: Prose, problems: Problems) -> list[Block]:
    """Return the blocks of the content, in order; widgets in a row are shown side by side."""
    slots = {id(widget): slot for widget, slot in slots_of(page)}
    numbers = itertools.count(1)
    titles: Counter[tuple[str, bool]] = Counter()

    def numbered(panel: Panel, place: str) -> Panel:
        if not panel.slots:  # it has no name
            return panel
        name = place + panel.title, panel.edits
        titles[name] += 1
        count = titles[name]
        return replace(panel, title=f"{panel.title} {count}") if count > 1 else panel

    def made(content: Iterable[Part], place: str = "") -> Iterator[Block]:
        for kind, parts in itertools.groupby(content, _kind):
            if kind == "layout":
                yield from (laid_out(part) for part in parts if isinstance(part, Layout))
            elif kind == "text":
                texts = (part for part in parts if isinstance(part, Markdown))
                yield from (Block(Markup(prose.html(part))) for part in texts)
            else:
                row = [part for part in parts if isinstance(part, Widget | Source)]
                groups = itertools.groupby(row, lambda part: part.target or id(part))
                panels = (_panel(list(group), slots, site, problems) for _, group in groups)
                yield Block(
                    panels=tuple(numbered(panel, place) for panel in panels),
                    docked=kind == "docked",
                )

    def laid_out(part: Layout) -> Block:
        number = next(numbers)
        cells = tuple(
            ShownCell(
                tuple(made(cell.content, _place(part, cell))),
                cell.title,
                cell.size,
                f"layout-{number}-{index}",
            )
            for index, cell in enumerate(part.cells, start=1)
        )
        return Block(layout=part.kind, cells=cells)

    return list(made(page.content))


def flat(blocks: Iterable[Block]) -> Iterator[Block]:
    """Yield the text and the rows of panels of `blocks`, including those in layouts."""
    for block in blocks:
        if block.layout:
            for cell in block.cells:
                yield from flat(cell.blocks)
        else:
            yield block


def slots_of(page: Page) -> Iterator[tuple[Widget, Slot]]:
    """Yield the widgets of a page with their slots.

    The id of a slot describes its widget, so it stays the same when other widgets are added or
    removed.
    """
    counts: Counter[str] = Counter()
    for widget in page.leaves:
        if isinstance(widget, Widget):
            name = "-".join(filter(None, ("widget", widget.kind, widget.target)))
            counts[name] += 1
            number = f":{counts[name]}" if counts[name] > 1 else ""
            yield widget, Slot(name + number, widget.kind)


def _kind(part: Part) -> str:
    if isinstance(part, Widget) and part.is_docked:
        return "docked"
    return {Layout: "layout", Markdown: "text"}.get(type(part), "row")


def _place(part: Layout, cell: Cell) -> str:
    """Return a place whose panels have names of their own: the theme adds what they are."""
    return "consoles" if part.kind == "stage" and cell.title not in ("nodes", "show") else ""


def _panel(
    parts: Sequence[Widget | Source], slots: dict[int, Slot], site: Site, problems: Problems
) -> Panel:
    widgets = [part for part in parts if isinstance(part, Widget)]
    if any(widget.kind == "editor" for widget in widgets):
        for widget in widgets:
            if widget.kind == "buttons":
                message = f"the editor of '{widget.target}' starts and stops it; remove the buttons"
                problems.add(widget.location, "buttons", message)
    sources = [part for part in parts if isinstance(part, Source)]
    title = parts[0].target or (_name(widgets[0]) if widgets else "")
    html = "".join(shown(source, site, problems) for source in sources)
    return Panel(title, tuple(slots[id(widget)] for widget in widgets), Markup(html))


def _name(widget: Widget) -> str:
    """Return the name of a panel: the one that its author gave it, or its kind."""
    return str(widget.options["title"]) if widget.kind == OWN else widget.kind.capitalize()
