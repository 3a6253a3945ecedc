"""What others see of a page: previews, sitemap, feed, languages, tags, and when it changed."""

from __future__ import annotations

import io
import os
import re
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PIL import Image

from sitegen.config import load
from sitegen.model import Artifact
from sitegen.site.pages import preview, render

URL = "https://example.org/robots/"
ATOM = "{http://www.w3.org/2005/Atom}"
MAP = "{http://www.sitemaps.org/schemas/sitemap/0.9}"
PAGES = {
    "index.md": "---\ntags: [start, C++]\n---\n# Home & more\n",
    "index.de.md": "---\ntags: [Anfang]\n---\n# Start\n\n!!! warning\n    x\n",
    "news.md": "---\ndate: 2026-11-20\ndescription: What is <new>\n---\n# News\n",
    "older.md": "---\ndate: 2025-01-02\ntags: [C++]\n---\n# Older\n",
}


def site(folder: Path, more: str = f"url: '{URL}', feed: true") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in PAGES.items():
        (folder / name).write_text(text, encoding="utf-8")
    rows = [
        "{path: /, file: index.md}",
        "{path: news/, file: news.md}",
        "{path: o/, file: older.md}",
    ]
    (folder / "site.yaml").write_text(
        f"site: {{title: Robots, languages: [de], {more}}}\npages: [{', '.join(rows)}]\n"
    )
    return folder / "site.yaml"


def built(file: Path) -> dict[str, bytes]:
    def content(artifact: Artifact) -> bytes:
        source = artifact.source
        return source if isinstance(source, bytes) else source.read_bytes()

    return {artifact.path: content(artifact) for artifact in render(load(file))}


def test_a_page_says_what_a_preview_shows(tmp_path: Path) -> None:
    files = built(site(tmp_path))
    head = files["news/index.html"].decode().split("</head>")[0]
    meta = dict(re.findall(r'<meta (?:property|name)="(.*?)" content="(.*?)">', head))
    assert meta["og:title"] == "News"
    assert meta["og:description"] == "What is &lt;new&gt;"
    assert meta["og:url"] == f"{URL}news/"
    assert meta["twitter:card"] == "summary_large_image"
    assert f'<link rel="canonical" href="{URL}news/">' in head
    with Image.open(io.BytesIO(files[meta["og:image"].removeprefix(URL)])) as picture:
        assert (picture.format, picture.size) == ("PNG", (1200, 630))


def test_pictures_differ_by_what_they_show_and_are_drawn_the_same(tmp_path: Path) -> None:
    first = {path: data for path, data in built(site(tmp_path)).items() if "preview" in path}
    assert len(first) == len(set(first.values())) >= 4
    preview._drawn.cache_clear()
    again = built(site(tmp_path))
    assert {path: again[path] for path in first} == first


@pytest.mark.parametrize("title", ["中文", "A" * 300, "word " * 100, "Größe Ωμέγα Привет"])
def test_any_title_can_be_drawn(title: str) -> None:
    assert preview._drawn(title, "Site", title, "#00ff00").startswith(b"\x89PNG")


def test_without_an_address_nothing_is_claimed(tmp_path: Path) -> None:
    files = built(site(tmp_path, "description: x"))
    assert not {"sitemap.xml", "robots.txt", "feed.xml"} & set(files)
    assert b"og:image" not in files["index.html"]
    assert b"canonical" not in files["index.html"]


def test_the_sitemap_has_every_page(tmp_path: Path) -> None:
    files = built(site(tmp_path))
    tree = ElementTree.fromstring(files["sitemap.xml"])
    found = {loc.text for loc in tree.iter(f"{MAP}loc")}
    pages = {URL + path.removesuffix("index.html") for path in files if path.endswith("index.html")}
    assert found == pages
    assert f"{URL}de/" in found
    assert f"Sitemap: {URL}sitemap.xml" in files["robots.txt"].decode()


def test_the_feed_has_the_pages_with_a_date(tmp_path: Path) -> None:
    files = built(site(tmp_path))
    tree = ElementTree.fromstring(files["feed.xml"])
    entries = [
        (entry.findtext(f"{ATOM}title"), entry.findtext(f"{ATOM}updated"))
        for entry in tree.iter(f"{ATOM}entry")
    ]
    assert entries == [("News", "2026-11-20T00:00:00Z"), ("Older", "2025-01-02T00:00:00Z")]
    assert tree.findtext(f"{ATOM}entry/{ATOM}summary") == "What is <new>"
    assert b'type="application/atom+xml" title="Robots" href="../feed.xml"' in files["o/index.html"]


