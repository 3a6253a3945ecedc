"""How a page treats its script: what fails is told, and what it needs is loaded."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from browser import Serve
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, expect
from playwright.sync_api import Page as Tab

from sitegen.build import make, write
from sitegen.options import Options
from sitegen.report import Report

SITE = """\
site: {title: Mine}
nodes:
  talker: {package: cpp_chatter, executable: talker}
pages:
  - path: /
    title: Mine
    script: mine.js
    content:
      - buttons: {node: talker, autostart: true}
      - console: talker
      - panel: heard.js
  - path: plain/
    title: Plain
    content: [{buttons: talker}, {console: talker}]
"""
# A panel may import the module, too.
HEARD = """\
import { ros } from "sitegen";
export async function mount(element) {
  const { data } = await ros.topic("/chatter").next();
  element.textContent = data;
}
"""


@pytest.fixture
def site(tmp_path: Path) -> Path:
    folder = tmp_path / "site"
    shutil.copytree(ROOT / "demos/demo05/src", folder / "src")
    (folder / "site.yaml").write_text(SITE)
    (folder / "heard.js").write_text(HEARD)
    return folder


def build(site: Path, script: str) -> Path:
    (site / "mine.js").write_text(script)
    output = site.parent / "dist"
    made = make(site, Report(), options=Options(draft=True, engines=("jspi",)))
    write(made.artifacts, output)
    return output


def test_a_script_that_fails_is_named(browser: Browser, serve: Serve, site: Path) -> None:
    tab = browser.new_page()
    tab.goto(serve(build(site, "\nthrow new RangeError('too far');\n")))
    expect(tab.locator(".ros-word")).to_contain_text("mine.js: RangeError: too far")
    Panel(tab, "talker").wait_for("Publishing")
    expect(tab.get_by_role("region", name="Heard")).to_contain_text("Hello, world!")


def test_only_pages_with_a_script_load_what_it_needs(tab: Tab, serve: Serve, site: Path) -> None:
    dist = build(site, "document.body.dataset.done = 'yes';\n")
    entry, plain = (json.loads((dist / f"{path}page.json").read_text()) for path in ("", "plain/"))
    assert {"script", "interfaces", "types"} <= set(entry)
    assert not {"script", "interfaces", "types", "messagesFrom"} & set(plain)
    assert not (dist / "runtime/rosbridge").exists()
    tab.goto(serve(dist))
    tab.wait_for_selector("body[data-done]")
    # A script that never ends holds nodes up for a short time only.
    tab.goto(serve(build(site, "await new Promise(() => {});\n")))
    Panel(tab, "talker").wait_for("Publishing")
