"""Measure a bag that is larger than memory should be: how it opens, seeks and plays."""

from __future__ import annotations

import json
import os
import struct
import tempfile
import time
import urllib.request
from pathlib import Path
from statistics import median

from mcap.writer import CompressionType, Writer
from playwright.sync_api import Browser, Page

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.crowd import memory
from bench.figure import Figure, Target

SITE = """
site: {title: Bags}
pages:
  - {path: /, content: [{markdown: "# Large"}, {bag: {file: large.mcap, views: false}}]}
  - {path: small/, content: [{markdown: "# Small"}, {bag: {file: small.mcap, views: false}}]}
"""
START = 1_700_000_000_000_000_000
# Images of this many bytes, so many ns apart, two in a chunk.
IMAGE = 1_000_000
PERIOD = 33_000_000
CHUNK = 2 * IMAGE
SMALL = 4
# Images at the end that are not sought.
MARGIN = 10
MB = 1_000_000


def large_bag(counts: Counts) -> list[Figure]:
    """How long it takes until the first message, after seeks, and the memory that playing takes."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "site"
        folder.mkdir()
        (folder / "site.yaml").write_text(SITE)
        images = counts.bag * MB // IMAGE
        _write(folder / "large.mcap", images)
        _write(folder / "small.mcap", SMALL)
        # Not in order, so that nothing has been read ahead.
        places = [7 * n % counts.seeks + 1 for n in range(counts.seeks)]
        wanted = [place * (images - MARGIN) // (counts.seeks + 1) for place in places]
        with serving_site(folder, isolated=True) as url, chromium() as browser:
            small = _first(browser, f"{url}small/", counts)
            large = _first(browser, url, counts)
            page = browser.new_page()
            _open(page, url)
            quiet = memory(browser)
            page.evaluate("() => window.load.first()")
            seeks = [
                page.evaluate("(to) => window.load.seek(...to)", [number, PERIOD / 1e9])
                for number in wanted
            ]
            chunks = [_fetch(url, number * IMAGE) for number in wanted]
            most = 0.0
            for _ in range(counts.idle):
                page.wait_for_timeout(1000)
                most = max(most, memory(browser))
            used = page.evaluate("() => performance.measureUserAgentSpecificMemory()")["bytes"]
    title = f"a bag of {counts.bag} MB"
    return [
        Figure(
            f"{title}: navigation to its first message (bare: one of {SMALL} MB)",
            "ms",
            large,
            small,
            target=Target("figure", "≤", 1000),
        ),
        Figure(
            f"{title}: seek (bare: its chunk is fetched)",
            "ms",
            median(seeks),
            median(chunks),
            target=Target("figure", "≤", 200),
        ),
        Figure(
            f"{title}: memory that the page uses while it plays",
            "MB",
            used / MB,
            target=Target("figure", "≤", 200),
            # The same with what is free, but not collected yet.
            detail={"taken from the system": (most - quiet) / MB},
        ),
    ]


def _write(path: Path, images: int) -> None:
    """Write images that begin with their number; their pixels are noise."""
    with path.open("wb") as stream:
        writer = Writer(stream, chunk_size=CHUNK, compression=CompressionType.NONE)
        writer.start(profile="ros2", library="bench")
        schema = writer.register_schema("bench/msg/Bytes", "ros2msg", b"uint8[] data")
        channel = writer.register_channel("/images", "cdr", schema)
        noise = os.urandom(IMAGE - 4)
        for number in range(images):
            data = struct.pack("<4sII", b"\x00\x01\x00\x00", IMAGE, number) + noise
            writer.add_message(channel, START + number * PERIOD, data, 0)
        writer.finish()  # type: ignore[no-untyped-call]


def _open(page: Page, url: str) -> None:
    page.goto(url)
    page.evaluate("async () => { window.load = await import('/bench/bags.js'); }")
    page.locator(".ros-bag-row").wait_for()


def _first(browser: Browser, url: str, counts: Counts) -> float:
    """Return the time from navigation to the first message, in ms."""
    times: list[float] = []
    for _ in range(counts.starts):
        page = browser.new_page()
        _open(page, url)
        times.append(page.evaluate("() => window.load.first()"))
        page.close()
    return median(times)


def _fetch(url: str, start: int) -> float:
    """Return how long it takes to get as much of the bag as a chunk has, in ms."""
    with urllib.request.urlopen(f"{url}page.json") as answer:
        [widget] = json.load(answer)["widgets"]
    part = {"Range": f"bytes={start}-{start + CHUNK - 1}"}
    request = urllib.request.Request(url + widget["options"]["file"], headers=part)
    begun = time.perf_counter()
    with urllib.request.urlopen(request) as answer:
        answer.read()
    return (time.perf_counter() - begun) * 1000
