"""Themes: what a template is given, what an own one takes over, and what sitegen brings."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import Built, Serve
from paths import ROOT
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from rendered import render_site

from sitegen.__main__ import main
from sitegen.commands.build import build
from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.report import Report
from sitegen.site.pages import render
from sitegen.site.pages.colours import contrast, shades
from sitegen.site.pages.theme import Theme

EVERYTHING = ROOT / "tests/sites/prose"
DOCUMENTED = ROOT.joinpath("docs/templates.md").read_text().split("# What a template is given")[1]
TABLE = re.findall(r"^\| (`.*?) \|", DOCUMENTED.split("\n## ")[0], flags=re.MULTILINE)
NAMES = {name for cell in TABLE for name in re.findall(r"`(\w+)`", cell)}


def site(folder: Path, theme: str = "mine", more: str = "") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "page.md").write_text("# Page\n\n## One\n\n## Two\n")
    pages = "pages: [{path: /, file: page.md}]\n"
    (folder / "site.yaml").write_text(f"site: {{title: T, theme: {theme}{more}}}\n{pages}")
    return folder / "site.yaml"


def html(file: Path) -> str:
    artifacts = {artifact.path: artifact.source for artifact in render(load(file))}
    source = artifacts["index.html"]
    assert isinstance(source, bytes)
    return source.decode()


def test_the_documentation_names_all_that_a_template_is_given(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    given: list[set[str]] = []

    def note(_: Theme, /, **names: Any) -> str:
        given.append(set(names))
        return ""

    monkeypatch.setattr(Theme, "html", note)
    render_site(load(EVERYTHING / "site.yaml"))
    assert given
    assert all(names == NAMES for names in given)


def test_a_template_can_use_all_of_it(tmp_path: Path) -> None:
    file = site(tmp_path)
    (tmp_path / "themes/mine").mkdir(parents=True)
    template = "".join(f"{{{{ {name} is defined }}}} {{{{ {name} }}}}\n" for name in sorted(NAMES))
    (tmp_path / "themes/mine/page.html").write_text(template)
    assert "False" not in re.findall(r"^(True|False)", html(file), flags=re.MULTILINE)


@pytest.mark.parametrize(
    ("template", "fault"),
    [
        ("\n{{ nonsense }}", "themes/mine: theme: 'nonsense' is undefined; see docs/templates.md"),
        ("\n{% if %}", "page.html:2: theme: Expected an expression, got 'end of statement block'"),
    ],
)
def test_what_is_wrong_with_a_template_is_said(tmp_path: Path, template: str, fault: str) -> None:
    file = site(tmp_path)
    (tmp_path / "themes/mine").mkdir(parents=True)
    (tmp_path / "themes/mine/page.html").write_text(template)
    with pytest.raises(SiteError) as wrong:
        html(file)
    assert fault in wrong.value.lines[0]


def test_a_theme_of_one_file_changes_that_file_only(tmp_path: Path) -> None:
    file = site(tmp_path)
    (tmp_path / "themes/mine").mkdir(parents=True)
    (tmp_path / "themes/mine/style.css").write_text(":root { --accent: red; }")
    artifacts = {artifact.path: artifact.source for artifact in render(load(file))}
    assert artifacts["theme/style.css"] == tmp_path / "themes/mine/style.css"
    assert artifacts["theme/text.css"] == ROOT / "themes/default/text.css"
    assert not any(path.endswith((".html", ".yaml")) for path in artifacts if "theme" in path)


def test_a_copy_of_a_theme_is_a_theme(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("default", "slides", "plain"):
        assert main(["theme", "copy", name, f"themes/my-{name}"]) == 0
        assert f"theme: my-{name}" in capsys.readouterr().out
        before = html(site(tmp_path, name))
        assert html(site(tmp_path, f"my-{name}")) == before
    assert main(["theme", "copy", "plain"]) == 0
    assert (tmp_path / "themes/plain/page.html").is_file()
    assert main(["theme", "copy", "plain"]) == 1
    assert main(["theme", "copy", "defualt", "new"]) == 1
    said = capsys.readouterr().err
    assert "themes/plain already exists; choose another folder" in said
    assert "no theme named 'defualt'; did you mean 'default'?" in said
    assert "nothing was copied" in said


def test_what_site_yaml_says_about_looks(tmp_path: Path) -> None:
    (tmp_path / "own.woff2").write_bytes(b"font")
    more = ', accent: "#ffcc00", font: own.woff2, code_font: "Fira Code, monospace"'
    artifacts = {a.path: a.source for a in render(load(site(tmp_path, "default", more)))}
    style, page = artifacts["theme/site.css"], artifacts["index.html"]
    assert isinstance(style, bytes)
    assert isinstance(page, bytes)
    (font,) = (path for path in artifacts if path.endswith(".woff2"))
    assert f'url("../{font}")' in style.decode()
    assert "--font-code: Fira Code, monospace;" in style.decode()
    assert "font-src &#39;self&#39;" in page.decode()
    joined = artifacts["theme/all-text.css"]
    assert isinstance(joined, bytes)
    assert joined.endswith(style), "it comes last"
    assert page.decode().count('rel="stylesheet"') == 1


def test_lines_end_between_the_words_of_long_names(tmp_path: Path) -> None:
    file = site(tmp_path, "default")
    file.write_text(file.read_text().replace("file: page.md", "title: my_<b>big_robot, file: a.md"))
    (tmp_path / "a.md").write_text("Text.\n")
    text = html(file)
    assert "<h1>my_&lt;b&gt;big_<wbr>robot</h1>" in text
    assert "<title>my_&lt;b&gt;big_robot" in text


def test_visitors_load_style_sheets_without_comments(tmp_path: Path) -> None:
    theme = tmp_path / "themes/mine"
    theme.mkdir(parents=True)
    (theme / "text.css").write_text(
        "/* why\n   so */\na { color: red; /* x */ margin: 1px/**/2px }\n"
        """b::after { content: "/* \\" '*/"; background: url(data:,/*) }\n"""
        "/*! (c) me */ i { top: 0 } /* end */\n"
    )
    artifacts = {a.path: a.source for a in render(load(site(tmp_path)))}
    joined = artifacts["theme/all-text.css"]
    assert isinstance(joined, bytes)
    kept = (
        "a { color: red; margin: 1px 2px }\n"
        """b::after { content: "/* \\" '*/"; background: url(data:,/*) }\n"""
        "/*! (c) me */ i { top: 0 }"
    )
    assert kept in joined.decode()
    assert "/* " not in joined.decode().replace(kept, "")


