"""Find the Python of a page's cells and notebooks, for those who read it without running it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitegen.config import ipynb, notebooks
from sitegen.errors import Location
from sitegen.model import Page, Widget

# Commands of IPython: `%run`, `!ls`, `?name`, `name?`.
COMMAND = re.compile(r"^(\s*)(?:[%!?].*|[\w.]+\?{1,2}\s*)$")
# Cells in another language, but for those whose content is Python.
OTHER = re.compile(r"\s*%%(?!time\b|timeit\b|capture\b|prun\b)")


@dataclass(frozen=True)
class CellSource:
    """The cells of one file that run in a node: their Python, and where each line is in the file.

    Commands of IPython and cells with a syntax error are left out.
    """

    node: str
    file: Path
    tree: ast.Module
    lines: Sequence[int]

    def location(self, line: int) -> Location:
        """Return where a line of `tree` is written."""
        return Location(self.file, self.lines[line - 1] if 0 < line <= len(self.lines) else 1)


def sources(root: Path, page: Page) -> Iterator[CellSource]:
    """Yield the Python of the cells of `page`, and of the notebooks of its JupyterLab."""
    widgets = [one for one in page.leaves if isinstance(one, Widget)]
    cells: dict[Path, list[tuple[str, Sequence[int]]]] = {}
    for one in widgets:
        if one.kind == notebooks.CELL:
            text = str(one.options["text"])
            lines = range(one.location.line, one.location.line + len(text.splitlines()))
            cells.setdefault(one.location.file, []).append((text, lines))
    for file, found in cells.items():
        yield _source(notebooks.INTERPRETER, file, found)
    folders = {one.options.get("notebooks") for one in widgets if one.kind == notebooks.KIND}
    for folder in sorted(str(each) for each in folders if each):
        for file in notebooks.files(root / folder):
            code = [one for one in ipynb.cells(file) if one.kind == "code"]
            yield _source(notebooks.KERNEL, file, [(one.text, one.lines) for one in code])


def _source(node: str, file: Path, cells: Iterable[tuple[str, Sequence[int]]]) -> CellSource:
    body: list[str] = []
    numbers: list[int] = []
    for text, lines in cells:
        plain = _plain(text)
        body += plain
        numbers += [lines[min(at, len(lines) - 1)] for at in range(len(plain))]
    return CellSource(node, file, ast.parse("\n".join(body)), numbers)


def _plain(text: str) -> list[str]:
    """Return the lines of a cell that are Python."""
    lines = text.splitlines()
    if OTHER.match(text):
        return [""] * len(lines)
    plain = [COMMAND.sub(r"\1pass", line) for line in lines]
    try:
        ast.parse("\n".join(plain))
    except (SyntaxError, ValueError):
        return [""] * len(lines)
    return plain