def test_pages_lead_to_their_translations(tmp_path: Path) -> None:
    files = built(site(tmp_path))
    home, german = (files[f"{path}index.html"].decode() for path in ("", "de/"))
    assert '<html lang="en">' in home
    assert '<html lang="de">' in german
    for page in (home, german):
        assert f'<link rel="alternate" hreflang="en" href="{URL}">' in page
        assert f'<link rel="alternate" hreflang="de" href="{URL}de/">' in page
    assert re.search(r'<a href="de/" lang="de"', home)
    assert re.search(r'<a href="../" lang="en"', german)
    assert "Zum Inhalt springen" in german
    assert '<p class="admonition-title">Warnung</p>' in german
    # What is not translated is named in its own language, and leads there.
    menu = german[german.index('<nav class="menu"') : german.index("<main")]
    assert re.findall(r'<a href="(.*?)".*?>(.*?)</a>', menu) == [
        ("./", "Start"),
        ("../news/", "News"),
        ("../o/", "Older"),
    ]
    assert "hreflang" not in files["news/index.html"].decode()


def test_tags_have_pages(tmp_path: Path) -> None:
    files = built(site(tmp_path))
    tags = {path for path in files if "tags/" in path and path.endswith("index.html")}
    assert tags == {
        *("tags/index.html", "tags/start/index.html", "tags/cpp/index.html"),
        *("de/tags/index.html", "de/tags/anfang/index.html"),
    }
    page = files["tags/cpp/index.html"].decode()
    body = page[page.index("<main") : page.index("</main>")]
    assert re.findall(r'<a href="([^#"]*)">(.*?)</a>', body) == [
        ("../../", "Home &amp; more"),
        ("../../o/", "Older"),
    ]
    assert '<a href="tags/cpp/">C++</a>' in files["index.html"].decode()
    assert "Seiten über Anfang" in files["de/tags/anfang/index.html"].decode()


def git(folder: Path, *words: str, day: str = "2026-01-01") -> None:
    when = f"{day}T12:00:00+0000"
    who = {
        f"GIT_{role}_{what}": "x" for role in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")
    }
    more = {
        **who,
        "GIT_AUTHOR_DATE": when,
        "GIT_COMMITTER_DATE": when,
        "GIT_CONFIG_GLOBAL": os.devnull,
    }
    subprocess.run(["git", "-C", folder, *words], check=True, env={**os.environ, **more})


def changed(file: Path) -> dict[str, str]:
    days = {}
    for path, data in built(file).items():
        found = re.search(r'Last updated: <time datetime="(.*?)">', data.decode(errors="replace"))
        if found:
            days[path] = found[1]
    return days


def test_the_last_change_is_that_of_git(tmp_path: Path) -> None:
    file = site(tmp_path / "repository/docs")
    assert changed(file) == {}
    git(tmp_path / "repository", "init", "-q")
    git(tmp_path / "repository", "add", ".")
    git(tmp_path / "repository", "commit", "-qm", "first", day="2026-02-03")
    file.with_name("news.md").write_text("# News\n\nMore.\n")
    git(tmp_path / "repository", "commit", "-qam", "second", day="2026-04-05")
    days = changed(file)
    assert (days["index.html"], days["news/index.html"]) == ("2026-02-03", "2026-04-05")
    assert b"<lastmod>2026-04-05</lastmod>" in built(file)["sitemap.xml"]
    clone = tmp_path / "clone"
    git(tmp_path, "clone", "-q", "--depth=1", (tmp_path / "repository").as_uri(), str(clone))
    assert changed(clone / "docs/site.yaml") == {}, "one commit for all tells nothing"


@pytest.mark.parametrize(
    ("repository", "address"),
    [
        ("https://github.com/me/robot", "https://github.com/me/robot/edit/main/docs/news.md"),
        ("https://gitlab.com/me/robot/", "https://gitlab.com/me/robot/-/edit/main/docs/news.md"),
        ("https://codeberg.org/me/robot", "https://codeberg.org/me/robot/_edit/main/docs/news.md"),
    ],
)
def test_a_page_can_be_edited_where_its_source_is(
    tmp_path: Path, repository: str, address: str
) -> None:
    (tmp_path / ".git").mkdir()
    file = site(tmp_path / "docs", f"repository: '{repository}'")
    page = built(file)["news/index.html"].decode()
    assert f'<a href="{address}">Edit this page</a>' in page
