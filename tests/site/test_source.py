"""Sources of nodes stand in the page, and beside their console where there is room."""

from __future__ import annotations

import html
import re
from pathlib import Path

import pytest
from browser import Built, Serve
from paths import ROOT
from playwright.sync_api import Page as Tab

from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.model import Source
from sitegen.site.pages import render

TALKER = """\
#include <chrono>
int main()
{
  // #region timer
  wait();
  // #endregion
  return 0;
}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A workspace with one package of two nodes."""
    files = {
        "src/robot/package.xml": "<package><name>robot</name></package>",
        "src/robot/CMakeLists.txt": "set(SRC src/talker.cpp src/more.cpp)\n"
        "add_executable(talker ${SRC})\nadd_executable(other)\n",
        "src/robot/src/talker.cpp": TALKER,
        "src/robot/launch/all.launch.py": "import launch\n",
        "guide/notes.txt": "note\n",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def page(folder: Path, block: str) -> Path:
    (folder / "guide/page.md").write_text(f"# T\n\n```ros\n{block}\n```\n")
    (folder / "site.yaml").write_text(
        "site: {title: T}\nnodes:\n  talker: {package: robot, executable: talker}\n"
        "  other: {package: robot, executable: other}\n"
        "pages: [{path: /, file: guide/page.md}]\n"
    )
    return folder / "site.yaml"


def shown(folder: Path, block: str) -> str:
    (source,) = (a.source for a in render(load(page(folder, block))) if a.path == "index.html")
    assert isinstance(source, bytes)
    code = re.search('<div class="code">(.*?)</pre>', source.decode(), re.DOTALL)
    assert code
    return code[1]


def text(code: str) -> str:
    return html.unescape(re.sub("<.*?>", "", code.split("<pre")[1].partition(">")[2]))


def numbers(code: str) -> list[int]:
    return [int(number) for number in re.findall(r'data-line="(\d+)"', code)]


def test_the_source_of_a_node_is_that_of_its_executable(folder: Path) -> None:
    code = shown(folder, "source: talker")
    assert '<p class="code-title">src/talker.cpp</p>' in code
    without_marks = [line for line in TALKER.splitlines() if "region" not in line]
    assert text(code).splitlines() == without_marks


def test_numbers_are_those_of_the_file(folder: Path) -> None:
    assert numbers(shown(folder, "source: talker")) == [1, 2, 3, 5, 7, 8]
    assert numbers(shown(folder, "source: {node: talker, lines: 2-5}")) == [2, 3, 5]
    part = shown(folder, "source: {node: talker, region: timer}")
    assert (numbers(part), text(part).strip()) == ([5], "wait();")


def test_other_files(folder: Path) -> None:
    code = shown(folder, "source: {node: talker, file: launch/all.launch.py}")
    assert '<span class="k">import</span>' in code
    assert text(shown(folder, "source: {file: notes.txt}")) == "note\n"


def test_a_source_runs_nothing(folder: Path) -> None:
    site = load(page(folder, "source: talker"))
    assert site.pages[0].nodes == {}
    assert site.pages[0].level == ""
    assert [type(part) for part in site.pages[0].content][1] is Source
    paths = {a.path for a in render(site) if not a.path.startswith("theme/")}
    assert paths == {"index.html", "404.html"}


@pytest.mark.parametrize(
    ("block", "fault"),
    [
        ("source: talkr", "ros.source: no node 'talkr'; did you mean 'talker'?"),
        (
            "source: {lines: 1-2}",
            "ros.source: needs a node or a file; write it like 'source: talker'",
        ),
        (
            "source: {node: talker, lines: 7-99}",
            "source.lines: '7-99' is not a valid range of lines: talker.cpp ",
        ),
        (
            "source: {node: talker, lines: 3}",
            "ros.source.lines: expected lines like 10-20, found the",
        ),
        (
            "source: {node: talker, region: time}",
            "source.region: no region 'time' in talker.cpp; did",
        ),
        (
            "source: {node: talker, file: src/tlker.cpp}",
            "source: no file 'src/tlker.cpp' in robot; ",
        ),
        (
            "source: {file: ../../etc/passwd}",
            "source: '../../etc/passwd' is outside the site's folder",
        ),
        ("source: other", "source: the source of 'other' is unknown; give the"),
        (
            "source: {node: talker, lines: 1-2, region: a}",
            "ros.source.lines: cannot be combined with 'region'",
        ),
    ],
)
def test_what_cannot_be_shown_is_told(folder: Path, block: str, fault: str) -> None:
    with pytest.raises(SiteError) as wrong:
        render(load(page(folder, block)))
    (line,) = wrong.value.lines
    assert line.startswith(f"guide/page.md:4: {fault}")


@pytest.mark.parametrize(("width", "beside"), [(1440, True), (390, False)])
def test_a_source_is_beside_its_console_or_above_it(
    built: Built, serve: Serve, tab: Tab, width: int, beside: bool
) -> None:
    tab.set_viewport_size({"width": width, "height": 900})
    tab.goto(f"{serve(built(ROOT / 'tests/sites/prose'))}guide/nodes/")
    code = tab.locator(".with-source .code").first.bounding_box()
    panel = tab.locator(".with-source .ros-panel").first.bounding_box()
    assert code
    assert panel
    if beside:
        assert code["x"] + code["width"] < panel["x"]
        assert code["y"] == pytest.approx(panel["y"], abs=1)
        assert code["height"] == pytest.approx(panel["height"], abs=1)
    else:
        assert code["y"] + code["height"] < panel["y"]
    assert tab.evaluate("document.documentElement.scrollWidth") == width
