"""What the HTML of a page asks for itself, and that nothing is asked for twice."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from browser import Built, serving
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser
from rendered import render_site

from sitegen.config import load

SITE = """\
site: {title: T}
workspace: .
nodes: {talker: {package: cpp_pubsub, executable: talker}}
pages:
  - {path: /, title: Starts, content: [{console: talker}, {log: {}}]}
  - {path: waits/, title: Waits, content: [{buttons: talker}, {console: talker}]}
  - {path: text/, title: Text, content: [{markdown: Text}]}
"""
# Such browsers run the other build of each program.
WITHOUT_JSPI = "delete WebAssembly.Suspending; delete WebAssembly.promising;"
ASKS = re.compile(r'<link rel="(preload|modulepreload)"( as="fetch" crossorigin)? href="([^"]+)"')


@pytest.fixture
def asked(tmp_path: Path) -> dict[str, list[tuple[str, str]]]:
    """What the pages of SITE ask for, by their paths: how, and at which address."""
    (tmp_path / "site.yaml").write_text(SITE)
    shutil.copytree(ROOT / "demos/demo03/src", tmp_path / "src")
    found = {}
    for artifact in render_site(load(tmp_path / "site.yaml")):
        if artifact.path.endswith("index.html") and isinstance(artifact.source, bytes):
            links = ASKS.findall(artifact.source.decode())
            assert all((how == "preload") == bool(fetched) for how, fetched, _ in links)
            path = artifact.path.removesuffix("index.html")
            found[path] = [(how, address) for how, _, address in links]
    return found


def test_a_page_asks_for_what_starts_by_itself(asked: dict[str, list[tuple[str, str]]]) -> None:
    stem = "nodes/cpp_pubsub/talker.{}"
    assert asked[""] == [
        ("preload", "page.json"),
        # Of these, the browser takes two.
        ("preload", f"{stem.format('jspi')}.wasm"),
        ("modulepreload", f"{stem.format('jspi')}.js"),
        ("preload", f"{stem.format('asyncify')}.wasm"),
        ("modulepreload", f"{stem.format('asyncify')}.js"),
        ("modulepreload", "runtime/workers/cpp/cppNode.js"),
        ("modulepreload", "runtime/page/pageClient.js"),
        ("modulepreload", "runtime/shared.js"),
        ("modulepreload", "runtime/widgets/log.js"),
    ]


def test_a_program_that_waits_for_its_button_is_not_asked_for(
    asked: dict[str, list[tuple[str, str]]],
) -> None:
    assert asked["waits/"] == [("preload", "page.json")]
    assert asked["text/"] == []


@pytest.mark.firefox(always=True)
@pytest.mark.parametrize(("script", "kind"), [("", "jspi"), (WITHOUT_JSPI, "asyncify")])
def test_nothing_is_asked_for_twice_or_for_nothing(
    browser: Browser, built: Built, script: str, kind: str
) -> None:
    asked: list[str] = []
    with serving(built(ROOT), asked=asked) as url:
        context = browser.new_context()
        context.add_init_script(script)
        tab = context.new_page()
        tab.goto(f"{url}demo01/")
        Panel(tab, "talker").wait_for("Hello")
        tab.wait_for_load_state("networkidle")
        context.close()
    stem = f"nodes/cpp_hello/talker.{kind}"
    assert {name for name in map(unversioned, asked) if name.startswith("nodes/")} == {
        f"{stem}.js",
        f"{stem}.wasm",
    }
    # The icon is the logo, too, and some browsers ask for it once for each.
    twice = {path for path in asked if asked.count(path) > 1 and not path.endswith(".svg")}
    assert twice == set()


def unversioned(address: str) -> str:
    """An address without the version that page.json gives programs."""
    return address.partition("?")[0]
