"""Measure how soon a page runs a Python node, and messages between two of them."""

from __future__ import annotations

from pathlib import Path
from statistics import median

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.figure import Figure, Target
from bench.messages import numbers, one_way, p50, p99
from bench.pages import first_line

SITE = Path(__file__).parent / "python_site"
ROUNDS = 2000
# The first rounds of a turn do not count: programs and engine warm up.
WARM_UP = 500

START_TARGET = Target("ratio", "≤", 1.3)
IMPORT_TARGET = Target("figure", "≤", 300)
# Most of it is rclpy's executor, which stays upstream's: native rclpy, between two processes, took
# 21 to 29 times the bare way in the same runs.
LATENCY_TARGET = Target("ratio", "≤", 20)


def python(counts: Counts) -> list[Figure]:
    """Measure the first line of a Python node, and the way of a message from one to another."""
    return [*_start(counts), *_latency(counts)]


def _start(counts: Counts) -> list[Figure]:
    """From navigation to the first line, with nothing in any cache; bare: Python that prints."""
    ours, bare, imports = [], [], []
    with serving_site(SITE) as url, chromium() as browser:
        for _ in range((counts.starts + 1) // 2 + 1):
            bare.append(first_line(browser, f"{url}bench/python.html")[0])
            time, line = first_line(browser, url)
            ours.append(time)
            imports.append(float(line.rpartition(" ")[2]))
    # The first of each also starts processes of the browser.
    ours, bare, imports = ours[1:], bare[1:], imports[1:]
    detail = {"ours_ms": ours, "bare_ms": bare}
    name = "navigation → first line of a Python node"
    return [
        Figure(name, "ms", median(ours), median(bare), START_TARGET, detail),
        Figure("import rclpy, of that", "ms", median(imports), None, IMPORT_TARGET),
    ]


def _latency(counts: Counts) -> list[Figure]:
    """One way from Python node to Python node: half of a round trip."""
    ours, bare = [], []
    with serving_site(SITE, isolated=True) as url, chromium() as browser:
        page = browser.new_page()
        page.goto(f"{url}messages/")
        page.evaluate("async () => { window.drive = await import('/bench/drive.js'); }")
        for _ in range(counts.turns // 2 or 1):
            bare += numbers(page, f"runBare('ping', 16, {ROUNDS})")[WARM_UP:]
            ours += numbers(page, "runNode('ping')")[WARM_UP:]
    return [
        one_way("Python to Python 16 B, p50", p50(ours), p50(bare), LATENCY_TARGET),
        one_way("Python to Python 16 B, p99", p99(ours), p99(bare), None),
    ]
