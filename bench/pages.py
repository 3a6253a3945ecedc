"""Measure how soon a page runs its node, and how much it loads until then."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from statistics import median

import brotli
from playwright.sync_api import Browser

from bench.browser import Progress, chromium, serving, serving_site
from bench.counts import Counts
from bench.figure import Figure, Target
from sitegen import config
from sitegen.commands.build import build
from sitegen.model import Page

ROOT = Path(__file__).parent.parent
DEMO01 = ROOT / "demos" / "demo01"
PROGRAM = "nodes/cpp_hello/talker.jspi.wasm"
# The program of demo01 waits for its timer before it prints (ms).
TIMER = 500

# A visitor who is far away: how long a request takes at least (ms), and bytes in a second.
ROUND_TRIP = 50
BANDWIDTH = 10_000_000 // 8

START_TARGET = Target("figure", "≤", 300)
FAR_TARGET = Target("figure", "≤", 6)
SIZE_TARGET = Target("figure", "≤", 150)

# Resolves when a line stands in every console, with the time since navigation (ms) and the first.
FIRST_LINES = """
  window.firstLines = new Promise((resolve, reject) => {
    setTimeout(() => reject(new Error("no line in 20 seconds")), 20000);
    const look = () => {
      const logs = [...document.querySelectorAll(".ros-console [role=log]")];
      if (logs.length === 0 || logs.some((log) => !log.hasChildNodes())) return;
      observer.disconnect();
      resolve([performance.now(), logs[0].textContent]);
    };
    const observer = new MutationObserver(look);
    observer.observe(document, { childList: true, subtree: true });
  });
"""


# Starts all nodes; resolves when none is still starting and no console is empty. Looking again and
# again cannot miss anything, whatever happened before.
ALL_LINES = """async () => {
  const { ros } = await import(document.querySelector("script[src*=rosMain]").src);
  for (const node of ros.nodes.values()) node.start();
  const end = performance.now() + 60_000;
  while (performance.now() < end) {
    const logs = [...document.querySelectorAll(".ros-console [role=log]")];
    const starting = [...ros.nodes.values()].filter(({ state }) => state === "starting");
    if (starting.length === 0 && logs.every((log) => log.hasChildNodes())) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  throw new Error("a node does not start or print within 60 s");
}"""


def start(counts: Counts) -> list[Figure]:
    """From navigation to the first line in the console of demo01, with nothing in any cache."""
    with serving_site(DEMO01) as url, chromium() as browser:
        bare_url = f"{url}bench/hello.html#/{PROGRAM}"
        ours, bare = [], []
        for _ in range(counts.starts + 1):
            bare.append(first_line(browser, bare_url)[0])
            ours.append(first_line(browser, url)[0] - TIMER)
    # The first of each also starts processes of the browser.
    ours, bare = ours[1:], bare[1:]
    name = f"navigation → first line, demo01 (without its timer's {TIMER} ms)"
    detail = {"ours_ms": ours, "bare_ms": bare}
    near = Figure(name, "ms", median(ours), median(bare), START_TARGET, detail)
    return [near, far(counts)]


def far(counts: Counts) -> Figure:
    """The same in round trips, for a visitor far away from the server."""
    with serving_site(DEMO01, hosted=True) as url, chromium() as browser:
        bare_url = f"{url}bench/hello.html#/{PROGRAM}"
        ours, bare = [], []
        for _ in range(counts.starts + 1):
            bare.append(first_line(browser, bare_url, far=True)[0] / ROUND_TRIP)
            ours.append((first_line(browser, url, far=True)[0] - TIMER) / ROUND_TRIP)
    ours, bare = ours[1:], bare[1:]
    name = f"the same in round trips of {ROUND_TRIP} ms, at {BANDWIDTH * 8 // 1_000_000} Mbit/s"
    detail = {"ours_round_trips": ours, "bare_round_trips": bare}
    return Figure(name, "", median(ours), median(bare), FAR_TARGET, detail)


def first_line(browser: Browser, url: str, *, far: bool = False) -> tuple[float, str]:
    """Open a page in a new context; return when its first line came (ms), and that line."""
    context = browser.new_context()
    try:
        page = context.new_page()
        if far:
            conditions = {"downloadThroughput": BANDWIDTH, "uploadThroughput": BANDWIDTH}
            context.new_cdp_session(page).send(
                "Network.emulateNetworkConditions",
                {"offline": False, "latency": ROUND_TRIP, **conditions},
            )
        page.add_init_script(FIRST_LINES)
        page.goto(url, wait_until="commit")
        time, line = page.evaluate("firstLines")
        return float(time), str(line)
    finally:
        context.close()


def size(counts: Counts) -> list[Figure]:
    """All that a page loads until its nodes run and its consoles have lines; bare: its programs."""
    site = config.load(ROOT / "site.yaml")
    figures = []
    with tempfile.TemporaryDirectory() as temporary, chromium() as browser:
        dist = Path(temporary) / "dist"
        build(ROOT, output=dist, report=Progress())
        pages = {page.path: page for page in site.pages}
        for page in [pages[path] for path in counts.loads or pages]:
            asked: set[str] = set()
            with serving(dist, asked=asked) as url:
                _run(browser, page, url)
            figures += _sizes(page, dist, asked, counts.brotli)
    return figures


def _run(browser: Browser, page: Page, url: str) -> None:
    """Open a page, start its nodes, and stay until they run and each console has a line."""
    context = browser.new_context()
    try:
        tab = context.new_page()
        tab.goto(url + page.path)
        if page.nodes:
            tab.evaluate(ALL_LINES)
    finally:
        context.close()


def _sizes(page: Page, dist: Path, asked: Iterable[str], quality: int) -> list[Figure]:
    files = {path: dist / path[1:] for path in sorted(asked)}
    files = {path: f / "index.html" if path.endswith("/") else f for path, f in files.items()}
    raw = {path: f.stat().st_size for path, f in files.items()}
    packed = {path: _packed(f, quality) for path, f in files.items()}
    name = f"loaded by /{page.path}"
    # The promise is about a page with one talker.
    target = SIZE_TARGET if page.path == "demo01/" else None
    return [_sum(f"{name}, as it is", raw), _sum(f"{name}, brotli", packed, target)]


@cache
def _packed(file: Path, quality: int) -> int:
    """Return the size of a compressed file; most files are loaded by several pages."""
    return len(brotli.compress(file.read_bytes(), quality=quality))


def _sum(name: str, sizes: Mapping[str, int], target: Target | None = None) -> Figure:
    programs = sum(size for path, size in sizes.items() if path.startswith("/nodes/"))
    everything = sum(sizes.values())
    return Figure(name, "kB", everything / 1000, programs / 1000 or None, target, {"files": sizes})