def test_the_footer_is_markdown_whose_links_are_checked(tmp_path: Path) -> None:
    assert '<a href="#one">down</a>' in html(site(tmp_path, "default", ', footer: "[down](#one)"'))
    with pytest.raises(SiteError) as wrong:
        html(site(tmp_path, "default", ', footer: "[a](gone.md) [b](#twoo)"'))
    assert wrong.value.lines == [
        "site.yaml:1: link: no file 'gone.md' in .; did you mean 'page.md'?",
        "site.yaml:1: link: no heading '#twoo' in this page; did you mean 'two'?",
    ]


@pytest.mark.parametrize("colour", ["#ffcc00", "#000000", "#ffffff", "#2b4bd8", "#00ff00"])
def test_an_accent_can_be_read_on_light_and_on_dark(colour: str) -> None:
    light, dark = shades(colour)
    assert contrast(light, "#ffffff") >= 4.5
    assert contrast(dark, "#0c0f17") >= 4.5


def test_contrast_is_that_of_wcag() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)


@pytest.fixture
def deck(built: Built, serve: Serve, tab: Tab) -> Iterator[Tab]:
    """The slides of the site with everything."""
    tab.goto(f"{serve(built(EVERYTHING))}slides/")
    yield tab


def number(tab: Tab) -> str:
    return tab.inner_text(".deck .number")


def shown(tab: Tab) -> str:
    return str(tab.evaluate("document.querySelector('main').innerText")).strip().split("\n")[0]


def test_slides_are_turned_by_keys_buttons_and_addresses(deck: Tab) -> None:
    assert (number(deck), shown(deck)) == ("1 / 4", "A lecture")
    deck.keyboard.press("ArrowRight")
    assert (number(deck), shown(deck)) == ("2 / 4", "Two nodes")
    deck.keyboard.press("End")
    assert (number(deck), shown(deck)) == ("4 / 4", "Formulas")
    deck.get_by_role("button", name="Previous").click()
    assert shown(deck) == "Live"
    deck.reload()
    assert (number(deck), shown(deck)) == ("3 / 4", "Live")
    deck.keyboard.press("Home")
    assert shown(deck) == "A lecture"
    deck.get_by_role("button", name="All slides").click()
    assert deck.locator(".slide:visible").count() == 4


def test_what_runs_on_a_slide_goes_on(deck: Tab) -> None:
    deck.keyboard.press("End")
    deck.keyboard.press("ArrowLeft")
    deck.get_by_role("button", name="Start").click()
    expect(deck.get_by_role("log")).to_contain_text("Hello, world! 0")
    deck.locator("body").press("ArrowRight")
    assert shown(deck) == "Formulas"
    deck.get_by_role("button", name="Previous").click()
    expect(deck.get_by_role("log")).to_contain_text("Hello, world! 3")
    # Keys of a button are the button's.
    deck.get_by_role("button", name="Stop").press(" ")
    assert shown(deck) == "Live"


def test_slides_are_printed_one_a_sheet(deck: Tab, tmp_path: Path) -> None:
    pdf = deck.pdf(prefer_css_page_size=True)
    assert len(re.findall(rb"/Type\s*/Page\b", pdf)) == 4


def test_a_plain_page_stands_in_a_frame(tmp_path: Path, tab: Tab, serve: Serve) -> None:
    (tmp_path / "inner.md").write_text("---\ntheme: plain\n---\n# Inner\n\nText\n")
    (tmp_path / "outer.md").write_text('# Outer\n\n<iframe src="inner.md" title="I"></iframe>\n')
    pages = "pages: [{path: /, file: outer.md}, {path: inner/, file: inner.md}]\n"
    (tmp_path / "site.yaml").write_text(f"site: {{title: T}}\n{pages}")
    build(tmp_path, output=tmp_path / "dist", report=Report())
    tab.goto(serve(tmp_path / "dist"))
    frame = tab.frame_locator("iframe")
    expect(frame.get_by_role("heading", name="Inner")).to_be_visible()
    assert frame.locator("header, nav").count() == 0
