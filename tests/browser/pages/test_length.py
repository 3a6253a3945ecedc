"""No page of the documentation is endless on a phone."""

from __future__ import annotations

from browser import Built, Serve
from paths import ROOT
from playwright.sync_api import Page as Tab

from sitegen.config import load

SCREENS, WIDTH, HEIGHT = 10, 390, 844


def test_no_page_of_the_docs_is_longer_than_ten_screens(
    tab: Tab, serve: Serve, built: Built
) -> None:
    url = serve(built(ROOT))
    tab.set_viewport_size({"width": WIDTH, "height": HEIGHT})
    screens = {}
    for page in load(ROOT / "site.yaml").pages:
        if page.path.startswith("docs/"):
            tab.goto(url + page.path)
            height = tab.evaluate("document.documentElement.scrollHeight")
            screens[page.path] = round(height / HEIGHT, 1)
    assert len(screens) > 20
    assert {path: length for path, length in screens.items() if length > SCREENS} == {}
