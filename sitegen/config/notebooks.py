"""Read notebooks: JupyterLab with a folder of them, or the cells of one on a page."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from sitegen import pagepath, workspace
from sitegen.config import ipynb
from sitegen.config.blocks import split
from sitegen.config.document import Value, read
from sitegen.config.files import locate
from sitegen.config.ipynb import SUFFIX
from sitegen.config.section import check, conforms
from sitegen.config.widgetkeys import WIDGETS
from sitegen.errors import Location, Problems, nearest
from sitegen.ignored import is_ignored
from sitegen.model import Layout, Markdown, Node, Part, Widget, leaves

KIND = "jupyter"
# The widget above the cells of a page.
CELLS = "notebook"
CELL = "cell"
# A cell of JavaScript, which runs alone.
JAVASCRIPT = "javascript"
# The node that runs the cells of notebooks; each notebook is a process of it.
KERNEL = "notebook"
# The node that the cells of a page share.
INTERPRETER = "cells"
PROGRAMS = {KIND: workspace.NOTEBOOK, CELLS: workspace.CELLS}


def jupyter(value: Value, problems: Problems, page: Path) -> Widget | None:
    """Return the widget that `value` describes; `page` is the folder of the page."""
    if value.kind == "nothing":
        options = {"node": KERNEL, "notebooks": None, "open": None, "page": None}
        return Widget(KIND, "", options, value.location)
    if value.kind != "mapping":
        message = f"expected its options or nothing, found {value.found}"
        like = f"jupyter: {{notebooks: {value.text or 'notebooks'}}}"
        problems.add(value.location, value.key, f"{message}; write it like '{like}'")
        return None
    section = check(value, WIDGETS[KIND], problems)
    given, opened = section.get("notebooks"), section.get("open")
    folder = locate(given, problems, folder=True, page=page) if given else None
    names = _notebooks(folder, problems) if folder else []
    if given and folder and not names:
        message = f"no notebook in '{given.text}'; add a file that ends in {SUFFIX}"
        problems.add(given.location, given.key, message)
    if opened and opened.text not in names and (folder or not given):
        advice = nearest(opened.text, names) if names else "add 'notebooks', their folder"
        problems.add(opened.location, opened.key, f"no notebook '{opened.text}'; {advice}")
    options = {
        "node": KERNEL,
        "notebooks": folder.relative_to(problems.root.resolve()).as_posix() if folder else None,
        "open": opened.text if opened else None,
        "page": pagepath.normalized(shown.text) if (shown := section.get("page")) else None,
    }
    return Widget(KIND, "", options, value.location)


def notebook(value: Value, problems: Problems, page: Path) -> Iterator[Part]:
    """Yield the text and the cells of the notebook or Markdown file that `value` names."""
    keys = WIDGETS[CELLS]
    if value.kind == "mapping":
        given = check(value, keys, problems).get("file")
    else:
        short = replace(keys[0], example=f"{CELLS}: guide.md")
        given = value if conforms(value, short, problems) else None
    file = locate(given, problems, page=page) if given else None
    if not given or not file:
        return
    if file.suffix == SUFFIX:
        if fault := ipynb.fault(file):
            problems.add(Location(file, 1), "notebook", fault)
            return
        parts = list(_cells(file))
    else:
        parts = list(_fences(file, problems))
    if not any(isinstance(part, Widget) for part in parts):
        message = f"no Python cell in '{given.text}'; write one between ```python and ```"
        problems.add(given.location, given.key, message)
    yield _buttons(given.location)
    yield from parts


def numbered(parts: Sequence[Part]) -> list[Part]:
    """Return the parts of a page with its cells numbered, those of each language from 1.

    Cells of Python share one interpreter. If they stand in the text of the page itself, the first
    of them gets buttons for all above it.
    """
    widgets = [one for one in leaves(parts) if isinstance(one, Widget)]
    cells = [one for one in widgets if one.kind == CELL]
    alone = [one for one in widgets if one.kind == JAVASCRIPT]
    if not cells and not alone:
        return [*parts]
    numbers = {id(one): number for kind in (cells, alone) for number, one in enumerate(kind, 1)}
    bare = not any(one.kind == CELLS for one in widgets)

    def made(parts: Iterable[Part]) -> Iterator[Part]:
        for part in parts:
            if isinstance(part, Layout):
                inside = (replace(one, content=tuple(made(one.content))) for one in part.cells)
                yield replace(part, cells=tuple(inside))
            elif isinstance(part, Widget) and part.kind == CELLS:
                yield replace(part, options={**part.options, "cells": len(cells)})
            elif id(part) in numbers and isinstance(part, Widget):
                if bare and part.kind == CELL and numbers[id(part)] == 1:
                    buttons = _buttons(part.location)
                    yield replace(buttons, options={**buttons.options, "cells": len(cells)})
                yield replace(part, options={**part.options, "number": numbers[id(part)]})
            else:
                yield part

    return list(made(parts))


def _buttons(location: Location) -> Widget:
    return Widget(CELLS, "", {"node": INTERPRETER, "cells": 0}, location)


def _fences(file: Path, problems: Problems) -> Iterator[Part]:
    """Yield the prose of a Markdown file, and its fences of Python as cells."""
    text = read(file, problems)
    for block in split(text or "", lambda info: info.split()[:1] == ["python"]):
        location = Location(file, 1 + block.line)
        if block.info is None:
            yield Markdown(block.text, file.parent, location)
        elif not block.closed:
            problems.add(location, "python", "this cell is not closed; close it with ```")
        else:
            yield cell(block.text, location)


def _cells(file: Path) -> Iterator[Part]:
    """Yield the cells of a Jupyter notebook, with the outputs that its author saved."""
    for saved in ipynb.cells(file):
        location = Location(file, saved.line)
        if saved.kind == "markdown":
            yield Markdown(saved.text, file.parent, location)
        else:
            yield cell(saved.text, location, saved.outputs)


def cell(text: str, location: Location, outputs: Sequence[Mapping[str, object]] = ()) -> Widget:
    """Return a cell with its Python, and the outputs that its author saved."""
    options: dict[str, object] = {"node": INTERPRETER, "text": text}
    return Widget(CELL, "", {**options, **({"outputs": outputs} if outputs else {})}, location)


def kernels(parts: Iterable[Part]) -> list[Node]:
    """Return the nodes that run the notebooks and cells among `parts`."""
    shown = [one for one in leaves(parts) if isinstance(one, Widget) and one.kind in PROGRAMS]
    found = {str(one.options["node"]): one for one in shown}
    return [
        Node(name, workspace.SITEGEN, PROGRAMS[one.kind], one.location)
        for name, one in found.items()
    ]


def _notebooks(folder: Path, problems: Problems) -> list[str]:
    """Return the notebooks of a folder, and report those that are not valid."""
    found = list(files(folder))
    for file in found:
        if fault := ipynb.fault(file):
            problems.add(Location(file, 1), "notebook", fault)
    return [file.relative_to(folder).as_posix() for file in found]


def files(folder: Path) -> Iterator[Path]:
    """Yield the notebooks of a folder, at any depth, without the copies that Jupyter keeps."""
    for file in sorted(folder.rglob(f"*{SUFFIX}")):
        if not any(is_ignored(name, at_root=False) for name in file.relative_to(folder).parts):
            yield file
