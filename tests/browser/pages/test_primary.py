"""A panel has at most one coloured button: the one to press next."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from paths import ROOT
from playwright.sync_api import Page as Tab

COLOURED = """() => [...document.querySelectorAll(".ros-panel")].map((panel) =>
  [...panel.querySelectorAll("button:enabled")].filter((button) => {
    const { borderTopColor, backgroundColor, borderTopWidth } = getComputedStyle(button);
    const clear = "rgba(0, 0, 0, 0)";
    return borderTopWidth !== "0px" && borderTopColor === clear && backgroundColor !== clear;
  }).map((button) => button.textContent))"""
DEMOS = sorted(folder.name for folder in ROOT.glob("demos/demo0*"))


@pytest.mark.parametrize("demo", DEMOS)
def test_a_panel_has_one_coloured_button(demo: str, tab: Tab, built: Built, serve: Serve) -> None:
    tab.goto(f"{serve(built(ROOT))}{demo}/")
    tab.wait_for_load_state("networkidle")
    panels: list[list[str]] = tab.evaluate(COLOURED)
    assert panels
    assert [names for names in panels if len(names) > 1] == []
