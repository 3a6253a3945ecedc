"""Scripts of pages: what is wrong with them, and their types for the editor."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from paths import ROOT
from playwright.sync_api import Page, expect
from served import Serving

from sitegen import config
from sitegen.__main__ import main
from sitegen.build import make
from sitegen.errors import SiteError
from sitegen.report import Report

SITE = """\
site: {title: Mine}
pages:
  - path: /
    title: Mine
    script: scripts/mine.js
    content: [{markdown: Text}]
"""
SCRIPT = """\
// @ts-check
import { ros } from "sitegen";
import { transportFactory } from "sitegen/rosbridge";
import { Ros, ROS2TFClient, Topic } from "sitegen/roslib";

const chatter = ros.topic("/chatter", "std_msgs/msg/String");
for await (const { data } of chatter) console.log(data.length);
chatter.publish({ data: "a" });
const { sum } = await ros.service("/add", "example_interfaces/srv/AddTwoInts").call({ a: 1n });
/** @type {bigint} */
const checked = sum;
const goal = await ros.action("/f", "example_interfaces/action/Fibonacci").send({ order: 3 });
for await (const { sequence } of goal.feedback()) console.log(sequence[0], checked);
const { translation } = await ros.tf.lookup("world", "map", { time: { sec: 1, nanosec: 0 } });
const node = ros.node("/mine", { parameters: { speed: 1 }, signal: AbortSignal.timeout(9) });
const speed = node.declare("speed", 0.5, { type: "double", accept: (value) => value > 0 });
const names = node.declare("names", undefined, { type: "string_array" });
node.timer(100, ({ sec }) => node.log.info(`${sec}: ${speed.value} ${names.value}`));
for await (const value of speed.changes()) speed.value = Number(value) + 1;
node.topic("~/state", "std_msgs/msg/String", "sensor_data").advertise();
chatter.subscribe(() => {}, { qos: { reliability: "best_effort", depth: 1 } });
const link = new Ros({ transportFactory });
link.on("connection", () => link.getTopics(({ topics }) => topics.map((name) => name.length)));
/** @type {Topic<{ data: string }>} */
const mine = new Topic({ ros: link, name: "/mine", messageType: "std_msgs/String" });
mine.subscribe(({ data }) => mine.publish({ data: data.trim() }));
new ROS2TFClient({ ros: link }).subscribe("map", (transform) => transform.translation.x);
export default [translation.x, (await goal.result()).sequence, transportFactory];
"""
WRONG = {
    "import { ros } from 'sitegn';": "'sitegn' is not a path",
    "import '/roslib.js';": "copy the library into this site and import './roslib.js'",
    "import { ros } from 'sitegen/ros';": "no module 'sitegen/ros'; did you mean 'sitegen",
    "import { Ros } from 'sitegen/roslb';": "no module 'sitegen/roslb'; did you mean 'sitegen/ros",
    "import 'https://x.org/a.js';": "'https://x.org/a.js' is on another site",
    "const a = ;": "syntax error",
}


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "site.yaml").write_text(SITE)
    (tmp_path / "scripts").mkdir()
    (tmp_path / "scripts/mine.js").write_text(SCRIPT)
    return tmp_path


@pytest.mark.parametrize("text", WRONG)
def test_what_is_wrong_is_said_with_its_line(
    text: str, site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (site / "scripts/mine.js").write_text(f"\n{text}\n")
    assert main(["check", str(site)]) == 1
    found = capsys.readouterr().err
    assert "scripts/mine.js:2: script: " in found
    assert WRONG[text] in found


@pytest.mark.parametrize(
    ("written", "fault"),
    [
        ("scripts/none.js", "site.yaml:5: pages[0].script: no file 'scripts/none.js'; did you"),
        ("site.yaml", "site.yaml:5: pages[0].script: 'site.yaml' is not a module; name a '.js'"),
        ("../a.js", "site.yaml:5: pages[0].script: '../a.js' is outside the site's folder"),
    ],
)
def test_the_key_names_a_module(site: Path, written: str, fault: str) -> None:
    (site / "site.yaml").write_text(SITE.replace("scripts/mine.js", written))
    with pytest.raises(SiteError) as error:
        config.load(site / "site.yaml")
    assert error.value.lines[0].startswith(fault)


MORE = """\
site: {title: Mine}
pages:
  - path: /
    title: Mine
    scripts:
      - scripts/mine.js
      - WRITTEN
    content: [{markdown: Text}]
