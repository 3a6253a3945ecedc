"""Pages whose names are in any script: their paths, and all that names these."""

from __future__ import annotations

import json
import re
import unicodedata
from pathlib import Path
from urllib.parse import quote

import pytest
from rendered import render_site

from sitegen.config import load
from sitegen.config.paths import path_fault, segment
from sitegen.model import Site
from sitegen.site.offline import worker

URL = "https://example.org/robots/"
# Two files with the same name to a reader, if the system keeps names as they are written.
DECOMPOSED = unicodedata.normalize("NFD", "über-uns")
NAMES = ("安装", DECOMPOSED, "c++", "C", "हिन्दी", "Ελληνικά Νέα")
PATHS = {
    "docs/安装/",
    "docs/über-uns/",
    "docs/c++/",
    "docs/c/",
    "docs/हिन्दी/",
    "docs/ελληνικά-νέα/",
}


@pytest.fixture
def site(tmp_path: Path) -> Site:
    (tmp_path / "docs").mkdir()
    for name in NAMES:
        (tmp_path / "docs" / f"{name}.md").write_text(f"# {name}\n\n## 零\n", encoding="utf-8")
    (tmp_path / "docs/安装.md").write_text(
        "# 安装\n\n[on](c++.md) [one](../docs/安装.md) [two](/docs/über-uns/) [three](C.md)\n",
        encoding="utf-8",
    )
    (tmp_path / "site.yaml").write_text(
        f"site: {{title: Names, url: '{URL}', offline: true}}\n"
        "pages:\n  - {path: /, title: Home, content: [markdown: '[first](/docs/安装/)']}\n"
        "  - {path: docs/, folder: docs}\n",
        encoding="utf-8",
    )
    return load(tmp_path / "site.yaml")


def test_each_page_has_a_path_of_its_own(site: Site) -> None:
    assert {page.path for page in site.pages} == {"", *PATHS}


def test_links_between_the_pages(site: Site) -> None:
    made = {artifact.path: artifact.source for artifact in render_site(site)}
    pages = {
        path: text.decode("utf-8", "replace")
        for path, text in made.items()
        if isinstance(text, bytes)
    }
    assert f'<a href="{quote("docs/安装/")}">first</a>' in pages["index.html"]
    text = pages["docs/安装/index.html"]
    assert '<a href="../../docs/c%2B%2B/">on</a> <a href="./">one</a>' in text
    assert f'<a href="../../docs/{quote("über-uns/")}">two</a>' in text
    assert f'<link rel="canonical" href="{URL}{quote("docs/安装/")}">' in text
    assert f'content="{URL}{quote("docs/安装/")}"' in text
    wanted = {URL + quote(path) for path in PATHS}
    assert set(re.findall("<loc>(.*?)</loc>", pages["sitemap.xml"])) == {URL, *wanted}
    stored = json.loads(pages["search.en.json"])["storedFields"].values()
    assert {entry["href"].partition("#")[0] for entry in stored} == {"", *PATHS}


def test_the_service_worker_knows_the_pages(site: Site) -> None:
    (script,) = (one.source for one in worker.artifacts(site, render_site(site)))
    assert isinstance(script, bytes)
    build = json.JSONDecoder().raw_decode(script.decode().removeprefix("const BUILD = "))[0]
    assert set(build["files"]) >= PATHS


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("Straße 7", "straße-7"),
        ("İstanbul", unicodedata.normalize("NFC", "i\u0307stanbul")),
        ("a/b?c#d", "a-b-c-d"),
        ("100 % 🤖", "100-"),
        ("..hidden", "hidden"),
        ("ไทย_ภาษา", "ไทย_ภาษา"),
        ("zero\u200bwidth\u202e", "zero-width-"),
    ],
)
def test_a_name_becomes_a_segment(name: str, expected: str) -> None:
    assert segment(name) == expected
    assert path_fault(f"{expected}/") == ""


@pytest.mark.parametrize("path", ["Über/", "a b/", "a/%61/", "a?/", "安\u3000装/", "a\u2028/"])
def test_other_characters_are_refused(path: str) -> None:
    assert path_fault(path).startswith(f"'{path}' may contain only lower-case letters")
