"""Measure 3D views: a large cloud, and the links of fifty robots, beside WebGL that only draws."""

from __future__ import annotations

from statistics import median

from playwright.sync_api import Browser

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.crowd import SITE
from bench.figure import Figure
from bench.plots import measure, p99

SCENES = {"cloud": "100,000 points at 10 Hz", "swarm": "50 robots at 60 Hz"}
SIZE = """(({ width, height }) => [width, height])(document.querySelector(".ros-scene canvas"))"""


def scene(counts: Counts) -> list[Figure]:
    """Times between frames, and the share of a core that the page takes, with its node."""
    with serving_site(SITE, isolated=True) as url, chromium() as browser:
        return [
            figure for name in SCENES for figure in _figures(browser, f"{url}{name}/", url, counts)
        ]


def _figures(browser: Browser, address: str, url: str, counts: Counts) -> list[Figure]:
    name = address.rstrip("/").rpartition("/")[2]
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.goto(address)
    page.get_by_role("button", name="Start").click()
    page.locator("[data-state=running]").wait_for()
    width, height = page.evaluate(SIZE)
    ours, share = measure(browser, page, counts)
    page.close()
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.goto(f"{url}bench/scene.html#{name},{width},{height}")
    bare, bare_share = measure(browser, page, counts)
    page.close()
    what = SCENES[name]
    return [
        Figure(f"{what}: frame, p50", "ms", median(ours), median(bare)),
        Figure(f"{what}: frame, p99", "ms", p99(ours), p99(bare)),
        Figure(f"{what}: share of a core", "%", share, bare_share),
    ]
