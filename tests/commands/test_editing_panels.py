"""An author's own panels while they are written: live, wrong, and with types for the editor."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from ownpanels import HEARD, write_site
from paths import ROOT
from playwright.sync_api import Page, expect
from served import Serving

from sitegen.__main__ import main
from sitegen.errors import SiteError

WRONG = {
    "export function show() {}": "1: panel: exports no function 'mount'; begin it with 'export",
    "export default function mount() {}": "1: panel: exports no function 'mount'; export it",
    "\nexport function mount() {\n  if (a {\n}\n": "3: panel: syntax error",
    "export const mount = 1;\nimport 'three';": "2: panel: 'three' is not a path; copy the library",
    "export const mount = 1;\nimport 'https://x.org/a.js';": "2: panel: 'https://x.org/a.js' is on",
    "import './lib/shortn.js';": "1: panel: no file './lib/shortn.js'; did you mean './lib/shorten",
    "import '../../up.js';": "1: panel: '../../up.js' is outside the folder of site.yaml",
    "import './dot.svg';": "1: panel: './dot.svg' is not a module; name it with new URL",
    "import './heard.js';": "1: panel: modules import each other: panels/heard.js →",
    "import './heard.css?v=1';": "1: panel: './heard.css?v=1' has a query",
}


@pytest.fixture
def site(tmp_path: Path) -> Path:
    folder = tmp_path / "site"
    write_site(folder)
    return folder


def test_an_edited_panel_is_exchanged_while_nodes_run(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    tab.goto(served.url)
    heard = tab.get_by_role("region", name="Heard")
    expect(heard.locator("li").nth(1)).to_be_visible()
    tab.evaluate("window.same = true")
    served.write("panels/heard.js", HEARD.replace("shorten(data)", "`new ${shorten(data)}`"))
    expect(heard.locator("li").last).to_contain_text("new world!")
    assert tab.evaluate("window.same") is True
    assert tab.evaluate("document.body.dataset.ended") == "heard"
    served.write("panels/lib/shorten.js", "export const shorten = ;\n")
    problem = "panels/lib/shorten.js:1: panel: syntax error"
    expect(tab.get_by_role("alert")).to_contain_text(problem)


@pytest.mark.parametrize("text", WRONG)
def test_what_is_wrong_is_said_with_its_line(
    text: str, site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (site / "panels/heard.js").write_text(text)
    assert main(["check", str(site)]) == 1
    assert f"panels/heard.js:{WRONG[text]}" in capsys.readouterr().err


def test_data_that_is_wrong_is_named(site: Path) -> None:
    (site / "panels/defaults.json").write_text('{\n "label": Wide}')
    with pytest.raises(SiteError, match=r"panels/defaults\.json:2: panel: not valid JSON"):
        from sitegen.commands.check import check
        from sitegen.report import Report

        check(site, Report())


def test_types_are_those_of_the_nodes(site: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["types", str(site)]) == 0
    assert "wrote panels/ros.d.ts" in capsys.readouterr().out
    text = (site / "panels/ros.d.ts").read_text()
    assert '"std_msgs/msg/String": { data: string };' in text
    assert '"tutorial_interfaces/srv/AddTwoInts_Request": { a: bigint, b: bigint };' in text
    if not shutil.which("node"):
        pytest.skip("the compiler of types needs node")
    shutil.rmtree(site / "src")

    def checked() -> str:
        compiler = ROOT / "node_modules/typescript/bin/tsc"
        flags = ["--allowJs", "--checkJs", "--noEmit", "--strict", "--module", "esnext"]
        flags += ["--moduleResolution", "bundler", "--target", "es2023", "--resolveJsonModule"]
        flags += ["--types", ""]
        found = subprocess.run(
            ["node", compiler, *flags, "panels/heard.js"],
            cwd=site,
            capture_output=True,
            text=True,
        )
        return found.stdout

    heard = site / "panels/heard.js"
    typed = HEARD.replace(".firstElementChild.remove", ".firstElementChild?.remove")
    typed = typed.replace('import "./heard.css";\n', "").replace("({ wide })", "({ wide = false })")
    heard.write_text(typed)
    (site / "panels/lib/shorten.js").write_text(
        "/** @param {string} text */\nexport const shorten = (text) => text;\n"
    )
    assert checked() == ""
    heard.write_text(typed.replace("({ data })", "({ date: data })"))
    assert "Property 'date' does not exist on type '{ data: string; }'" in checked()
    heard.write_text(typed.replace('"std_msgs/msg/String"', '"std_msgs/msg/Strin"'))
    assert "'\"std_msgs/msg/Strin\"' is not assignable" in checked()
