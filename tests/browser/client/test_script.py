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


def test_scripts_run_in_order_each_after_the_one_before(
    browser: Browser, serve: Serve, site: Path
) -> None:
    said = "document.body.dataset.said = (document.body.dataset.said ?? '') + "
    # The first ends last if they are not waited for.
    first = f"await new Promise(requestAnimationFrame);\n{said}'first ';\n"
    (site / "first.js").write_text(first)
    (site / "last.js").write_text(f"{said}'last';\n")
    (site / "site.yaml").write_text(
        SITE.replace("script: mine.js", "scripts: [first.js, mine.js, last.js]")
    )
    dist = build(site, "throw new RangeError('too far');\n")
    scripts = json.loads((dist / "page.json").read_text())["scripts"]
    assert [script["file"] for script in scripts] == ["first.js", "mine.js", "last.js"]
    html = (dist / "index.html").read_text()
    # Those that come later are not requested later.
    assert all(f'<link rel="modulepreload" href="{one["module"]}"' in html for one in scripts)
    tab = browser.new_page()
    tab.goto(serve(dist))
    tab.wait_for_selector("body[data-said='first last']")
    expect(tab.locator(".ros-word")).to_contain_text("mine.js: RangeError: too far")
    Panel(tab, "talker").wait_for("Publishing")


def test_all_scripts_together_are_waited_for_as_long_as_one(
    browser: Browser, serve: Serve, site: Path
) -> None:
    never = "await new Promise(() => {});\n"
    for name in ("first", "last"):
        (site / f"{name}.js").write_text(f"document.body.dataset.{name} = 'yes';\n{never}")
    (site / "site.yaml").write_text(
        SITE.replace("script: mine.js", "scripts: [first.js, mine.js, last.js]")
    )
    tab = browser.new_page()
    tab.clock.install()
    tab.goto(serve(build(site, never)))
    tab.wait_for_selector("body[data-first]")
    # From now on, time passes only here: what one script is waited for.
    tab.clock.pause_at(tab.evaluate("Date.now() + 1"))
    tab.clock.run_for(3000)
    tab.wait_for_selector("body[data-last]")
    tab.clock.resume()
    Panel(tab, "talker").wait_for("Publishing")


def test_only_pages_with_a_script_load_what_it_needs(tab: Tab, serve: Serve, site: Path) -> None:
    dist = build(site, "document.body.dataset.done = 'yes';\n")
    entry, plain = (json.loads((dist / f"{path}page.json").read_text()) for path in ("", "plain/"))
    assert {"scripts", "interfaces", "types"} <= set(entry)
    assert not {"scripts", "interfaces", "types", "messagesFrom"} & set(plain)
    assert not (dist / "runtime/rosbridge").exists()
    tab.goto(serve(dist))
    tab.wait_for_selector("body[data-done]")
    # A script that never ends holds nodes up for a short time only.
    tab.goto(serve(build(site, "await new Promise(() => {});\n")))
    Panel(tab, "talker").wait_for("Publishing")
