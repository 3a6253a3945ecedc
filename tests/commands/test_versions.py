"""Versions of a site side by side: what is where, what stays, and what is refused."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from sitegen.__main__ import main

SITE = """\
site: {title: "Fox & Co", url: "https://me.example/fox/", offline: true}
pages:
  - {path: /, file: index.md}
  - {path: more/, file: more.md}
deploy: {cname: fox.example.org}
"""


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "site.yaml").write_text(SITE)
    (tmp_path / "index.md").write_text("# Fox\n")
    (tmp_path / "more.md").write_text("# More\n")
    return tmp_path


def build(site: Path, version: str, *words: str) -> None:
    assert main(["build", str(site), "--version", version, *words]) == 0


def listed(site: Path) -> list[tuple[str, ...]]:
    rows = json.loads((site / "dist/versions.json").read_text())
    return [(row["version"], *row["aliases"]) for row in rows]


def leads_to(site: Path, page: str) -> str:
    """The file of `dist/` that a page leads to, with and without a script."""
    file = site / "dist" / page
    html = file.read_text()
    assert "Fox &amp; Co" in html
    assert "'unsafe" not in html
    [script] = re.findall(r'<script src="(.*?)"></script>', html)
    assert (file.parent / script).resolve() == site / "dist/redirect.js"
    targets: set[str] = set(re.findall(r'(?:href="|url=)(.*?)"', html))
    [target] = targets
    return (file.parent / target).resolve().relative_to(site / "dist").as_posix()


def test_versions_stand_side_by_side(site: Path, capsys: pytest.CaptureFixture[str]) -> None:
    build(site, "1.9")
    assert leads_to(site, "index.html") == "1.9"
    assert "built version 1.9 of 1 version" in capsys.readouterr().out
    (site / "index.md").write_text("# Vixen\n")
    build(site, "1.10")
    dist = site / "dist"
    assert "Fox" in (dist / "1.9/index.html").read_text()
    assert "Vixen" in (dist / "1.10/index.html").read_text()
    # By number, not by letter, and names come last.
    build(site, "dev")
    assert listed(site) == [("1.10",), ("1.9",), ("dev",)]
    assert leads_to(site, "index.html") == "1.10"
    # Each knows its own address, and what hosts look for at the root is there.
    assert 'href="https://me.example/fox/1.9/more/"' in (dist / "1.9/more/index.html").read_text()
    assert (dist / "404.html").read_bytes() == (dist / "1.10/404.html").read_bytes()
    assert 'href="/fox/1.10/' in (dist / "404.html").read_text()
    assert (dist / "CNAME").read_text() == "fox.example.org\n"
    assert not (dist / "1.10/CNAME").exists()
    # A worker of the site before it had versions goes.
    assert "unregister" in (dist / "sw.js").read_text()
    assert "unregister" not in (dist / "1.10/sw.js").read_text()


def test_an_alias_leads_to_the_pages_of_its_version(site: Path) -> None:
    build(site, "1.0", "--alias", "latest", "--alias", "lts")
    build(site, "1.1")
    assert listed(site) == [("1.1",), ("1.0", "latest", "lts")]
    assert leads_to(site, "index.html") == "1.0"
    assert leads_to(site, "latest/more/index.html") == "1.0/more"
    build(site, "1.1", "--alias", "latest")
    assert listed(site) == [("1.1", "latest"), ("1.0", "lts")]
    assert leads_to(site, "index.html") == "1.1"
    assert leads_to(site, "latest/index.html") == "1.1"
    assert leads_to(site, "lts/more/index.html") == "1.0/more"
    # A new state of a version keeps its names, and nothing of its old state.
    (site / "site.yaml").write_text(SITE.replace("path: more/", "path: other/"))
    build(site, "1.1")
    assert listed(site) == [("1.1", "latest"), ("1.0", "lts")]
    assert not (site / "dist/1.1/more").exists()
    assert not (site / "dist/latest/more").exists()


def test_a_build_has_versions_or_none(site: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", str(site)]) == 0
    build(site, "1.0")
    assert not (site / "dist/more").exists()
    capsys.readouterr()
    assert main(["build", str(site)]) == 1
    dist = site / "dist"
    how = "build another with --version, or choose another --output"
    assert capsys.readouterr().err.splitlines()[0] == (f"{dist} contains versions of a site; {how}")
    assert listed(site) == [("1.0",)]


def test_a_site_that_is_wrong_changes_no_version(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    build(site, "1.0")
    before = {file: file.read_bytes() for file in site.glob("dist/**/*") if file.is_file()}
    (site / "index.md").write_text("# Fox\n\n[gone](gone.md)\n")
    assert main(["build", str(site), "--version", "1.1"]) == 1
    assert "no file 'gone.md'" in capsys.readouterr().err
    assert {f: f.read_bytes() for f in site.glob("dist/**/*") if f.is_file()} == before


@pytest.mark.parametrize(
    ("words", "fault"),
    [
        (("--version", "latest"), "'latest' is an alias of version 1.0; choose another --version"),
        (("--version", "1.1", "--alias", "1.0"), "'1.0' is a version; choose another --alias"),
    ],
)
def test_a_name_means_one_version(
    site: Path, capsys: pytest.CaptureFixture[str], words: tuple[str, ...], fault: str
) -> None:
    build(site, "1.0", "--alias", "latest")
    capsys.readouterr()
    assert main(["build", str(site), *words]) == 1
    assert capsys.readouterr().err.splitlines()[0] == fault
    assert listed(site) == [("1.0", "latest")]


@pytest.mark.parametrize("text", ["", "{}", "[]", '[{"version": "../up", "aliases": []}]', "[7]"])
def test_a_list_of_versions_that_is_wrong(
    site: Path, capsys: pytest.CaptureFixture[str], text: str
) -> None:
    build(site, "1.0")
    (site / "dist/versions.json").write_text(text)
    assert main(["build", str(site), "--version", "1.1"]) == 1
    line = f"{site}/dist/versions.json: not a valid list of versions; correct or delete it"
    assert capsys.readouterr().err.splitlines()[0] == line


NAMES = "write it like 1.2 or latest, with letters, digits, '.', '-', '_' and '+'"


@pytest.mark.parametrize("command", ["build", "deploy"])
@pytest.mark.parametrize(
    ("words", "fault"),
    [
        (("--version", "1/2"), f"argument --version: '1/2' is not a valid name; {NAMES}"),
        (("--version", ".."), f"argument --version: '..' is not a valid name; {NAMES}"),
        (("--version", ""), f"argument --version: '' is not a valid name; {NAMES}"),
        (("--version", "sw.js"), f"argument --version: 'sw.js' is not a valid name; {NAMES}"),
        (("--version", "1", "--alias", "ü"), f"argument --alias: 'ü' is not a valid name; {NAMES}"),
        (("--version", "1", "--alias", "1"), "argument --alias: '1' is the version itself"),
        (("--alias", "latest"), "argument --alias: needs --version NAME"),
    ],
)
def test_a_command_line_that_is_wrong(
    capsys: pytest.CaptureFixture[str], command: str, words: tuple[str, ...], fault: str
) -> None:
    with pytest.raises(SystemExit) as ended:
        main([command, *words])
    assert ended.value.code == 2
    assert capsys.readouterr().err.splitlines()[-1] == f"sitegen {command}: {fault}"


def test_a_single_file_has_no_versions(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["build", "--single-file", "/", "--version", "1"])
    assert "argument --version: a single file has no versions" in capsys.readouterr().err
