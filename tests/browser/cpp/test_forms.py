"""The forms that calls of rclcpp take in people's programs, compiled and run in a real browser."""

from __future__ import annotations

import re

from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import BrowserContext

SITE = SITES / "forms"

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
    "stamp 5.000000500, longest 2147483647, scaled 0.25, 3000000000 ns",
]


def test_every_form_compiles_and_works(context: BrowserContext, serve: Serve, built: Built) -> None:
    page = context.new_page()
    page.goto(serve(built(SITE)))
    said = {}
    for name in ("plain", "renamed", "quiet"):
        panel = Panel(page, name)
        panel.expect_state("stopped")
        panel.start()
        panel.wait_for("publishing to" if name == "quiet" else "ticks")
        panel.expect_state("stopped")
        said[name] = [re.sub(r" \[\d+\.\d+\]", "", line) for line in panel.lines()]

    result = [f"[INFO] [result.of]: {words}" for words in RESULT]
    plain = "[INFO] [forms]: publishing to 12 on /forms/words as /forms in /"
    renamed = "[INFO] [robot.forms]: publishing to 12 on /shared/words as /robot/forms in /robot"
    assert said == {
        "plain": [plain, *result],
        "renamed": [renamed, *result],
        "quiet": [plain],
    }
