"""What is written, what is not, and what is said of it."""

from __future__ import annotations

import io
import re
from pathlib import Path

import pytest

from sitegen.build import MARKER, check_paths
from sitegen.commands.build import build
from sitegen.errors import SiteError
from sitegen.model import Artifact
from sitegen.report import Report, size

SITE = "site:\n  title: Notes\npages:\n  - path: /\n    title: Notes\n    content:\n"


def notes(folder: Path, content: str) -> Path:
    """A site without nodes."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "site.yaml").write_text(SITE + content)
    return folder


def problems(folder: Path, output: Path) -> list[str]:
    with pytest.raises(SiteError) as wrong:
        build(folder, output=output, report=Report(io.StringIO()))
    return wrong.value.lines


def test_a_build_says_what_it_made_and_what_to_do_next(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    said = io.StringIO()
    build(
        notes(tmp_path, "      - markdown: Hello\n"), output=tmp_path / "dist", report=Report(said)
    )
    first, last = said.getvalue().splitlines()
    assert first.split() == ["/", "Notes"]
    assert re.match(r"built 1 page, 0 nodes, [1-9]\d* kB in ", last)
    assert last.endswith(" → dist (python -m http.server --directory dist)")


def test_many_pages_are_summed_up(tmp_path: Path) -> None:
    for number in range(25):
        (tmp_path / f"page{number:02}.md").write_text(f"# Page {number}\n")
    (tmp_path / "zoo.md").write_text("# Zoo\n\n```ros\ntopics:\n```\n")
    (tmp_path / "site.yaml").write_text("site: {title: T}\npages: [{path: docs, folder: .}]\n")
    said = io.StringIO()
    build(tmp_path, output=tmp_path / "dist", report=Report(said))
    *lines, last = said.getvalue().splitlines()
    assert lines == ["  /docs/…  I4  26 pages", "  --verbose lists all"]
    assert last.startswith("built 26 pages, 0 nodes")
    said = io.StringIO()
    build(tmp_path, output=tmp_path / "dist", report=Report(said), verbose=True)
    *pages, last = said.getvalue().splitlines()
    assert [page.split()[0] for page in pages] == [
        *(f"/docs/page{number:02}/" for number in range(25)),
        "/docs/zoo/",
    ]


def test_a_page_without_nodes_needs_nothing_of_the_runtime(tmp_path: Path) -> None:
    build(notes(tmp_path, "      - markdown: Hello\n"), output=tmp_path / "dist", report=Report())
    assert not (tmp_path / "dist" / "runtime").exists()


def test_a_failed_build_leaves_the_old_site(tmp_path: Path) -> None:
    output = tmp_path / "dist"
    build(notes(tmp_path, "      - markdown: Before\n"), output=output, report=Report())
    notes(tmp_path, "      - markdown: After ![a](gone.png)\n")
    assert problems(tmp_path, output) == [
        "site.yaml:7: image: no file 'gone.png' in .; there are none"
    ]
    assert "Before" in (output / "index.html").read_text()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["dist", "site.yaml"]


def test_a_new_build_replaces_the_old_one_as_a_whole(tmp_path: Path) -> None:
    output = tmp_path / "dist"
    build(notes(tmp_path, "      - markdown: Before\n"), output=output, report=Report())
    (output / "left-over.html").write_text("")
    build(notes(tmp_path, "      - markdown: After\n"), output=output, report=Report())
    assert not (output / "left-over.html").exists()
    assert "After" in (output / "index.html").read_text()


def test_a_folder_of_the_author_is_not_replaced(tmp_path: Path) -> None:
    output = tmp_path / "precious"
    output.mkdir()
    (output / "thesis.tex").write_text("years of work")
    assert problems(notes(tmp_path / "site", "      - markdown: Hello\n"), output) == [
        f"{output} contains files that sitegen did not write; empty it or choose another --output"
    ]
    assert (output / "thesis.tex").exists()
    assert not (output / MARKER).exists()


def test_two_artifacts_on_one_path_are_an_error(tmp_path: Path) -> None:
    theme = tmp_path / "style.css"
    with pytest.raises(SiteError) as wrong:
        check_paths([Artifact("theme/style.css", theme), Artifact("theme/style.css", b"")])
    assert wrong.value.lines == [
        "theme/style.css: two files of the site have this path: "
        f"{theme} and a file that sitegen writes"
    ]


def test_a_page_where_the_theme_lies_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "style.css").write_text("")
    site = notes(tmp_path, "      - markdown: Hello\n")
    text = "  - path: theme/\n    title: Theme\n    content: [{markdown: '[a](style.css)'}]\n"
    (site / "site.yaml").write_text((site / "site.yaml").read_text() + text)
    [line] = problems(site, tmp_path / "dist")
    assert line.startswith("theme/style.css: two files of the site have this path: ")


def test_pages_may_share_a_file(tmp_path: Path) -> None:
    site = notes(tmp_path / "site", "      - markdown: '[a](demo/data.csv)'\n")
    (site / "demo").mkdir()
    (site / "demo" / "page.md").write_text("# Demo\n\n[a](data.csv)\n")
    (site / "demo" / "data.csv").write_text("1,2\n")
    text = "  - {path: demo/, file: demo/page.md}\n"
    (site / "site.yaml").write_text((site / "site.yaml").read_text() + text)
    build(site, output=tmp_path / "dist", report=Report())
    assert (tmp_path / "dist" / "demo" / "data.csv").read_text() == "1,2\n"


class Terminal(io.StringIO):
    """What a terminal is sent."""

    def isatty(self) -> bool:
        return True


def test_a_terminal_gets_a_live_line_for_each_thing_under_way(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("TERM", "xterm")
    screen = Terminal()
    report = Report(screen)
    report.doing("talker", "compiling")
    report.doing("listener", "compiling")
    report.done("talker")
    assert screen.getvalue().endswith("\x1b[2A\x1b[J  listener: compiling\n")


def test_a_terminal_shows_the_stages_of_a_build_and_keeps_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TERM", "xterm")
    screen = Terminal()
    site = notes(tmp_path, "      - markdown: Hello\n")
    build(site, output=tmp_path / "dist", report=Report(screen))
    written = screen.getvalue()
    for stage in ("site.yaml: reading it, and the workspace", "pages: rendering 1"):
        assert f"  {stage}\n\x1b[1A\x1b[J" in written
    assert "pages: rendering" not in written.rpartition("\x1b[J")[2]


def test_what_is_said_once_is_not_said_of_a_build_without_changes() -> None:
    out = io.StringIO()
    report = Report(out)
    report.say("numpy is missing")
    report.say_once("optimizing 2 nodes")
    assert out.getvalue() == "numpy is missing\noptimizing 2 nodes\n"
    assert report.said == ["numpy is missing"]


def test_sizes_are_written_for_people() -> None:
    assert [size(68_971), size(1_250_000)] == ["69 kB", "1.2 MB"]
