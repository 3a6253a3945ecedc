"""Every part of the bench runs; what it measures is for `make bench`."""

from __future__ import annotations

import multiprocessing
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import pytest
from playwright.sync_api import Page

from bench import __main__ as bench
from bench import crowd
from bench.browser import serving_site
from bench.counts import SMALLEST
from bench.figure import Figure

pytestmark = pytest.mark.chromium


@pytest.mark.exhaustive
@pytest.mark.parametrize("part", bench.PARTS)
def test_a_part_runs(part: str) -> None:
    # A process of its own, as `make bench` is: the browser of other tests may run in this one.
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as process:
        figures = process.submit(bench.PARTS[part], SMALLEST).result()
    assert figures
    assert all(figure.ours > 0 for figure in figures)
    ratios = [figure for figure in figures if figure.target and figure.target.of == "ratio"]
    assert all(figure.bare for figure in ratios)


@pytest.mark.exhaustive
def test_a_node_that_runs_already_is_not_waited_for(tab: Page) -> None:
    with serving_site(crowd.SITE, isolated=True) as url:
        tab.goto(url)
        tab.evaluate("async () => { window.drive = await import('/bench/drive.js'); }")
        for act in ("start", "start", "stop", "stop"):
            tab.evaluate(f"drive.{act}(['sink'])")


def test_a_part_that_fails_costs_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def broken(counts: object) -> list[Figure]:
        raise RuntimeError("no such page")

    results = tmp_path / "bench" / "results"
    results.parent.mkdir()
    monkeypatch.setattr(bench, "RESULTS", results)
    one, other = Figure("one", "ms", 1.0), Figure("other", "ms", 2.0)
    parts = {"first": lambda counts: [one], "broken": broken, "last": lambda counts: [other]}
    monkeypatch.setattr(bench, "PARTS", parts)
    assert bench.main([]) == 1
    [kept] = results.iterdir()
    assert '"one"' in kept.read_text()
    assert '"other"' in kept.read_text()
    assert capsys.readouterr().err.endswith("failed: broken\n")
