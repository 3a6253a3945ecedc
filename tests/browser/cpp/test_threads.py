"""Threads of C++ in the page: the standard library's, and a loop beside a node that spins."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from panel import Panel, expect_nothing_left
from paths import SITES
from playwright.sync_api import BrowserContext

pytestmark = [pytest.mark.firefox, pytest.mark.asyncify(always=True)]

SITE = SITES / "engines"


def test_the_standard_library_has_its_threads(
    context: BrowserContext, serve: Serve, built: Built
) -> None:
    page = context.new_page()
    page.goto(serve(built(SITE)))
    threads = Panel(page, "threads")
    threads.start()
    threads.expect_state("failed")
    assert threads.lines() == [
        "count 100, ids 20, mine 0",
        "queue 1 2 3 timeout 1",
        "futures 0 42 of async at last",
        "exceptions bb aa cc ",
        "locks 0 1 0 1 0",
        "turns 012",
        "done",
        "threads: std::runtime_error: left a thread",
        "    (run 'sitegen build --debug' to see where)",
    ]


def test_a_loop_runs_beside_a_node_that_spins_until_stop(
    context: BrowserContext, serve: Serve, built: Built
) -> None:
    page = context.new_page()
    page.goto(serve(built(SITE)))
    spinning = Panel(page, "spinning")
    spinning.start()
    spinning.wait_for("heard from the loop")
    spinning.stop()
    spinning.wait_for("all ended")
    said = spinning.messages()
    assert sorted(said[:3]) == ["busy ended", "heard from the loop", "loop ended"]
    assert said[3:] == ["all ended"]
    expect_nothing_left(page)


def test_coroutines_are_switched_within_a_thread(
    context: BrowserContext, serve: Serve, built: Built
) -> None:
    page = context.new_page()
    page.goto(serve(built(SITE)))
    coroutines = Panel(page, "coroutines")
    coroutines.start()
    coroutines.expect_state("failed")
    assert coroutines.lines() == [
        "turns a0 b0 | a1 b1 | a2 b2 | ",
        "waits 0 1 thread 1",
        "nested inner outer main caught ",
        "threads 5 5 5",
        "moved 1 1",
        "left 1000",
        "coroutines: std::runtime_error: left a coroutine",
        "    (run 'sitegen build --debug' to see where)",
    ]
