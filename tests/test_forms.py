"""The forms that calls of rclcpp take in people's programs, compiled and run in a real browser."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from browser import Serve
from playwright.sync_api import Browser
from test_demos import WITHOUT_JSPI, Panel

from sitegen.build import build
from sitegen.report import Report

SITE = Path(__file__).parent / "sites" / "forms"

RESULT = [
    "bind hi",
    "bind shared hi",
    "bytes 11",
    "const shared hi",
    "free function hi",
    "function",
    "info hi sane",
    "reference",
    "reference hi",
    "shared hi",
    "shutdown callback",
    "unique hi",
    "unique info hi",
    "ticks 20, ok 0, duration 2.750, kept 5, down",
]


@pytest.fixture(scope="session")
def forms(tmp_path_factory: pytest.TempPathFactory) -> Path:
    output = tmp_path_factory.mktemp("forms") / "dist"
    build(SITE, output=output, report=Report())
    return output


@pytest.mark.parametrize("engine", ["jspi", "asyncify"])
def test_every_form_compiles_and_works(
    engine: str, browser: Browser, serve: Serve, forms: Path
) -> None:
    context = browser.new_context()
    if engine == "asyncify":
        context.add_init_script(WITHOUT_JSPI)
    page = context.new_page()
    page.goto(serve(forms))
    said = {}
    for name in ("plain", "renamed", "quiet"):
        panel = Panel(page, name)
        panel.expect_state("stopped")
        panel.start()
        panel.wait_for("publishing to" if name == "quiet" else "ticks")
        panel.expect_state("stopped")
        said[name] = [re.sub(r" \[\d+\.\d+\]", "", line) for line in panel.lines()]
    context.close()

    result = [f"[INFO] [result.of]: {words}" for words in RESULT]
    plain = "[INFO] [forms]: publishing to 12 on /forms/words as /forms in /"
    renamed = "[INFO] [robot.forms]: publishing to 12 on /shared/words as /robot/forms in /robot"
    assert said == {
        "plain": [plain, *result],
        "renamed": [renamed, *result],
        "quiet": [plain],
    }
