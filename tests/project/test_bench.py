"""Every part of the bench runs; what it measures is for `make bench`."""

from __future__ import annotations

import json
import multiprocessing
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import pytest
from playwright.sync_api import Page

from bench import __main__ as bench
from bench import crowd, kept
from bench.browser import serving_site
from bench.counts import SMALLEST
from bench.figure import Figure, Kept

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


def test_the_table_of_the_readme_shows_what_is_kept() -> None:
    rows = "".join(map(kept.row, json.loads(kept.FILE.read_text())))
    assert kept.README.read_text().endswith(kept.HEAD + rows)


def test_what_became_worse_by_more_than_the_noise_is_named() -> None:
    before = {"call": Kept(2.0, "", 0.05), "burst": Kept(100, "/s", 0.05), "start": Kept(160, "ms")}

    def run(call: float, burst: float, start: float) -> list[Figure]:
        return [
            Figure("call", "µs", call, 100),
            Figure("burst", "/s", burst),
            Figure("start", "ms", start),
            Figure("unknown", "ms", start),
        ]

    found = kept.median([run(230, 99, 160), run(200, 101, 160), run(202, 400, 160)])
    assert [figure.ours for figure in found] == [202, 101, 160, 160]
    assert found[0].noise == pytest.approx(28 / 202)
    assert kept.changes(found, before) == []
    slower = kept.median([run(260, 80, 170), run(250, 80, 170), run(255, 81, 170)])
    assert kept.changes(slower, before) == [
        "call: 2.00, now 2.55; 27% worse, where single runs differ by 2%",
        "burst: 100 /s, now 80 /s; 25% worse, where single runs differ by 1%",
        "start: 160 ms, now 170 ms; 6% worse, where single runs differ by 0%",
    ]
    # A single run does not tell how much runs differ.
    assert kept.changes(kept.median([run(900, 9, 900)]), before) == []


def test_what_is_kept_replaces_only_what_was_measured(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("FILE", "README"):
        copy = tmp_path / getattr(kept, name).name
        copy.write_text(getattr(kept, name).read_text())
        monkeypatch.setattr(kept, name, copy)
    first, *others = json.loads(kept.FILE.read_text())
    detail = {"runs": [49, 50, 51]}
    kept.keep([Figure(first["name"], "µs", 50, 40, detail=detail), Figure("new", "ms", 7)])
    found = json.loads(kept.FILE.read_text())
    assert found[0]["ours"] == 50
    assert found[0].keys() == first.keys()
    assert found[1:-1] == others
    assert kept.load_kept()["new"] == Kept(7, "ms")
    assert kept.README.read_text().endswith("| new | 7 ms |  |  |  |\n")
    assert f"| {first['name']} | 50 µs | 40 µs | 1.25 |  |\n" in kept.README.read_text()
