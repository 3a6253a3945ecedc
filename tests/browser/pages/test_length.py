"""No page of the documentation is endless on a phone."""

from __future__ import annotations

import io
from pathlib import Path

from browser import Serve
from paths import ROOT
from playwright.sync_api import Page as Tab

from sitegen.build import make, write
from sitegen.options import Options
from sitegen.report import Report

SCREENS, WIDTH, HEIGHT = 10, 390, 844


def test_no_page_of_the_docs_is_longer_than_ten_screens(
    tab: Tab, serve: Serve, tmp_path: Path
) -> None:
    made = make(ROOT, Report(io.StringIO()), options=Options(compile=False))
    write(made.artifacts, tmp_path / "dist")
    url = serve(tmp_path / "dist")
    tab.set_viewport_size({"width": WIDTH, "height": HEIGHT})
    screens = {}
    for page in made.site.pages:
        if page.path.startswith("docs/"):
            tab.goto(url + page.path)
            height = tab.evaluate("document.documentElement.scrollHeight")
            screens[page.path] = round(height / HEIGHT, 1)
    assert len(screens) > 20
    assert {path: length for path, length in screens.items() if length > SCREENS} == {}
