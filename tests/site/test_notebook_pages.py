"""Each notebook of a JupyterLab is a page, too: without scripts, and with what its author saved."""

from __future__ import annotations

import base64
import json
import re
from pathlib import Path
from typing import Any

import pytest
from paths import ROOT
from rendered import render_site

from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.model import Site
from sitegen.site.jupyter import outputs, with_pages

SITE = """\
site: {title: Lab, language: LANGUAGE}
pages:
  - {path: lab/, title: Lab, content: [{jupyter: {notebooks: notebooks}}]}
MORE"""
PNG = base64.b64encode(b"\x89PNG").decode()
HTML = (
    '<style>td {color: red}</style><table border="1"><tr><td style="x" onclick="x()">cell</td></tr>'
    "</table>\n\n<script>alert(1)</script><a href='javascript:x()'>no</a>"
    "<a href='https://ros.org'>yes</a><img src='https://other.site/x.png'><unknown>in</unknown>"
)


def code(source: str, *saved: dict[str, Any]) -> dict[str, Any]:
    return {"cell_type": "code", "source": source.splitlines(keepends=True), "outputs": [*saved]}


def text(source: str, **more: Any) -> dict[str, Any]:
    return {"cell_type": "markdown", "source": source, **more}


def write(
    folder: Path, notebooks: dict[str, list[dict[str, Any]]], more: str = "", language: str = "en"
) -> Site:
    for name, cells in notebooks.items():
        file = folder / "notebooks" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps({"nbformat": 4, "cells": cells}, indent=1))
    written = SITE.replace("MORE", more).replace("LANGUAGE", language)
    (folder / "site.yaml").write_text(written)
    return with_pages(load(folder / "site.yaml"))


def pages(site: Site) -> dict[str, str]:
    found = {}
    for one in render_site(site):
        if one.path.endswith("/index.html"):
            assert isinstance(one.source, bytes)
            found[one.path] = one.source.decode()
    return found


def test_a_notebook_is_shown_with_its_outputs_and_leads_to_the_lab(tmp_path: Path) -> None:
    cells = [
        text("# First steps\nRead *this*."),
        code(
            "print(6 * 7)",
            {"output_type": "stream", "name": "stdout", "text": ["4<2>\n", "\n", "end\n"]},
            {"output_type": "display_data", "data": {"image/png": PNG, "text/plain": "a plot"}},
            {"output_type": "error", "traceback": ["\x1b[31mValueError\x1b[0m: no"]},
        ),
    ]
    site = write(tmp_path, {"first.ipynb": cells, "more/Two words.ipynb": [code("1")]})
    assert [page.path for page in site.pages] == ["lab/", "lab/first/", "lab/more/two-words/"]
    assert [page.title for page in site.pages] == ["Lab", "First steps", "Two words"]
    shown = pages(site)
    page = shown["lab/first/index.html"]
    assert '<a href="../../lab/?notebook=first.ipynb">Open in the lab</a>' in page
    assert page.index("First steps</h1>") < page.index("Open in the lab") < page.index("<em>this")
    assert 'class="code' in page and "print" in page
    assert '<pre class="saved-output stdout" tabindex="0">4&lt;2&gt;&#10;&#10;end</pre>' in page
    assert f'<img src="data:image/png;base64,{PNG}" alt="a plot"' in page
    assert '<pre class="saved-output error" tabindex="0">ValueError: no</pre>' in page
    assert "page.json" not in page
    deep = shown["lab/more/two-words/index.html"]
    assert 'href="../../../lab/?notebook=more/Two%20words.ipynb"' in deep
    assert '<a href="first/">First steps</a>' in shown["lab/index.html"]


def test_it_speaks_the_language_of_the_site(tmp_path: Path) -> None:
    site = write(tmp_path, {"first.ipynb": [text("# Anfang")]}, language="de")
    assert ">Im Labor öffnen</a>" in pages(site)["lab/first/index.html"]


def test_html_is_cleaned(tmp_path: Path) -> None:
    saved = {"output_type": "execute_result", "data": {"text/html": HTML, "text/plain": "plain"}}
    page = pages(write(tmp_path, {"a.ipynb": [code("table", saved)]}))["lab/a/index.html"]
    shown = page[page.index('<div class="saved-output">') :].partition("</main>")[0]
    assert "<td>cell</td>" in shown
    assert 'href="https://ros.org"' in shown
    for gone in ("<style", "style=", "onclick", "alert(1)", "javascript:", "other.site", "unknown"):
        assert gone not in shown
    assert ">in" in shown


def test_browsers_and_builds_keep_the_same_html() -> None:
    module = (ROOT / "sitegen/runtime/ui/cleanHtml.js").read_text()
    for name in ("TAGS", "WHOLE", "ATTRIBUTES"):
        [words] = re.findall(rf"const {name} = new Set\(\[(.*?)\]\)", module, re.S)
        assert {*re.findall(r'"(\w+)"', words)} == getattr(outputs, name)


def test_notebooks_link_to_each_others_pages(tmp_path: Path) -> None:
    cells = [
        text(
            "# A\n[next](b.ipynb) ![own](attachment:i.png)",
            attachments={"i.png": {"image/png": PNG}},
        )
    ]
    page = pages(write(tmp_path, {"a.ipynb": cells, "b.ipynb": [text("# B")]}))["lab/a/index.html"]
    assert '<a href="../../lab/b/">next</a>' in page
    assert f"data:image/png;base64,{PNG}" in page


def test_what_is_wrong_with_a_notebook_stops_no_build(tmp_path: Path) -> None:
    from sitegen.commands.check import check
    from sitegen.report import Report

    write(tmp_path, {"a.ipynb": [text("# A"), text("\n[gone](nowhere.md) <b style='x'>x</b>")]})
    _, warnings = check(tmp_path, Report())
    [link] = [line for line in warnings if "nowhere.md" in line]
    number = int(link.split(":")[1])
    lines = (tmp_path / "notebooks/a.ipynb").read_text().splitlines()
    assert link.startswith("notebooks/a.ipynb:")
    assert "nowhere.md" in lines[number - 2] or "nowhere.md" in lines[number - 1]


def test_paths_must_differ(tmp_path: Path) -> None:
    more = "  - {path: lab/a/, title: A, content: [{markdown: A}]}\n"
    with pytest.raises(SiteError, match="its page has the path 'lab/a/', as another one"):
        write(tmp_path, {"a.ipynb": [text("# A")]}, more)
