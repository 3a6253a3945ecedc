"""The page whose nodes and panels are beside JupyterLab."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.model import Layout, Page, Widget

NOTEBOOK = json.dumps({"nbformat": 4, "cells": []})
SITE = """\
site: {title: Lab}
nodes:
  shell: {package: sitegen, executable: prompt}
pages:
  - {path: demo05/, title: Demo, content: [{markdown: "# Beside"}, {prompt: shell}, {topics: }]}
  - path: lab/
    LAB
  - {path: other/, title: Other, content: [{jupyter: {notebooks: notebooks}}]}
"""


def lab(folder: Path, written: str) -> Page:
    (folder / "notebooks").mkdir(exist_ok=True)
    (folder / "notebooks/a.ipynb").write_text(NOTEBOOK)
    (folder / "site.yaml").write_text(SITE.replace("LAB", written))
    return load(folder / "site.yaml").pages[1]


@pytest.mark.parametrize("name", ["demo05", "demo05/", "/demo05"])
def test_the_page_is_beside_the_lab_with_its_nodes(tmp_path: Path, name: str) -> None:
    page = lab(tmp_path, f"jupyter: {{notebooks: notebooks/, page: {name}}}")
    [split] = page.content
    assert isinstance(split, Layout) and split.kind == "columns"
    beside, lab_itself = split.cells
    kinds = [one.kind for one in beside.content if isinstance(one, Widget)]
    assert kinds == ["prompt", "topics"]
    assert [one.kind for one in lab_itself.content if isinstance(one, Widget)] == ["jupyter"]
    assert {*page.nodes} == {"shell", "notebook"}
    assert page.level == "I5"


def test_what_stands_around_the_lab_stays(tmp_path: Path) -> None:
    page = lab(
        tmp_path,
        "title: Lab\n    content:\n      - markdown: Above\n"
        "      - jupyter: {notebooks: notebooks, page: demo05}\n      - graph:\n",
    )
    _, split, below = page.content
    assert isinstance(split, Layout)
    assert isinstance(below, Widget) and below.kind == "graph"


def test_the_scripts_of_both_run(tmp_path: Path) -> None:
    for name in ("a.js", "b.js", "c.js"):
        (tmp_path / name).write_text("")
    front = "---\ntitle: Demo\nscripts: [a.js, b.js]\n---\n"
    (tmp_path / "demo.md").write_text(front + "```ros\n- topics:\n```\n")
    page = lab(
        tmp_path,
        "jupyter: {notebooks: notebooks, page: demo}\n    script: c.js\n    scripts: [b.js]\n"
        "  - {path: demo/, file: demo.md}",
    )
    assert page.scripts == ("a.js", "b.js", "c.js")


@pytest.mark.parametrize(
    ("written", "message"),
    [
        ("jupyter: {page: demo5}", "no page 'demo5/'; did you mean 'demo05/'?"),
        ("jupyter: {page: lab}", "a page cannot be beside itself"),
        ("jupyter: {page: other}", "'other/' shows JupyterLab itself; name a page without it"),
        (
            "jupyter: {page: demo05}\n    nodes: {shell: {package: sitegen, executable: prompt}}\n"
            "    title: Lab\n    content: [{prompt: shell}]",
            "'demo05/' and this page have different nodes 'shell'; rename one of them",
        ),
    ],
)
def test_what_is_wrong_is_said(tmp_path: Path, written: str, message: str) -> None:
    with pytest.raises(SiteError) as raised:
        lab(tmp_path, written)
    assert message in "\n".join(raised.value.lines)
