"""What the build says of JavaScript cells, and what it puts into the site for them."""

from __future__ import annotations

import html
import io
import json
import re
from pathlib import Path
from textwrap import dedent

import pytest

from sitegen.commands.build import build
from sitegen.errors import SiteError
from sitegen.report import Report

CELL = """\
# Cells

```js ros
import { ros } from "sitegen";
console.log(ros.nodes());
```
"""
ROSLIB = """
```js ros
const roslib = import("sitegen/roslib");
```
"""


def built(folder: Path, text: str) -> Path:
    pages = "pages: [{path: /, file: page.md}, {path: other/, title: Other, content: []}]"
    (folder / "site.yaml").write_text(f"site: {{title: Cells}}\n{pages}\n")
    (folder / "page.md").write_text(dedent(text))
    build(folder, output=folder / "dist", report=Report(io.StringIO()))
    return folder / "dist"


@pytest.mark.parametrize(
    ("cell", "message"),
    [
        ("const a = 1;\nconst b = ;", "page.md:5: js ros: syntax error: near '='"),
        (
            "1;\nimport 'lodash';",
            "page.md:5: js ros: cells cannot import 'lodash'; they can",
        ),
        ("import './own.js';", "page.md:4: js ros: cells cannot import './own.js'"),
        ("await import('https://a.org/b.js');", "cells cannot import 'https://a.org/b.js'"),
    ],
)
def test_what_is_wrong_with_a_cell_is_said(tmp_path: Path, cell: str, message: str) -> None:
    with pytest.raises(SiteError) as raised:
        built(tmp_path, f"# Cells\n\n```js ros\n{cell}\n```\n")
    (line,) = raised.value.lines
    assert message in line


def test_a_page_with_a_cell_has_what_the_cell_needs(tmp_path: Path) -> None:
    dist = built(tmp_path, CELL)
    entry = json.loads((dist / "page.json").read_text())
    (widget,) = entry["widgets"]
    # The page itself takes no part in the graph.
    assert entry["nodes"] == {}
    assert "types" not in entry
    assert widget["kind"] == "javascript"
    assert widget["options"]["modules"] == {"sitegen": "client/client.js"}
    assert (dist / widget["options"]["interfaces"]).is_file()
    assert (dist / "runtime/workers/javascript/javascriptNode.js").is_file()
    assert (dist / "runtime/client/client.js").is_file()
    assert not (dist / "runtime/vendor/roslib.js").exists()
    page = html.unescape((dist / "index.html").read_text())
    policy = re.search(r"script-src [^;]*", page)
    assert policy
    assert "'self' blob: " in policy[0]
    assert "blob:" not in (dist / "other/index.html").read_text()


def test_modules_come_with_the_cells_that_import_them(tmp_path: Path) -> None:
    dist = built(tmp_path, CELL + ROSLIB)
    entry = json.loads((dist / "page.json").read_text())
    both = {"sitegen": "client/client.js", "sitegen/roslib": "vendor/roslib.js"}
    assert [one["options"]["modules"] for one in entry["widgets"]] == [both, both]
    assert (dist / "runtime/vendor/roslib.js").is_file()
    assert (dist / "runtime/vendor/licenses.txt").is_file()
