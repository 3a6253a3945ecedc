"""Read Jupyter notebooks: their cells, with the outputs that their authors saved."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

SUFFIX = ".ipynb"
# What is shown of a saved value, by media type.
SHOWN = ("text/plain", "text/html", "image/png", "image/jpeg", "image/svg+xml")
TEXTS = ("text/plain", "text/html")
# The oldest format whose cells are a list.
FORMAT = 4


@dataclass(frozen=True)
class SavedCell:
    """A cell: `kind` is "markdown" or "code", and `lines` has the line of the file for each of its.

    `outputs` are in the form that widgets/cell.js shows.
    """

    kind: str
    text: str
    lines: Sequence[int]
    outputs: Sequence[Mapping[str, object]] = ()

    @property
    def line(self) -> int:
        """The line of the file where the cell begins."""
        return self.lines[0] if self.lines else 1


def fault(file: Path) -> str:
    """Return why `file` is no notebook that sitegen can read, or nothing."""
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


def cells(file: Path) -> Iterator[SavedCell]:
    """Yield the cells of a notebook that has no fault, without empty and raw ones."""
    text = file.read_text(encoding="utf-8-sig")
    at = 0
    for cell in json.loads(text)["cells"]:
        source = cell.get("source") if isinstance(cell, dict) else None
        lines, at = _lines(source, text, at)
        kind, joined = cell.get("cell_type") if lines else "", _joined(source)
        if kind not in ("markdown", "code") or not joined.strip():
            continue
        joined = _with_attachments(joined, cell.get("attachments"))
        outputs = cell.get("outputs")
        saved = outputs if isinstance(outputs, list) and kind == "code" else []
        yield SavedCell(kind, joined, lines, [one for each in saved for one in _shown(each)])


def _with_attachments(text: str, attachments: object) -> str:
    """Return the text of a cell with the images that are part of it as `data:` addresses."""
    for name, data in (attachments if isinstance(attachments, dict) else {}).items():
        for kind, value in (data if isinstance(data, dict) else {}).items():
            text = text.replace(f"(attachment:{name})", f"(data:{kind};base64,{_joined(value)})")
    return text


def _lines(source: object, text: str, at: int) -> tuple[list[int], int]:
    """Return the line of each line of `source` in `text`, from `at` on, and where the last ends."""
    found: list[int] = []
    for part in source if isinstance(source, list) else [source]:
        written = (json.dumps(part, ensure_ascii=escaped) for escaped in (False, True))
        places = [(text.find(one, at), len(one)) for one in written]
        place, size = min((one for one in places if one[0] >= 0), default=(at, 0))
        at = place + size
        number = text.count("\n", 0, place) + 1
        found += [number] * max(1, len(str(part or "").splitlines()))
    return found, at


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
    return text if kind in TEXTS else "".join(text.split())


def _joined(text: object) -> str:
    """Return a text of a notebook, which may be a list of lines."""
    return "".join(map(str, text)) if isinstance(text, list) else str(text or "")
