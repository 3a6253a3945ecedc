"""Turn the content of a page into what the template shows: text, and rows of panels."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from markupsafe import Markup

from sitegen.errors import Problems
from sitegen.model import Markdown, Page, Site, Source, Widget
from sitegen.site.pages.source import shown
from sitegen.site.prose import Prose


@dataclass(frozen=True)
class Slot:
    """The place of a widget in the page: the `id` of its element, which page.json names too."""

    id: str
    kind: str


@dataclass(frozen=True)
class Panel:
    """Neighbouring widgets of one node, shown as one thing, or one that is about all nodes.

    `source` is the HTML of a file that stands beside them; there may be no slots then.
    """

    title: str
    slots: tuple[Slot, ...]
    source: str = ""


@dataclass(frozen=True)
class Block:
    """A stretch of the page: text, or a row of panels."""

    html: str = ""
    panels: tuple[Panel, ...] = ()


def blocks(site: Site, page: Page, prose: Prose, problems: Problems) -> Iterator[Block]:
    """Yield the content in its order; widgets in a row stand beside each other."""
    slots = {id(widget): slot for widget, slot in slots_of(page)}
    for are_text, parts in itertools.groupby(page.content, _is_text):
        if are_text:
            for part in parts:
                if isinstance(part, Markdown):
                    yield Block(Markup(prose.html(part)))
            continue
        row = [part for part in parts if not isinstance(part, Markdown)]
        groups = itertools.groupby(row, lambda part: part.target or id(part))
        panels = (_panel(list(group), slots, site, problems) for _, group in groups)
        yield Block(panels=tuple(panels))


def slots_of(page: Page) -> Iterator[tuple[Widget, Slot]]:
    """Yield the widgets of a page with their places.

    The id of a place says what is there, so that it stays the same when others come and go.
    """
    counts: Counter[str] = Counter()
    for widget in page.content:
        if isinstance(widget, Widget):
            name = "-".join(filter(None, ("widget", widget.kind, widget.target)))
            counts[name] += 1
            number = f":{counts[name]}" if counts[name] > 1 else ""
            yield widget, Slot(name + number, widget.kind)


def _is_text(part: Markdown | Widget | Source) -> bool:
    return isinstance(part, Markdown)


def _panel(
    parts: Sequence[Widget | Source], slots: dict[int, Slot], site: Site, problems: Problems
) -> Panel:
    widgets = [part for part in parts if isinstance(part, Widget)]
    sources = [part for part in parts if isinstance(part, Source)]
    title = parts[0].target or (widgets[0].kind.capitalize() if widgets else "")
    html = "".join(shown(source, site, problems) for source in sources)
    return Panel(title, tuple(slots[id(widget)] for widget in widgets), Markup(html))
