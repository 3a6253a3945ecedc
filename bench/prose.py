"""Measure how long a site of a thousand pages takes, beside MkDocs on the same files."""

from __future__ import annotations

import importlib.util
import random
import shutil
import sys
import tempfile
from pathlib import Path
from statistics import median

from bench.browser import Progress
from bench.building import run, seconds
from bench.counts import Counts
from bench.figure import Figure, Target
from sitegen.commands.serve.live import LiveSite

MKDOCS = importlib.util.find_spec("mkdocs") is not None
WORDS = ["node", "topic", "service", "message", "robot", "publisher", "timer", "graph", "worker"]
CODE = "```cpp\nint main(int argc, char ** argv)\n{\n  rclcpp::init(argc, argv);\n}\n```\n"

COLD_TARGET = Target("ratio", "≤", 0.2)
EDIT_TARGET = Target("figure", "≤", 100)
NOTHING_TARGET = Target("figure", "≤", 300)


def prose(counts: Counts) -> list[Figure]:
    """Measure a build of all pages, in turns with MkDocs, and one page again after an edit."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        _write(folder, counts)
        ours_command = [sys.executable, "-m", "sitegen", "build", str(folder)]
        theirs_command = [sys.executable, "-m", "mkdocs", "build", "--quiet"]
        theirs_command += ["--config-file", str(folder / "mkdocs.yml")]
        ours, theirs = [], []
        for _ in range(min(counts.repeats, 3)):
            # A build of what is there already would do nothing.
            shutil.rmtree(folder / "dist", ignore_errors=True)
            ours.append(seconds(lambda: run(ours_command)))
            if MKDOCS:
                theirs.append(seconds(lambda: run(theirs_command)))
        nothing = [seconds(lambda: run(ours_command)) for _ in range(min(counts.repeats, 3))]
        edit = _edit(folder)
    count = counts.folders * counts.pages + 1
    # Without MkDocs there is nothing to compare with.
    bare, target = (median(theirs), COLD_TARGET) if theirs else (None, None)
    return [
        Figure(f"{count} pages of Markdown (bare: MkDocs)", "s", median(ours), bare, target),
        Figure("one of them served again, after an edit", "ms", edit * 1000, None, EDIT_TARGET),
        Figure("all again, nothing changed", "ms", median(nothing) * 1000, None, NOTHING_TARGET),
    ]


def _edit(folder: Path) -> float:
    """Return how long `sitegen serve` takes for an edited page (s)."""
    live = LiveSite(folder, Progress())
    live.rebuild()
    times = []
    for file in sorted((folder / "docs/s00").glob("*.md"))[:9]:
        file.write_text(f"{file.read_text()}\nOne more line.\n")
        times.append(seconds(lambda file=file: live.rebuild([file])))  # type: ignore[misc]
    return median(times)


def _write(folder: Path, counts: Counts) -> None:
    """Write pages of some length, the same each time, with links between them."""
    words = random.Random(1)
    for number in range(counts.folders):
        for place in range(counts.pages):
            file = folder / f"docs/s{number:02}/page{place:02}.md"
            file.parent.mkdir(parents=True, exist_ok=True)
            following = f"page{(place + 1) % counts.pages:02}.md"
            sections = (_section(words, heading, following) for heading in range(4))
            table = "| a | b |\n|---|---|\n| 1 | 2 |\n\n"
            file.write_text(f"# Page {number}-{place}\n\n{''.join(sections)}{table}{CODE}")
    (folder / "docs/index.md").write_text("# Home\n\nHello\n")
    (folder / "mkdocs.yml").write_text("site_name: Thousand\n")
    (folder / "site.yaml").write_text("site: {title: Thousand}\npages: [{path: /, folder: docs}]\n")


def _section(words: random.Random, heading: int, following: str) -> str:
    text = f"{_sentence(words, 60)} See [the next]({following}) and `code`.\n\n"
    items = "".join(f"- {_sentence(words, 8)}\n" for _ in range(2))
    return f"## Section {heading}\n\n{text}{items}- **{_sentence(words, 5)}**\n\n"


def _sentence(words: random.Random, count: int) -> str:
    return f"{' '.join(words.choice(WORDS) for _ in range(count)).capitalize()}."
