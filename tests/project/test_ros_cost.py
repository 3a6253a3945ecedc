"""What the module `sitegen` costs the pages that use it, in bytes as compressed by brotli."""

from __future__ import annotations

import json
from pathlib import Path
from urllib.parse import unquote, urlsplit

import brotli
import pytest
from browser import Serve
from playwright.sync_api import BrowserContext, Page

from sitegen.build import make, write
from sitegen.report import Report

SITE = """\
site: {title: Costs}
pages:
  - {path: /, title: None, content: [{markdown: Text.}]}
  - {path: script/, title: Script, script: mine.js, content: [{markdown: Text.}]}
  - {path: panel/, title: Panel, content: [{log: }]}
  - {path: both/, title: Both, script: mine.js, content: [{log: }]}
  - {path: terminal/, title: Terminal, content: [{terminal: }]}
"""
SCRIPT = """\
import { ros } from "sitegen";
await ros.topic("/mine", "std_msgs/String").publish({ data: "x" });
document.body.dataset.done = "yes";
"""
KB = 1000
# Somewhat more than they are; whoever needs more says why in the commit.
BESIDE_PANEL, BESIDE_CONSOLE = 22 * KB, 36 * KB
# What each page with a graph loads.
GRAPH = ("runtime/rosMain.js", "runtime/shared.js")


@pytest.fixture(scope="module")
def dist(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("costs")
    (folder / "site.yaml").write_text(SITE)
    (folder / "mine.js").write_text(SCRIPT)
    output = folder / "dist"
    write(make(folder, Report(), output=output).artifacts, output)
    return output


# What is there when a page has loaded all that it needs, by its path.
DONE = {"script/": "[data-done]", "panel/": ".ros-logged", "both/": "[data-done] .ros-logged"}


def loaded(dist: Path, serve: Serve, tab: Page, path: str) -> dict[str, int]:
    """Return the sizes of what a page loads besides its theme and its own files, by path."""
    asked: set[str] = set()
    tab.on("request", lambda request: asked.add(unquote(urlsplit(request.url).path)[1:]))
    tab.goto(serve(dist) + path)
    tab.wait_for_selector(DONE[path], state="attached")
    names = [name for name in asked if name.startswith(("runtime/", "interfaces/"))]
    return {name: len(brotli.compress((dist / name).read_bytes())) for name in names}


def test_what_a_script_costs(dist: Path, serve: Serve, context: BrowserContext) -> None:
    script, panel, both = (loaded(dist, serve, context.new_page(), path) for path in DONE)
    assert sum(both.values()) - sum(panel.values()) <= BESIDE_PANEL
    # A page with consoles has the others.
    assert sum(size for name, size in script.items() if name not in GRAPH) <= BESIDE_CONSOLE


def test_only_terminals_have_the_hashes_of_types(dist: Path) -> None:
    paths = [
        json.loads((dist / f"{path}page.json").read_text()) for path in ("script/", "terminal/")
    ]
    interfaces, options = paths[0]["interfaces"], paths[1]["widgets"][0]["options"]
    assert options["interfaces"] == interfaces
    assert "RIHS01" not in (dist / "script" / interfaces).read_text()
    hashes = json.loads((dist / "terminal" / options["hashes"]).read_text())
    assert hashes["std_srvs/srv/SetBool"].startswith("RIHS01_")
    assert hashes["std_msgs/msg/String"].startswith("RIHS01_")
