"""Measure recording and playing bags, beside a page that only publishes and a timer of a worker."""

from __future__ import annotations

import itertools
import shutil
import struct
import tempfile
from pathlib import Path
from statistics import median, quantiles
from typing import Any

from mcap.writer import Writer
from playwright.sync_api import Page

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.crowd import processor
from bench.figure import Figure, Target

SITE = """
site: {title: Bags}
pages:
  - {path: /, content: [{markdown: "# Play"}, {bag: {file: drive.mcap, views: false}}]}
  - {path: record/, content: [{markdown: "# Record"}, {bag: }]}
"""
# Messages of this many bytes, so many in each step of 10 ms.
LOADS = {
    "10,000 messages of 1 kB a second": (1000, 100),
    "100 messages of 1 MB a second": (1_000_000, 1),
}
STEP = 0.010
# What is played: a message each 10 ms.
START = 1_700_000_000_000_000_000
PERIOD = 10_000_000


def bags(counts: Counts) -> list[Figure]:
    """How much arrives in a recording, how the page draws meanwhile, and how exact playing is."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "site"
        folder.mkdir()
        (folder / "site.yaml").write_text(SITE)
        _write(folder / "drive.mcap", seconds=counts.idle)
        with serving_site(folder, isolated=True) as url, chromium() as browser:
            figures = []
            for title, (size, count) in LOADS.items():
                page = browser.new_page()
                page.goto(f"{url}record/")
                page.evaluate("async () => { window.load = await import('/bench/bags.js'); }")
                bare, bare_work = _publish(page, _load(size, count, counts))
                page.get_by_role("button", name="Record", exact=True).click()
                page.wait_for_timeout(1500)
                ours, work = _publish(page, _load(size, count, counts))
                recorded = _stop(page)
                figures += [
                    Figure(
                        f"recording {title}: in the bag (bare: published, not recorded)",
                        "/s",
                        recorded / ours["seconds"],
                        bare["sent"] / bare["seconds"],
                        detail={"published": ours["sent"], "recorded": recorded},
                    ),
                    Figure(
                        f"recording {title}: frame, p99 (bare: not recorded)",
                        "ms",
                        _p99(ours["frames"]),
                        _p99(bare["frames"]),
                    ),
                    Figure(
                        f"recording {title}: publishing, p50 of a step (bare: not recorded)",
                        "ms",
                        median(ours["steps"]),
                        median(bare["steps"]),
                        target=Target("ratio", "≤", 1.2),
                    ),
                    Figure(
                        f"recording {title}: processor (bare: not recorded)",
                        "% of a core",
                        work,
                        bare_work,
                    ),
                ]
                page.close()
            page = browser.new_page()
            page.goto(url)
            page.evaluate("async () => { window.load = await import('/bench/bags.js'); }")
            page.locator(".ros-bag-row").wait_for()
            playing = page.evaluate_handle(
                "(count) => ({ done: window.load.heard(count) })", counts.idle * 100
            )
            page.get_by_role("button", name="Play", exact=True).click()
            ours_times = playing.evaluate("(playing) => playing.done")
            bare_times = page.evaluate("(count) => window.load.ticks(count)", counts.idle * 100)
            figures.append(
                Figure(
                    "playing 100 messages a second: error of their spacing, p99 (bare: a timer)",
                    "ms",
                    _p99(_errors(ours_times)),
                    _p99(_errors(bare_times)),
                )
            )
            shutil.rmtree(folder)
    return figures


def _publish(page: Page, load: tuple[int, int, int]) -> tuple[Any, float]:
    """Return what the page says of its load, and the processor time that the page took, in %."""
    browser = page.context.browser
    assert browser
    begun = processor(browser)
    said = page.evaluate("(load) => window.load.publish(...load)", [*load])
    return said, 100 * (processor(browser) - begun) / said["seconds"]


def _load(size: int, count: int, counts: Counts) -> tuple[int, int, int]:
    return size, count, counts.idle


def _stop(page: Page) -> int:
    """End the recording and return how many messages of the load are in it."""
    page.wait_for_timeout(3000)
    page.get_by_role("button", name="Stop", exact=True).click()
    page.locator(".ros-bag-entry").wait_for()
    text = page.locator(".ros-bag-recorder .ros-note").first.inner_text()
    return int("".join(filter(str.isdigit, text.partition(" messages")[0])))


def _write(path: Path, *, seconds: int) -> None:
    with path.open("wb") as stream:
        writer = Writer(stream)
        writer.start(profile="ros2", library="bench")
        schema = writer.register_schema("std_msgs/msg/Int32", "ros2msg", b"int32 data")
        channel = writer.register_channel("/ticks", "cdr", schema)
        for number in range(seconds * 100):
            data = b"\x00\x01\x00\x00" + struct.pack("<i", number)
            time = START + number * PERIOD
            writer.add_message(channel, time, data, time)
        writer.finish()  # type: ignore[no-untyped-call]


def _errors(times: list[float]) -> list[float]:
    """Return by how much the times between messages (ms) differ from what they should be."""
    return [abs(b - a - PERIOD / 1e6) for a, b in itertools.pairwise(times)]


def _p99(values: list[float]) -> float:
    return quantiles(values, n=100)[98] if len(values) > 1 else values[0]
