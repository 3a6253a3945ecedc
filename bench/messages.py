"""Measure messages between two C++ nodes, beside the same bytes between two bare workers."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from statistics import median, median_grouped, quantiles

from playwright.sync_api import Page

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.figure import Figure, Target

SITE = Path(__file__).parent / "site"


@dataclass(frozen=True)
class Size:
    """A size of message: the nodes of site.yaml that end in `name` send it so often."""

    title: str
    name: str
    count: int
    rounds: int
    messages: int
    # The first rounds of a turn do not count: programs and engine warm up.
    warm_up: int


SIZES = [
    Size("16 B", "16", 16, rounds=3000, messages=20_000, warm_up=1000),
    Size("1 KB", "1k", 1024, rounds=3000, messages=20_000, warm_up=1000),
    Size("1 MB", "1m", 1024 * 1024, rounds=80, messages=100, warm_up=20),
]
SMALL = SIZES[0]

CALLS = 3000

# The clock of an isolated page steps by 5 µs.
CLOCK = 0.005

LATENCY_TARGETS = {("16 B", "p50"): 1.5, ("16 B", "p99"): 3.0}
THROUGHPUT_TARGETS = {"16 B": 1.0, "1 MB": 0.5}
BUSY_TARGET = 2.0
CALL_TARGET = 1.5
# The main thread works so long in every frame (ms).
BUSY = 16


def latency(counts: Counts) -> list[Figure]:
    """One way from node to node: half of a round trip."""
    figures = []
    with _bench_page() as page:
        idle: list[float] = []
        for size in SIZES:
            ours, bare = _ping(page, size, counts)
            idle = ours if size is SMALL else idle
            for name, middle in (("p50", p50), ("p99", p99)):
                limit = LATENCY_TARGETS.get((size.title, name))
                target = Target("ratio", "≤", limit) if limit else None
                title = f"latency {size.title}, {name}"
                figures.append(one_way(title, middle(ours), middle(bare), target))
        page.evaluate(f"window.rest = drive.beBusy({BUSY})")
        busy, _ = _ping(page, SMALL, counts)
        page.evaluate("rest()")
        name = f"latency 16 B, page busy {BUSY} ms a frame, p50 (bare: ours when idle)"
        target = Target("ratio", "≤", BUSY_TARGET)
        figures.append(one_way(name, p50(busy), p50(idle), target))
    return figures


def throughput(counts: Counts) -> list[Figure]:
    """Messages a second in one direction, counted when the last has arrived."""
    figures = []
    with _bench_page() as page:
        for size in SIZES:
            ours, bare = [], []
            for _ in range(counts.turns):
                bare += numbers(page, f"runBare('burst', {size.count}, {size.messages})")
                ours += numbers(page, f"runNode('burst_{size.name}')")
            limit = THROUGHPUT_TARGETS.get(size.title)
            figures.append(
                Figure(
                    f"throughput {size.title}",
                    "/s",
                    size.messages / median(ours) * 1000,
                    size.messages / median(bare) * 1000,
                    Target("ratio", "≥", limit) if limit else None,
                    {"ours_ms": ours, "bare_ms": bare, "messages": size.messages},
                )
            )
    return figures


def services(counts: Counts) -> list[Figure]:
    """A call from node to node and its answer, beside two exchanges: a message there and back."""
    ours, bare = [], []
    with _bench_page() as page:
        for _ in range(counts.turns):
            bare += numbers(page, f"runBare('ping', {SMALL.count}, {CALLS})")[SMALL.warm_up :]
            ours += numbers(page, "runNode('call')")[SMALL.warm_up :]
    target = Target("ratio", "≤", CALL_TARGET)
    return [
        Figure("service call, p50", "µs", p50(ours) * 1000, p50(bare) * 1000, target),
        Figure("service call, p99", "µs", p99(ours) * 1000, p99(bare) * 1000),
    ]


@contextmanager
def _bench_page() -> Iterator[Page]:
    with serving_site(SITE, isolated=True) as url, chromium() as browser:
        page = browser.new_page()
        page.goto(url)
        page.evaluate("async () => { window.drive = await import('/bench/drive.js'); }")
        yield page


def _ping(page: Page, size: Size, counts: Counts) -> tuple[list[float], list[float]]:
    """Return round trips of ours and of bare workers, in ms.

    They take turns, so that what else the machine does affects both.
    """
    ours, bare = [], []
    for _ in range(counts.turns):
        bare += numbers(page, f"runBare('ping', {size.count}, {size.rounds})")[size.warm_up :]
        ours += numbers(page, f"runNode('ping_{size.name}')")[size.warm_up :]
    return ours, bare


def numbers(page: Page, call: str) -> list[float]:
    """Return the numbers that a function of drive.js resolves with."""
    return list(page.evaluate(f"drive.{call}"))


def p50(rounds: list[float]) -> float:
    """Return the median."""
    # Most rounds take a few steps of the clock: the median counts how many are at each of them.
    return median_grouped(rounds, CLOCK)


def p99(rounds: list[float]) -> float:
    """Return what one in a hundred is above of."""
    return quantiles(rounds, n=100)[98]


def one_way(name: str, ours: float, bare: float, target: Target | None) -> Figure:
    """Make a figure in µs of two round trips in ms."""
    return Figure(name, "µs", ours / 2 * 1000, bare / 2 * 1000, target)
