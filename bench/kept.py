"""The figures of an earlier run that were kept, and what has become slower since."""

from __future__ import annotations

import json
import statistics
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from bench.figure import Figure, Kept, cells

FILE = Path(__file__).parent / "kept.json"
README = Path(__file__).parent / "README.md"
HEAD = "| figure | ours | bare | ratio | target |\n|---|---|---|---|---|\n"


def median(runs: Sequence[Sequence[Figure]]) -> list[Figure]:
    """Return the median of each figure of several runs, with its noise."""
    found = []
    for first in runs[0]:
        same = [figure for run in runs for figure in run if figure.name == first.name]
        bares = [figure.bare for figure in same if figure.bare is not None]
        middle = replace(
            first,
            ours=statistics.median(figure.ours for figure in same),
            bare=statistics.median(bares) if bares else None,
        )
        if len(same) > 1:
            value = middle.compared
            noise = max(abs(figure.compared - value) for figure in same) / value
            middle = replace(middle, noise=noise)
        found.append(middle)
    return found


def load_kept() -> dict[str, Kept]:
    """Return the figures that were kept, by name."""
    return {
        entry["name"]: Kept(
            entry["ratio"] or entry["ours"], "" if entry["ratio"] else entry["unit"], entry["noise"]
        )
        for entry in json.loads(FILE.read_text())
    }


def keep(figures: Sequence[Figure]) -> None:
    """Write the figures over those that were kept, and the table of the README from all.

    What was not measured stays as it was.
    """
    entries = {entry["name"]: entry for entry in json.loads(FILE.read_text())}
    # Without what each run measured: the files in results/ have that.
    entries |= {figure.name: replace(figure, detail={}).entry() for figure in figures}
    FILE.write_text(json.dumps([*entries.values()], indent=1, ensure_ascii=False) + "\n")
    text = README.read_text()
    before = text[: text.index(HEAD) + len(HEAD)]
    README.write_text(before + "".join(map(row, entries.values())))


def row(entry: Mapping[str, Any]) -> str:
    """Return the line of a kept figure in the table of the README."""
    target = entry["target"] + (", not met" if entry["met"] is False else "")
    return f"| {' | '.join([*cells(entry), target])} |\n"


def changes(figures: Sequence[Figure], kept: Mapping[str, Kept]) -> list[str]:
    """Say which figures are worse than before by more than the noise of both."""
    said = []
    for figure in figures:
        before = kept.get(figure.name)
        if before is None or figure.noise is None:
            continue
        now = figure.compared
        worse = before.value / now - 1 if figure.higher else now / before.value - 1
        if worse > figure.noise + (before.noise or figure.noise):
            said.append(
                f"{figure.name}: {before}, now {Kept(now, before.unit)}; "
                f"{worse:.0%} worse, where single runs differ by {figure.noise:.0%}"
            )
    return said
