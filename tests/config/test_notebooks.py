"""Notebooks in site.yaml: what is wrong with them is said in one line each."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sitegen.config import ipynb, load
from sitegen.errors import SiteError
from sitegen.model import Markdown, Widget

CELLS = [
    {"cell_type": "markdown", "source": ["# Title\n", "text"]},
    {"cell_type": "code", "source": "1 + 1", "outputs": []},
]
VALID = {"nbformat": 4, "cells": CELLS}


def site(folder: Path, content: str, **notebooks: object) -> Path:
    for name, text in notebooks.items():
        file = folder / "notebooks" / f"{name}.ipynb"
        file.parent.mkdir(exist_ok=True)
        file.write_text(text if isinstance(text, str) else json.dumps(text))
    (folder / "site.yaml").write_text(
        f"site: {{title: Lab}}\npages:\n  - path: /\n    title: Lab\n    content:\n{content}"
    )
    return folder / "site.yaml"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("jupyter: {notebooks: notes}", "no folder 'notes'; did you mean 'notebooks'?"),
        ("jupyter: {notebooks: empty}", "no notebook in 'empty'; add a file that ends in .ipynb"),
        ("jupyter: {notebooks: notebooks, open: frist.ipynb}", "did you mean 'first.ipynb'?"),
        ("jupyter: {open: first.ipynb}", "add 'notebooks', their folder"),
        ("jupyter: first.ipynb", "write it like 'jupyter: {notebooks: first.ipynb}'"),
        ("jupyter: {notebook: notebooks}", "did you mean 'notebooks'?"),
        ("notebook: none.md", "no file 'none.md'"),
        ("notebook: prose.md", "no Python cell in 'prose.md'; write one between ```python and ```"),
        ("notebook: open.md", "open.md:4: python: this cell is not closed; close it with ```"),
        ("notebook: notebooks/old.ipynb", "old.ipynb:1: notebook: a notebook of format 3"),
        ("notebook: notebooks/broken.ipynb", "broken.ipynb:1: notebook: not a Jupyter notebook"),
        ("notebook: notebooks/other.ipynb", "it has no 'cells' and 'nbformat'"),
    ],
)
def test_what_is_wrong_is_said(tmp_path: Path, content: str, message: str) -> None:
    (tmp_path / "empty").mkdir()
    (tmp_path / "prose.md").write_text("# Prose\n")
    (tmp_path / "open.md").write_text("# Open\n\n```python\n1\n")
    notebooks = {"old": {"nbformat": 3, "cells": []}, "broken": "{", "other": []}
    file = site(tmp_path, f"      - {content}\n", first=VALID)
    for name, text in notebooks.items() if "notebooks/" in content else ():
        site(tmp_path, f"      - {content}\n", **{name: text})
    with pytest.raises(SiteError) as raised:
        load(file)
    assert message in "\n".join(raised.value.lines)


def test_a_notebook_becomes_text_and_cells(tmp_path: Path) -> None:
    file = site(tmp_path, "      - notebook: notebooks/first.ipynb\n", first=VALID)
    [page] = load(file).pages
    buttons, text, cell = page.content
    assert isinstance(buttons, Widget) and buttons.kind == "notebook"
    assert isinstance(text, Markdown) and text.text == "# Title\ntext"
    assert isinstance(cell, Widget) and cell.options["text"] == "1 + 1"
    assert cell.options["number"] == 1
    assert [(node.package, node.executable) for node in page.nodes.values()] == [
        ("sitegen", "cells")
    ]


def test_a_page_can_consist_of_jupyterlab(tmp_path: Path) -> None:
    file = site(tmp_path, "", first=VALID)
    file.write_text("site: {title: Lab}\npages: [{path: lab/, jupyter: {notebooks: notebooks/}}]\n")
    [page] = load(file).pages
    assert page.title == "JupyterLab"
    [lab] = page.content
    assert isinstance(lab, Widget) and lab.kind == "jupyter"
    assert lab.options["notebooks"] == "notebooks"
    assert list(page.nodes) == ["notebook"]


def test_the_name_of_the_kernel_is_taken(tmp_path: Path) -> None:
    file = site(tmp_path, "      - jupyter: {notebooks: notebooks}\n", first=VALID)
    nodes = "nodes:\n  notebook: {package: sitegen, executable: prompt}\n"
    file.write_text(nodes + file.read_text())
    with pytest.raises(SiteError, match="need the name 'notebook'; choose another"):
        load(file)


def test_cells_stand_in_the_text_of_a_page(tmp_path: Path) -> None:
    text = "Run it:\n\n```python ros\n1 + 1\n```\n\nNot this:\n\n```python\n2\n```\n\n"
    text += "```python ros\n3\n```\n"
    (tmp_path / "page.md").write_text(f"# Cells\n\n{text}")
    (tmp_path / "site.yaml").write_text("site: {title: A}\npages: [{path: /, file: page.md}]\n")
    [page] = load(tmp_path / "site.yaml").pages
    widgets = [part for part in page.content if isinstance(part, Widget)]
    assert [one.kind for one in widgets] == ["notebook", "cell", "cell"]
    assert [one.options.get("number") for one in widgets] == [None, 1, 2]
    assert [one.options.get("text") for one in widgets] == [None, "1 + 1", "3"]
    assert widgets[0].options["cells"] == 2
    assert widgets[1].location.line == 6
    assert page.level == "I5"


@pytest.mark.parametrize(
    ("fence", "message"),
    [
        ("```python ros later\n1\n```", "a cell must begin with 'python ros' alone, found 'later'"),
        ("```python ros\n```", "this cell is empty; write Python into it"),
        ("```js ros later\n1\n```", "a cell must begin with 'js ros' alone, found 'later'"),
        ("```javascript ros\n```", "this cell is empty; write JavaScript into it"),
        ("- ```js ros\n  1\n  ```", "cannot stand in a list"),
        ("```python ros\n1", "this block is not closed"),
        ("> ```python ros\n> 1\n> ```", "cannot stand in a list"),
    ],
)
def test_what_is_wrong_with_a_cell_is_said(tmp_path: Path, fence: str, message: str) -> None:
    (tmp_path / "page.md").write_text(f"# Cells\n\n{fence}\n")
    (tmp_path / "site.yaml").write_text("site: {title: A}\npages: [{path: /, file: page.md}]\n")
    with pytest.raises(SiteError) as raised:
        load(tmp_path / "site.yaml")
    assert message in "\n".join(raised.value.lines)


def test_the_cells_of_all_notebooks_of_a_page_have_different_numbers(tmp_path: Path) -> None:
    (tmp_path / "guide.md").write_text("```python\n1\n```\n")
    content = "      - notebook: notebooks/first.ipynb\n      - notebook: guide.md\n"
    [page] = load(site(tmp_path, content, first=VALID)).pages
    cells = [part for part in page.content if isinstance(part, Widget) and part.kind == "cell"]
    assert [cell.options["number"] for cell in cells] == [1, 2]


def test_a_cell_of_a_notebook_knows_its_line(tmp_path: Path) -> None:
    file = site(tmp_path, "", first=VALID).parent / "notebooks/first.ipynb"
    file.write_text(json.dumps(VALID, indent=1))
    lines = file.read_text().splitlines()
    markdown, code = ipynb.cells(file)
    assert [lines[number - 1].strip() for number in markdown.lines] == ['"# Title\\n",', '"text"']
    assert '"source": "1 + 1"' in lines[code.line - 1]
