"""Links, images and files of a page: where they lead, and what is missing."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest
from author import Author, addresses, problems
from rendered import render_site

SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="30"/>'


@pytest.fixture
def author(tmp_path: Path) -> Author:
    return Author(tmp_path)


@pytest.mark.parametrize(("path", "up"), [("", ""), ("a/", "../"), ("a/b/", "../../")])
def test_links_are_relative_at_any_depth(author: Author, path: str, up: str) -> None:
    others = [other for other in ("", "a/", "a/b/", "c/") if other != path]
    for other in others:
        author.page(other, "Other")
    page = author.page(path, "[c](c/) [home](/)", author.widget("console", "talker"))
    (html,) = (
        artifact.source.decode()
        for artifact in render_site(author.site(url="https://me.github.io/robots/"))
        if artifact.path == f"{page.path}index.html" and isinstance(artifact.source, bytes)
    )
    found = addresses(html)
    assert f'<a href="{up}c/">c</a> <a href="{up or "./"}">home</a>' in html
    module = "runtime/workers/cpp/cppNode.js"
    for file in ("theme/all-live.css", "theme/favicon.svg", "runtime/rosMain.js", module):
        assert up + file in found
    absolute = f"https://me.github.io/robots/{path}"
    assert f'<link rel="canonical" href="{absolute}">' in html
    assert f'<meta property="og:url" content="{absolute}">' in html
    elsewhere = [link for link in found if ":" in link or link.startswith("/")]
    assert sorted(set(elsewhere)) == ["http://localhost:8000/", absolute]


def test_links_to_a_page_by_its_source(author: Author) -> None:
    for number in ("1", "2"):
        (author.root / number).mkdir()
        (author.root / number / "page.md").touch()
    author.page("one/", author.text("[next](../2/page.md#setup)", "1/page.md"))
    text = "[back](../one/) [mail](mailto:a@b.c) [here](#setup)\n\n## Setup"
    author.page("two/", author.text(text, "2/page.md"))
    built = author.built()
    assert '<a href="../two/#setup">next</a>' in built["one/index.html"]
    assert '<a href="../one/">back</a>' in built["two/index.html"]
    assert '<a href="#setup">here</a>' in built["two/index.html"]


def test_images_get_a_name_for_good_and_a_size(author: Author) -> None:
    (author.root / "text/img").mkdir(parents=True)
    (author.root / "text/img/a b.svg").write_text(SVG)
    digest = hashlib.sha256(SVG.encode()).hexdigest()[:10]
    source = '![x](img/a%20b.svg)\n\n<img alt="a > b" src="img/a b.svg" width="20">'
    author.page("demo/", author.text(source, "text/page.md"))
    artifacts = {artifact.path: artifact.source for artifact in render_site(author.site())}
    name = f"media/a-b.{digest}.svg"
    assert artifacts[name] == author.root / "text/img/a b.svg"
    html = artifacts["demo/index.html"]
    assert isinstance(html, bytes)
    lazy = 'loading="lazy" decoding="async"'
    assert f'<img alt="x" src="../{name}" width="40" height="30" {lazy}>' in html.decode()
    assert f'<img alt="a > b" src="../{name}" width="20" height="15" {lazy}>' in html.decode()
    # Other content has another name, so browsers may keep this one for ever.
    (author.root / "text/img/a b.svg").write_text(SVG + " ")
    assert name not in {artifact.path for artifact in render_site(author.site())}


def test_files_that_a_page_links_to_are_copied_beside_it(author: Author) -> None:
    (author.root / "notes.pdf").write_bytes(b"2")
    author.page("demo/", author.text("[pdf](../notes.pdf)", "text/page.md"))
    artifacts = {artifact.path: artifact.source for artifact in render_site(author.site())}
    assert artifacts["demo/notes.pdf"] == author.root / "notes.pdf"
    html = artifacts["demo/index.html"]
    assert isinstance(html, bytes)
    assert b'href="notes.pdf"' in html


def test_what_is_missing_is_named_with_its_line(author: Author) -> None:
    (author.root / "robot.png").touch()
    author.page("demo/")
    author.page(
        "",
        author.text(
            "First\n\n![x](robto.png)\n\n[d](demos/)\n\n![y](../y.png)\n![z](https://z.org/z.png)",
            "page.md",
            line=10,
        ),
    )
    assert problems(author) == [
        "page.md:12: image: no file 'robto.png' in .; did you mean 'robot.png'?",
        "page.md:14: link: no page 'demos/'; did you mean 'demo/'?",
        "page.md:16: image: '../y.png' is outside the site's folder; "
        "move it below the folder of site.yaml",
        "page.md:17: image: 'https://z.org/z.png' is on another site; copy the file into this site",
    ]


def test_two_files_of_one_name_are_a_problem(author: Author) -> None:
    (author.root / "sub").mkdir()
    for file in ("a.png", "sub/a.png"):
        (author.root / file).touch()
    author.page("", author.text("[a](a.png)\n\n[b](../a.png)", "sub/page.md"))
    assert problems(author) == [
        "sub/page.md:3: link: '../a.png' would replace another 'a.png'; rename it"
    ]
