"""Sites built with --debug: where programs failed, in a real browser."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Serve, whole
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, BrowserContext

from sitegen.commands.build import build
from sitegen.options import Options
from sitegen.report import Report

SITE = ROOT / "tests" / "sites" / "faults"
SOURCE = "src/faults/src/fault.cpp"
LINES = (SITE / SOURCE).read_text(encoding="utf-8").splitlines()


def line(text: str) -> str:
    """Return where `text` stands in the program."""
    [number] = [number for number, each in enumerate(LINES, 1) if text in each]
    return f"({SOURCE}:{number})"


MAIN = f"main {line('kFaults.at(arguments')}"
# What the console of each node shows in the end.
ENDS = {
    "throw": [
        "throw: robot::BatteryError: battery <b>low</b>",
        f"    at lambda {line('robot::BatteryError(')}",
        f"    at {MAIN}",
    ],
    "throw_in_callback": [
        "throw_in_callback: std::out_of_range: no such wheel",
        f"    at lambda in lambda {line('no such wheel')}",
        "    at rclcpp::spin<rclcpp::Node>(std::shared_ptr<rclcpp::Node>)",
        f"    at lambda {line('spin(node);  // throws')}",
        f"    at {MAIN}",
    ],
    "abort": ["abort: aborted", f"    at lambda {line('std::abort()')}", f"    at {MAIN}"],
    "assert": [
        f"assert: {line('assert(zero')[1:-1]}: assertion failed: zero == 1",
        f"    at lambda {line('assert(zero')}",
        f"    at {MAIN}",
    ],
    "null_pointer": [
        "null_pointer: a null pointer was used",
        f"    at lambda {line('nobody->wheels')}",
        f"    at {MAIN}",
    ],
    "outside": ["outside: aborted", f"    at lambda {line('wheels[4 + zero]')}", f"    at {MAIN}"],
    "library": [
        "     ^",
        "    at rclcpp::Node::Node(std::string const&, rclcpp::NodeOptions const&)",
        f"    at lambda {line('no name')}",
        f"    at {MAIN}",
    ],
    "thread": [
        "thread: std::invalid_argument: no wheel",
        f"    at roll(int) {line('invalid_argument(')}",
        f"    at lambda in lambda {line('roll(zero)')}",
    ],
    "exit": ["exit: exited with code 3"],
}


@pytest.fixture(scope="module")
def browser(browser: Browser) -> Iterator[Browser]:
    with whole(browser) as found:
        yield found


@pytest.fixture(scope="module")
def debugged(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("debug") / "author"
    shutil.copytree(SITE, folder)
    build(folder, output=folder / "dist", report=Report(), options=Options(debug=True))
    return folder / "dist"


@pytest.mark.firefox
def test_each_failure_is_told_with_its_lines(
    context: BrowserContext, serve: Serve, debugged: Path
) -> None:
    page = context.new_page()
    page.goto(serve(debugged))
    for name, lines in ENDS.items():
        panel = Panel(page, name)
        panel.start()
        panel.expect_state("failed")
        panel.wait_for(lines[-1].strip())
        shown = panel.lines()
        begin = shown.index(lines[0])
        assert shown[begin : begin + len(lines)] == lines
        assert len(shown) == begin + len(lines)
    panel = Panel(page, "recursion")
    panel.start()
    panel.wait_for(f"at deeper(int) {line('deeper(depth + 1)')}, ")


def test_nothing_tells_where_the_author_keeps_files(debugged: Path) -> None:
    files = [file for file in (debugged / "nodes").rglob("*") if file.is_file()]
    assert len(files) == 6
    for file in files:
        content = file.read_bytes()
        for place in (debugged.parent, ROOT, Path.home()):
            assert str(place).encode() not in content
