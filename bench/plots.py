"""Measure ten plots of numbers that come at 1 kHz, beside canvases on which curves are drawn."""

from __future__ import annotations

import time
from statistics import median, quantiles

from playwright.sync_api import Browser, Page, ViewportSize

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.crowd import SITE, processor
from bench.figure import Figure

# All ten are in view.
VIEW: ViewportSize = {"width": 1600, "height": 3200}
# Up to four points in each column of pixels.
POINTS = 4


def plots(counts: Counts) -> list[Figure]:
    """Times between frames, and the share of a core that the page takes, with its node."""
    with serving_site(SITE, isolated=True) as url, chromium() as browser:
        page = browser.new_page(viewport=VIEW)
        page.goto(f"{url}plots/")
        page.get_by_role("button", name="Start").click()
        page.wait_for_function("() => document.querySelectorAll('.ros-value-now').length === 10")
        width, height = page.evaluate(
            "(({ width, height }) => [width, height])(document.querySelector('.ros-chart canvas'))"
        )
        ours, share = measure(browser, page, counts)
        page.close()
        page = browser.new_page(viewport=VIEW)
        page.goto(f"{url}bench/plots.html#10,{width},{height},{POINTS * width}")
        bare, bare_share = measure(browser, page, counts)
    return [
        Figure("ten plots at 1 kHz: frame, p50", "ms", median(ours), median(bare)),
        Figure("ten plots at 1 kHz: frame, p99", "ms", p99(ours), p99(bare)),
        Figure("ten plots at 1 kHz: share of a core", "%", share, bare_share),
    ]


def p99(times: list[float]) -> float:
    """Return what one in a hundred is above of."""
    return quantiles(times, n=100)[98]


def measure(browser: Browser, page: Page, counts: Counts) -> tuple[list[float], float]:
    """Return the times between frames (ms) and the share of a core in percent."""
    page.evaluate("async () => { window.measure = await import('/bench/frames.js'); }")
    time.sleep(counts.warm_up)
    before, begun = processor(browser), time.monotonic()
    times = list(page.evaluate(f"measure.frames({counts.idle})"))
    used = processor(browser) - before
    return times, used / (time.monotonic() - begun) * 100
