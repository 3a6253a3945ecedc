"""A build of what was built already: nothing is done, and nothing that counts is overlooked."""

from __future__ import annotations

import io
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from sitegen.__main__ import main
from sitegen.commands.build import build
from sitegen.commands.serve.live import LiveSite
from sitegen.report import Report, Style

SITE = """\
site: {title: My robot}
pages:
  - {path: /, file: index.md}
  - {path: other/, file: other.md}
"""
COMMIT = "git init -q && git add . && git -c user.name=A -c user.email=a@b.c commit -qm First"
Run = Callable[[], str]


@pytest.fixture
def site(tmp_path: Path) -> Path:
    folder = tmp_path / "site"
    (folder / "themes/mine").mkdir(parents=True)
    (folder / "themes/mine/style.css").write_text("main { color: red; }\n")
    (folder / "site.yaml").write_text(SITE.replace("robot}", "robot, theme: mine}"))
    (folder / "index.md").write_text("# Welcome\n\nThe first text.\n")
    (folder / "other.md").write_text("# Other\n\n![A robot](robot.svg)\n")
    svg = '<svg xmlns="http://www.w3.org/2000/svg" width="4" height="3"/>'
    (folder / "robot.svg").write_text(svg)
    return folder


@pytest.fixture
def run(site: Path, tmp_path: Path) -> Run:
    """A function that builds the site as a command, and returns what that says last."""

    def build() -> str:
        done = subprocess.run(
            [sys.executable, "-m", "sitegen", "build", site],
            capture_output=True,
            text=True,
            env=os.environ | {"SITEGEN_CACHE": str(tmp_path / "cache")},
        )
        assert done.returncode == 0, done.stderr
        first, *_, last = done.stdout.splitlines()
        assert first.split() == ["/", "Welcome"]
        return last

    return build


def test_a_second_build_does_nothing(site: Path, run: Run) -> None:
    assert run().startswith("built 2 pages")
    before = (site / "dist/index.html").stat().st_ino
    assert run().startswith("nothing changed")
    assert (site / "dist/index.html").stat().st_ino == before


def test_a_second_build_in_the_current_folder_does_nothing(
    site: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("SITEGEN_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(site)
    for last in ("built 2 pages", "nothing changed"):
        assert main(["build"]) == 0
        assert capsys.readouterr().out.splitlines()[-1].startswith(last)


@pytest.mark.parametrize(
    "change",
    [
        lambda site: (site / "index.md").write_text("# Welcome\n\nThe other text.\n"),
        lambda site: (site / "site.yaml").write_text(SITE),
        lambda site: (site / "themes/mine/style.css").write_text("main { color: blue; }\n"),
        lambda site: (site / "robot.svg").write_text("<svg/>"),
        lambda site: (site / "new.md").write_text("# New\n"),
        lambda site: (site / "dist/index.html").write_text("spoilt"),
        lambda site: (site / "dist/more.html").write_text("mine"),
        lambda site: (site / "dist/other/index.html").unlink(),
        lambda site: subprocess.run(COMMIT, cwd=site, shell=True, check=True),
    ],
    ids=["page", "site", "theme", "image", "file", "spoilt", "foreign", "gone", "history"],
)
def test_whatever_changes_is_built(site: Path, run: Run, change: Callable[[Path], object]) -> None:
    run()
    assert run().startswith("nothing changed")
    change(site)
    assert run().startswith("built 2 pages")
    assert run().startswith("nothing changed")


def test_what_changes_while_a_site_is_built_is_built_next(
    site: Path, run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Editing(Report):
        """An author who writes while the build tells what it has made."""

        def say(self, line: str, style: Style = "") -> None:
            (site / "index.md").write_text("# Welcome\n\nThe other text.\n")
            super().say(line, style)

    monkeypatch.setenv("SITEGEN_CACHE", str(tmp_path / "cache"))
    build(site, output=site / "dist", report=Editing(io.StringIO()))
    assert "The first text" in (site / "dist/index.html").read_text()
    assert run().startswith("built 2 pages")
    assert "The other text" in (site / "dist/index.html").read_text()


def test_the_history_of_a_second_working_tree_counts(site: Path, run: Run) -> None:
    origin = site.parent / "origin"
    commands = f"mkdir {origin} && cd {origin} && echo a > a && {COMMIT}"
    subprocess.run(commands, shell=True, check=True)
    tree = site.parent / "tree"
    subprocess.run(["git", "-C", origin, "worktree", "add", "-q", tree], check=True)
    (tree / ".git").rename(site / ".git")
    run()
    assert run().startswith("nothing changed")
    subprocess.run(COMMIT, cwd=site, shell=True, check=True)
    assert run().startswith("built 2 pages")


def test_an_edit_renders_that_page_alone(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    said = io.StringIO()
    live = LiveSite(site, Report(said))
    live.rebuild()
    rendered: list[str] = []
    from sitegen.site.pages import Renderer

    page = Renderer.page

    def noted(self: Renderer, each: object, **more: bool) -> object:
        rendered.append(each.path)  # type: ignore[attr-defined]
        return page(self, each, **more)  # type: ignore[arg-type]

    monkeypatch.setattr(Renderer, "page", noted)

    def edit(file: str, text: str) -> tuple[list[str], str]:
        (site / file).write_text(text)
        rendered.clear()
        live.rebuild([site / file])
        shown = live.file("index.html")
        assert shown
        assert isinstance(shown.source, bytes)
        # The page of a server's errors is made with each build.
        return [path for path in rendered if path != "404.html"], shown.source.decode()

    paths, html = edit("index.md", "# Welcome\n\nThe second text.\n")
    assert paths == [""]
    assert "The second text." in html
    # A title stands in the menu of all pages.
    paths, html = edit("other.md", "# Another\n\nText\n")
    assert paths == ["", "other/"]
    assert "Another</a>" in html
    # An error is told, and what is right again is shown.
    paths, html = edit("index.md", "# Welcome\n\n[gone](gone.md)\n")
    assert "The second text." in html
    assert "no file 'gone.md'" in said.getvalue()
    _, html = edit("index.md", "# Welcome\n\nThe third text.\n")
    assert "The third text." in html
    paths, html = edit("site.yaml", SITE)
    assert paths == ["", "other/"]