"""


@pytest.mark.parametrize(
    ("written", "fault"),
    [
        ("scripts/mime.js", "no file 'scripts/mime.js'; did you mean 'scripts/mine.js'?"),
        ("site.yaml", "'site.yaml' is not a module; name a '.js' file"),
    ],
)
def test_each_of_a_list_is_a_module(site: Path, written: str, fault: str) -> None:
    (site / "site.yaml").write_text(MORE.replace("WRITTEN", written))
    with pytest.raises(SiteError) as error:
        config.load(site / "site.yaml")
    assert error.value.lines == [f"site.yaml:7: pages[0].scripts[1]: {fault}"]


def test_a_list_keeps_its_order(site: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """In front matter, too, where paths are also relative to the page."""
    (site / "scripts/first.js").write_text("\nconst a = ;\n")
    front = "scripts: [mine.js, scripts/first.js, scripts/mine.js]"
    (site / "scripts/page.md").write_text(f"---\ntitle: Mine\n{front}\n---\nText\n")
    (site / "site.yaml").write_text(
        "site: {title: Mine}\npages: [{path: /, file: scripts/page.md}]\n"
    )
    [page] = config.load(site / "site.yaml").pages
    assert page.scripts == ("scripts/mine.js", "scripts/first.js")
    assert main(["check", str(site)]) == 1
    assert "scripts/first.js:2: script: syntax error" in capsys.readouterr().err


def test_all_scripts_have_types(site: Path) -> None:
    (site / "more").mkdir()
    (site / "more/map.js").write_text('import "sitegen";\n')
    (site / "site.yaml").write_text(MORE.replace("WRITTEN", "more/map.js"))
    assert main(["types", str(site)]) == 0
    names = {file.relative_to(site).as_posix() for file in site.glob("*/*.d.ts")}
    files = ("ros.d.ts", "sitegen.d.ts")
    assert names == {f"{folder}/{file}" for folder in ("more", "scripts") for file in files}


@pytest.mark.parametrize(
    "origin",
    [
        "*",
        "school.example",
        "https://*.school.example",
        "https://school.example/",
        "https://school.example/robot",
        "https://user@school.example",
        "https://school.example:0",
        "https://school.example:99999",
        "null",
        "file://",
    ],
)
def test_origins_are_exact(site: Path, origin: str) -> None:
    key = f"title: Mine, messages_from: [{json.dumps(origin)}]"
    (site / "site.yaml").write_text(SITE.replace("title: Mine}", f"{key}}}"))
    with pytest.raises(SiteError) as error:
        config.load(site / "site.yaml")
    [line] = error.value.lines
    assert f"'{origin}' is not an exact origin; write it like 'https://school.example'" in line


def test_origins_are_as_browsers_write_them(site: Path) -> None:
    given = ["https://School.example", "https://a.example:443", "http://a.example:8000"]
    key = f"title: Mine, messages_from: {json.dumps(given)}"
    (site / "site.yaml").write_text(SITE.replace("title: Mine}", f"{key}}}"))
    found = config.load(site / "site.yaml").messages_from
    assert found == ("https://school.example", "https://a.example", "http://a.example:8000")


def test_scripts_have_types(site: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["types", str(site)]) == 0
    said = capsys.readouterr().out
    assert "wrote scripts/ros.d.ts" in said
    assert "scripts/sitegen.d.ts" in said
    if not shutil.which("node"):
        pytest.skip("the compiler of types needs node")

    def checked() -> str:
        compiler = ROOT / "node_modules/typescript/bin/tsc"
        flags = ["--allowJs", "--checkJs", "--noEmit", "--strict", "--module", "esnext"]
        flags += ["--moduleResolution", "bundler", "--target", "es2023", "--types", ""]
        flags += ["scripts/mine.js", "scripts/sitegen.d.ts"]
        command = ["node", str(compiler), *flags]
        done = subprocess.run(command, cwd=site, capture_output=True, text=True)
        return done.stdout

    assert checked() == ""
    script = site / "scripts/mine.js"
    script.write_text(SCRIPT.replace("{ data } of", "{ date } of").replace("(data.", "(date."))
    assert "Property 'date' does not exist on type '{ data: string; }'" in checked()
    script.write_text(SCRIPT.replace("{ a: 1n }", "{ a: 1 }"))
    assert "Type 'number' is not assignable to type 'bigint'" in checked()
    script.write_text(SCRIPT.replace('"sensor_data"', '"sensors"'))
    assert "'\"sensors\"' is not assignable to parameter of type 'Qos" in checked()
    script.write_text(SCRIPT.replace("speed.value = Number(value)", 'speed.value = "a"'))
    assert "Type 'string' is not assignable to type 'number | bigint'" in checked()
    script.write_text(SCRIPT.replace("data: data.trim()", "data: 1"))
    assert "Type 'number' is not assignable to type 'string'" in checked()


def test_only_sites_that_use_roslib_have_its_module_and_its_types(site: Path) -> None:
    types = site / "scripts/sitegen.d.ts"
    for line, used in (('import "sitegen/rosbridge";\n', False), ('import "./more.js";\n', True)):
        (site / "scripts/more.js").write_text('import "sitegen/roslib";\n')
        (site / "scripts/mine.js").write_text(line)
        paths = {artifact.path for artifact in make(site, Report()).artifacts}
        assert ("runtime/vendor/roslib.js" in paths) == used
        assert "runtime/vendor/licenses.txt" in paths
        assert main(["types", str(site)]) == 0
        assert ('declare module "sitegen/roslib" {' in types.read_text()) == used


def test_an_edited_script_runs_in_the_open_page(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    (site / "scripts/mine.js").write_text("document.body.dataset.said = 'first';\n")
    served = serving(site)
    tab.goto(served.url)
    tab.wait_for_selector("body[data-said=first]")
    served.write("scripts/mine.js", "document.body.dataset.said = 'second';\n")
    tab.wait_for_selector("body[data-said=second]")
    # One more, which is then edited, too.
    (site / "scripts/more.js").write_text("document.body.dataset.said += ' third';\n")
    served.write("site.yaml", MORE.replace("WRITTEN", "scripts/more.js"))
    tab.wait_for_selector("body[data-said='second third']")
    served.write("scripts/more.js", "document.body.dataset.said += ' fourth';\n")
    tab.wait_for_selector("body[data-said='second fourth']")
    # It begins to use what the site did not have before.
    roslib = 'import { REVISION } from "sitegen/roslib";\n'
    served.write("scripts/more.js", f"{roslib}document.body.dataset.said += ` r${{REVISION}}`;\n")
    tab.wait_for_selector("body[data-said='second r2.1.0']")


def test_an_edited_cell_leaves_the_others_running(
    tab: Page, tmp_path: Path, serving: Callable[[Path], Serving]
) -> None:
    text = (
        "# Cells\n\n```js ros\nsetInterval(() => {}, 1000);\n```\n"
        "\n```js ros\nconsole.log('first');\n```\n"
    )
    (tmp_path / "site.yaml").write_text("site: {title: A}\npages: [{path: /, file: page.md}]\n")
    (tmp_path / "page.md").write_text(text)
    served = serving(tmp_path)
    tab.goto(served.url)
    states = tab.locator(".ros-cell-state")
    tab.get_by_role("button", name="Run JavaScript cell 1").click()
    tab.get_by_role("button", name="Run JavaScript cell 2").click()
    expect(states).to_have_text(["running", "done"])
    served.write("page.md", text.replace("first", "second"))
    expect(states).to_have_text(["running", "not run"])
    tab.get_by_role("button", name="Run JavaScript cell 2").click()
    expect(tab.get_by_text("second", exact=True)).to_be_visible()
    # A program that the visitor runs is no node of the page, and goes on.
    tab.get_by_role("button", name="Stop JavaScript cell 1").click()
    expect(states).to_have_text(["stopped", "done"])
