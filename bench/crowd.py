"""Measure many nodes at once: fans, floods, an idle page, and how fast fifty nodes start."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

from playwright.sync_api import Browser, Page

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.figure import Figure, Target

SITE = Path(__file__).parent / "site"
MANY = Path(__file__).parent.parent / "tests" / "sites" / "many"
SINKS = [f"sink_{n}" for n in range(2, 11)]
POURS = [f"pour_{n}" for n in range(1, 11)]
TICKS = [f"tick_{n}" for n in range(1, 11)]


def fan(counts: Counts) -> list[Figure]:
    """20,000 messages of 1 KB: to ten nodes beside to one, and from ten beside from one."""
    with serving_site(SITE, isolated=True) as url, chromium() as browser:
        page = _open(browser, url)
        _start(page, ["sink"])
        one = _times(page, "burst_1k", counts)
        _start(page, SINKS)
        ten = _times(page, "burst_10", counts)
        _stop(page, ["sink", *SINKS])
        _start(page, ["pour"])
        from_one = _times(page, "collect_1", counts)
        _stop(page, ["pour"])
        _start(page, POURS)
        from_ten = _times(page, "collect_10", counts)
    name = "fan-out 1 → 10, 1 KB (bare: ours to one)"
    return [
        Figure(name, "ms", median(ten), median(one), Target("ratio", "≤", 12)),
        Figure(
            "fan-in 10 → 1, 1 KB (bare: ours from one)", "ms", median(from_ten), median(from_one)
        ),
    ]


def flood(counts: Counts) -> list[Figure]:
    """Memory of the page while a node publishes as fast as it can for one that is far too slow."""
    with serving_site(SITE, isolated=True) as url, chromium() as browser:
        page = _open(browser, url)
        page.evaluate("drive.keepLines('slow')")
        _start(page, ["slow", "flood"])
        time.sleep(2)
        early = memory(browser)
        most = early
        for _ in range(counts.flood):
            time.sleep(1)
            most = max(most, memory(browser))
        page.evaluate("drive.keptSome('slow')")
        ages = [float(age) for age in page.evaluate("drive.kept('slow')")]
        _stop(page, ["flood", "slow"])
    title = f"a flood for {counts.flood} s and a slow reader"
    return [
        Figure(f"{title}: memory at most (bare: after 2 s)", "MB", most / 1e6, early / 1e6),
        Figure(f"{title}: age of a message, p50", "ms", median(ages)),
    ]


def idle(counts: Counts) -> list[Figure]:
    """What ten nodes that publish once a second take of a core."""
    with serving_site(SITE, isolated=True) as url, chromium() as browser:
        page = _open(browser, url)
        _start(page, TICKS)
        time.sleep(3)
        before = processor(browser)
        time.sleep(counts.idle)
        used = processor(browser) - before
    share = used / counts.idle * 100
    return [Figure("idle page, ten nodes at 1 Hz", "%", share, target=Target("figure", "≤", 2))]


def many(counts: Counts) -> list[Figure]:
    """Many nodes and topics, from the first Start until all of them run."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "many"
        shutil.copytree(MANY, folder)
        (folder / "site.yaml").write_text(json.dumps(_ring(counts)))
        with serving_site(folder) as url, chromium() as browser:
            page = _open(browser, url)
            names = page.evaluate("[...drive.nodes.keys()]")
            begun = time.monotonic()
            _start(page, names)
            took = time.monotonic() - begun
    target = Target("figure", "≤", 10)
    name = f"{counts.nodes} nodes with {counts.nodes * counts.topics} topics start"
    return [Figure(name, "s", took, target=target)]


def _ring(counts: Counts) -> dict[str, object]:
    """Return a site (JSON is YAML) whose nodes each hear a topic of each of those before it."""
    nodes = {
        f"node{n}": {
            "package": "many",
            "executable": "many",
            "arguments": [
                f"n:node{n}",
                *(f"p:/node{n}/topic{k}" for k in range(counts.topics)),
                *(f"s:/node{(n - k - 1) % counts.nodes}/topic{k}" for k in range(counts.topics)),
            ],
        }
        for n in range(counts.nodes)
    }
    page = {"path": "/", "title": "Many", "content": [{"buttons": name} for name in nodes]}
    site = {"title": "Many", "asyncify": False}
    return {"site": site, "workspace": ".", "nodes": nodes, "pages": [page]}


def _open(browser: Browser, url: str) -> Page:
    page = browser.new_page()
    page.goto(url)
    page.evaluate("async () => { window.drive = await import('/bench/drive.js'); }")
    return page


def _start(page: Page, names: list[str]) -> None:
    page.evaluate("(names) => drive.start(names)", names)


def _stop(page: Page, names: list[str]) -> None:
    page.evaluate("(names) => drive.stop(names)", names)


def _times(page: Page, name: str, counts: Counts) -> list[float]:
    return [page.evaluate(f"drive.runNode('{name}')")[0] for _ in range(counts.bursts)]


def memory(browser: Browser) -> float:
    """Return what the renderers have in memory, in bytes."""
    return _sum(browser, "statm", lambda fields: int(fields[1]) * os.sysconf("SC_PAGE_SIZE"))


def processor(browser: Browser) -> float:
    """Return the seconds of processor time that the renderers have used."""
    ticks = os.sysconf("SC_CLK_TCK")
    return _sum(browser, "stat", lambda fields: (int(fields[13]) + int(fields[14])) / ticks)


def _sum(browser: Browser, file: str, of: Callable[[list[str]], float]) -> float:
    session = browser.new_browser_cdp_session()
    processes = session.send("SystemInfo.getProcessInfo")["processInfo"]
    session.detach()
    renderers = [process["id"] for process in processes if process["type"] == "renderer"]
    return sum(of(Path(f"/proc/{pid}/{file}").read_text().split()) for pid in renderers)
