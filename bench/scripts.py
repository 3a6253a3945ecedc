"""Measure messages to scripts of a page and to roslib there, beside a panel and a WebSocket."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from playwright.sync_api import Page

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.figure import Figure, Target
from bench.messages import SIZES, p50

ROOT = Path(__file__).parent.parent
SITE = Path(__file__).parent / "scripts_site"
WAYS = ("panel", "script", "roslib", "socket")
# What a callback of `ros` may take, of the time of a panel's own.
MOST = 1.2


def scripts(counts: Counts) -> list[Figure]:
    """One message at a time, until the callback has it; the ways take turns."""
    figures = []
    with serving_site(SITE, isolated=True) as url, chromium() as browser, _echo() as address:
        # The policy of the page lets it connect to no server.
        page = browser.new_page(bypass_csp=True)
        for size in SIZES:
            page.goto(url)
            page.wait_for_selector("body[data-ready]")
            rounds = _rounds(page, size.count, size.rounds, size.warm_up, address, counts)
            middle = {way: p50(times) * 1000 for way, times in rounds.items()}
            figures += [
                Figure(
                    f"message to a callback of `ros`, {size.title} (bare: of a panel)",
                    "µs",
                    middle["script"],
                    middle["panel"],
                    Target("ratio", "≤", MOST),
                ),
                Figure(
                    f"message to roslib, {size.title} (bare: as many bytes by WebSocket)",
                    "µs",
                    middle["roslib"],
                    middle["socket"],
                    Target("ratio", "≤", 1.0),
                ),
            ]
    return figures


def _rounds(
    page: Page, size: int, rounds: int, warm_up: int, address: str, counts: Counts
) -> dict[str, list[float]]:
    """Return times in ms, by way."""
    page.evaluate(
        """async ([ways, size, address]) => {
          globalThis.ready = {};
          for (const way of ways) ready[way] = await prepare(way, size, address);
        }""",
        [WAYS, size, address],
    )
    times: dict[str, list[float]] = {way: [] for way in WAYS}
    for _ in range(counts.turns):
        for way in WAYS:
            times[way] += page.evaluate(f"ready.{way}({rounds})")[warm_up:]
    return times


@contextmanager
def _echo() -> Iterator[str]:
    with subprocess.Popen(
        ["node", str(SITE / "echo.mjs")], cwd=ROOT, stdout=subprocess.PIPE, text=True
    ) as server:
        assert server.stdout
        try:
            yield f"ws://127.0.0.1:{server.stdout.readline().strip()}"
        finally:
            server.kill()
