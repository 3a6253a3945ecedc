"""Read notebooks: JupyterLab with a folder of them, or the cells of one on a page."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from sitegen import workspace
from sitegen.config.blocks import split
from sitegen.config.document import Value, read
from sitegen.config.files import locate
from sitegen.config.section import check, conforms
from sitegen.config.widgetkeys import WIDGETS
from sitegen.errors import Location, Problems, nearest
from sitegen.model import Markdown, Node, Part, Widget, leaves

KIND = "jupyter"
# The widget above the cells of a page.
CELLS = "notebook"
# The node that runs the cells of notebooks; each notebook is a process of it.
KERNEL = "notebook"
# The node that the cells of a page share.
INTERPRETER = "cells"
PROGRAMS = {KIND: workspace.NOTEBOOK, CELLS: workspace.CELLS}
SUFFIX = ".ipynb"
# What is shown of a saved value, by media type.
SHOWN = ("text/plain", "image/png", "image/jpeg", "image/svg+xml")
# The oldest format whose cells are a list.
FORMAT = 4


def jupyter(value: Value, problems: Problems, page: Path) -> Widget | None:
    """Return the widget that `value` describes; `page` is the folder of the page."""
    if value.kind == "nothing":
        options = {"node": KERNEL, "notebooks": None, "open": None}
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
        fault = _fault(file)
        if fault:
            problems.add(Location(file, 1), "notebook", fault)
            return
        parts = list(_cells(file, given.location))
    else:
        parts = list(_fences(file, problems))
    cells = sum(isinstance(part, Widget) for part in parts)
    if not cells:
        message = f"no Python cell in '{given.text}'; write one between ```python and ```"
        problems.add(given.location, given.key, message)
    yield Widget(CELLS, "", {"node": INTERPRETER, "cells": cells}, given.location)
    number = 0
    for part in parts:
        if isinstance(part, Widget):
            number += 1
            part = replace(part, options={**part.options, "number": number})
        yield part


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
            yield _cell(block.text, [], location)


def _cells(file: Path, location: Location) -> Iterator[Part]:
    """Yield the cells of a Jupyter notebook, with the outputs that its author saved."""
    for cell in json.loads(file.read_text(encoding="utf-8-sig"))["cells"]:
        if not isinstance(cell, dict):
            continue
        text = _joined(cell.get("source"))
        if cell.get("cell_type") == "markdown":
            yield Markdown(text, file.parent, Location(file, 1))
        elif cell.get("cell_type") == "code" and text.strip():
            outputs = cell.get("outputs")
            saved = outputs if isinstance(outputs, list) else []
            yield _cell(text, [one for each in saved for one in _shown(each)], location)


def _cell(text: str, outputs: list[dict[str, object]], location: Location) -> Widget:
    options: dict[str, object] = {"node": INTERPRETER, "text": text}
    return Widget("cell", "", {**options, **({"outputs": outputs} if outputs else {})}, location)


def _shown(output: object) -> Iterator[dict[str, object]]:
    """Yield an output of a saved cell as widgets/cell.js shows it."""
    if not isinstance(output, dict):
        return
    kind, data = output.get("output_type"), output.get("data")
    if kind == "stream":
        name = "stderr" if output.get("name") == "stderr" else "stdout"
        yield {"kind": name, "text": _joined(output.get("text")).rstrip("\n")}
    elif kind == "error":
        yield {"kind": "error", "text": "\n".join(map(str, output.get("traceback") or ()))}
    elif isinstance(data, dict):
        yield {
            "kind": "value",
            "data": {one: _data(one, data[one]) for one in SHOWN if one in data},
        }


def _data(kind: str, value: object) -> str:
    text = _joined(value)
    if kind == "image/svg+xml":
        return base64.b64encode(text.encode()).decode()
    return text if kind == "text/plain" else "".join(text.split())


def _joined(text: object) -> str:
    """Return a text of a notebook, which may be a list of lines."""
    return "".join(map(str, text)) if isinstance(text, list) else str(text or "")


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
    found = sorted(folder.rglob(f"*{SUFFIX}"))
    for file in found:
        if fault := _fault(file):
            problems.add(Location(file, 1), "notebook", fault)
    return [file.relative_to(folder).as_posix() for file in found]


def _fault(file: Path) -> str:
    try:
        notebook = json.loads(file.read_text(encoding="utf-8-sig"))
    except (OSError, ValueError, RecursionError):
        return "not a Jupyter notebook: it is not valid JSON; save it again in Jupyter"
    cells = notebook.get("cells") if isinstance(notebook, dict) else None
    version = notebook.get("nbformat") if isinstance(notebook, dict) else None
    if not isinstance(version, int) or not isinstance(cells, list):
        return "not a Jupyter notebook: it has no 'cells' and 'nbformat'; save it again in Jupyter"
    if version < FORMAT:
        return f"a notebook of format {version}; convert it with 'jupyter nbconvert --to notebook'"
    return ""
