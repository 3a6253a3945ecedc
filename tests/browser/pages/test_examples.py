"""The examples in the documentation run."""

from __future__ import annotations

import re

import pytest
from browser import Built, Serve
from paths import ROOT
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect

# A part of an example on each page, and what it says when its nodes run.
SAID = {
    "panels": (".ros-topics", r"[1-9]\d\.\d Hz"),
    "node-panels": (".ros-managed-state", "active"),
    "plots": (".ros-value", r"[2-9]\d\.\d °C"),
    "cameras": (".ros-image", "90, rgb8"),
    "widgets": (".ros-editor", "def main"),
    "views": (".ros-3d", r"Displays \d"),
    "robots": (".ros-joints", "elbow"),
    "bags": (".ros-bag", "/turtle1/cmd_vel"),
    "terminal": (".ros-terminal", "cpp_chatter talker"),
    "launch": (".ros-launch", "spirograph"),
    "own-panels": (".ros-own", "Ahead"),
    "notebooks": (".ros-cell", "create_node"),
}


@pytest.mark.parametrize("page", SAID)
def test_the_examples_of_the_documentation_run(
    tab: Tab, serve: Serve, built: Built, page: str
) -> None:
    part, text = SAID[page]
    tab.goto(f"{serve(built(ROOT))}docs/{page}/")
    # Below the text of a page, a panel begins when somebody comes near.
    tab.locator(f".example {part}").first.scroll_into_view_if_needed()
    expect(tab.locator(f".example {part}").first).to_contain_text(re.compile(text))
    assert tab.evaluate("document.documentElement.scrollWidth") <= 1280
