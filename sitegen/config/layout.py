"""Read columns, rows, grids, tabs and stages."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from sitegen.config.document import Value
from sitegen.config.schema import Key
from sitegen.config.section import check
from sitegen.config.widgetkeys import COLUMN, LAYOUTS, ROW, STAGE
from sitegen.errors import Location, Problems
from sitegen.model import Cell, Layout, Part, Widget

# The number of tabs that the themes have styles for.
MOST_TABS = 8
CONSOLES = ("below", "beside", "none")
# What shows the newest line of nodes over itself.
CAPTIONED = ("robot", "3d")
# Reads a list of content.
Items = Callable[[Value], Iterator[Part]]


def layout(
    kind: str, value: Value, items: Items, known: Callable[[Value], bool], problems: Problems
) -> Layout | None:
    """Return the layout of `kind` that `value` describes, and report what is wrong with it.

    `items` reads the content of a cell; `known` returns whether a node exists, and reports one that
    does not.
    """
    if kind == "stage":
        return _stage(value, items, known, problems)
    wanted, name = ("mapping", "titles") if kind == "tabs" else ("list", "a list")
    if value.kind != wanted:
        message = f"expected {name}, found {value.found}; write it like '{LAYOUTS[kind]}'"
        problems.add(value.location, value.label, message)
        return None
    if kind == "tabs":
        entries = value.entries(problems)
        if not 1 <= len(entries) <= MOST_TABS:
            message = f"expected 1 to {MOST_TABS} tabs, found {len(entries)}"
            problems.add(value.location, value.label, message)
        cells = [Cell(tuple(items(entry)), title) for title, entry in entries.items()]
    elif kind in ("columns", "rows"):
        keys = COLUMN if kind == "columns" else ROW
        cells = [_share(entry, keys, items, problems) for entry in value.items()]
    else:
        cells = [Cell((part,)) for part in items(value)]
    return Layout(kind, tuple(cells), value.location)


def _share(value: Value, keys: tuple[Key, ...], items: Items, problems: Problems) -> Cell:
    """Return a column or a row: a list of items, one of them, or a mapping with its size."""
    names = {key.name for key in keys}
    if value.kind == "mapping" and names & set(value.entries(problems)):
        section = check(value, keys, problems)
        content, size = section.get("content"), section.option("size")
        parts = tuple(items(content)) if content else ()
        return Cell(parts, size=size if isinstance(size, int) else 1)
    return Cell(tuple(items(value)))


def _stage(
    value: Value, items: Items, known: Callable[[Value], bool], problems: Problems
) -> Layout | None:
    section = check(value, STAGE, problems)
    show, nodes = section.get("show"), section.get("nodes")
    consoles = section.text("consoles")
    if consoles not in CONSOLES:
        message = f"unknown place '{consoles}'; write one of {', '.join(CONSOLES)}"
        problems.add(section.location("consoles"), section.label("consoles"), message)
    if not show or not nodes:
        return None
    names = [(node.text, node.location) for node in nodes.items() if known(node)]
    autostart = section.option("autostart")
    parts = tuple(items(show))
    if consoles == "below":
        parts = tuple(captioned(part, [name for name, _ in names]) for part in parts)
    return staged(parts, names, value.location, autostart=autostart, consoles=consoles)


def staged(
    show: tuple[Part, ...],
    nodes: Sequence[tuple[str, Location]],
    location: Location,
    *,
    autostart: object,
    consoles: str,
) -> Layout:
    """Return a stage at `location` that shows parts, with buttons and consoles of `nodes`."""
    options = {"autostart": autostart}
    buttons = tuple(Widget("buttons", name, options, at) for name, at in nodes)
    cells = [Cell(buttons, "nodes"), Cell(show, "show")]
    if consoles in ("below", "beside"):
        lines = {"lines": 1000}
        kept = tuple(Widget("console", name, lines, at) for name, at in nodes)
        cells.append(Cell(kept, consoles))
    return Layout("stage", tuple(cells), location)


def captioned(part: Part, nodes: Sequence[str]) -> Part:
    """Return `part`; if it shows what nodes move, it also shows the newest line of `nodes`.

    Their consoles may be folded, or far below it.
    """
    if not nodes or not isinstance(part, Widget) or part.kind not in CAPTIONED:
        return part
    return replace(part, options={**part.options, "captions": list(nodes)})
