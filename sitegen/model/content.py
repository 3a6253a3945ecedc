"""The content of a page: text, widgets, sources and layouts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitegen.errors import Location
from sitegen.model.node import Node


@dataclass(frozen=True)
class Markdown:
    """Text of a page, written at `location`; links in it are relative to `folder`."""

    text: str
    folder: Path
    location: Location


@dataclass(frozen=True)
class Widget:
    """A live part of a page: its kind, the node that it is about ("" for all), its options."""

    kind: str
    target: str
    options: Mapping[str, object]
    location: Location

    @property
    def is_docked(self) -> bool:
        """Whether it has no place in the content, and opens at the bottom of the window."""
        return self.options.get("docked") is True

    @property
    def runs(self) -> Sequence[str]:
        """Return the names of the nodes that visitors start in a terminal or a notebook."""
        if self.kind in ("notebook", "jupyter"):
            return [str(self.options["node"])]
        names = self.options.get("nodes") if self.kind == "terminal" else None
        return names if isinstance(names, list) else ()


@dataclass(frozen=True)
class Source:
    """A source file that a page shows: one of the node `target`, or one without a node.

    `file` is the path as written, relative to the node's package or to `folder`; for a node, it may
    be empty. `lines` are the first and the last line to show; `region` names a marked part instead.
    """

    target: str
    file: str
    folder: Path
    location: Location
    lines: tuple[int, int] | None = None
    region: str = ""
    node: Node | None = None


@dataclass(frozen=True)
class Cell:
    """One cell of a layout and its content; `title` is that of a tab, or the part of a stage.

    `size` is its share of the width, relative to the sizes of the other cells.
    """

    content: tuple[Part, ...]
    title: str = ""
    size: int = 1


@dataclass(frozen=True)
class Layout:
    """Parts of a page arranged as `columns`, `rows`, a `grid`, `tabs`, a `stage` or an `example`.

    The cells of a stage are `nodes`, `show`, and `below` or `beside` for the consoles; those of an
    example are its YAML and its widgets.
    """

    kind: str
    cells: tuple[Cell, ...]
    location: Location


# The types that the content of a page consists of.
Leaf = Markdown | Widget | Source


Part = Leaf | Layout


def leaves(content: Iterable[Part], *, examples: bool = True) -> Iterator[Leaf]:
    """Yield the parts of `content` in order, with layouts replaced by what they contain.

    Without `examples`, those and what they contain are left out.
    """
    for part in content:
        if not isinstance(part, Layout):
            yield part
        elif examples or part.kind != "example":
            for cell in part.cells:
                yield from leaves(cell.content, examples=examples)
