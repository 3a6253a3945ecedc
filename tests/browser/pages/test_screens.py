"""The demo with all panels fits a screen: who changes something sees what it does."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from panel import Panel
from paths import ROOT
from playwright.sync_api import Page as Tab

NODES = ("talker", "listener", "server", "client")
END = "document.querySelector('.stage').getBoundingClientRect().bottom + scrollY"


@pytest.fixture
def demo(tab: Tab, built: Built, serve: Serve) -> Tab:
    tab.goto(f"{serve(built(ROOT))}demo05/")
    return tab


def test_it_fits_one_screen_of_a_desktop_and_three_of_a_phone(demo: Tab) -> None:
    for name in NODES:
        Panel(demo, name).start()
    Panel(demo, "client").wait_for("Sum: 42")
    Panel(demo, "listener").wait_for("Hello, world! 5")
    tabs = demo.locator(".tabbed-labels label")
    for width, height, screens in ((1440, 900, 1), (390, 844, 3)):
        demo.set_viewport_size({"width": width, "height": height})
        for tab in tabs.all():
            tab.click()
            assert demo.evaluate(END) <= screens * height, tab.inner_text()
            assert demo.evaluate("document.documentElement.scrollWidth") == width
            if width == 1440:
                # All consoles stand beside the tabs.
                consoles = demo.locator(".stage-consoles [role=log]")
                assert consoles.count() == len(NODES)
                left = demo.locator(".stage-show").evaluate(
                    "(e) => e.getBoundingClientRect().right"
                )
                for console in consoles.all():
                    box = console.bounding_box()
                    assert box and box["x"] >= left
            else:
                assert demo.evaluate("document.body.scrollHeight") <= screens * height
