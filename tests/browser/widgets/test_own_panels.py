"""Panels that an author wrote, beside real C++ nodes: in a site and in a file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Serve, opened
from ownpanels import HEARD, SITE, write_site
from panel import Panel
from playwright.sync_api import Browser, expect
from playwright.sync_api import Page as Tab

from sitegen.__main__ import main
from sitegen.build import make, write
from sitegen.options import Options
from sitegen.report import Report

QUIET = "[data-ros-widget=own] .ros-wrong:not(:empty)"


@pytest.fixture
def site(tmp_path: Path) -> Path:
    folder = tmp_path / "site"
    write_site(folder)
    return folder


@pytest.fixture
def dist(site: Path, tmp_path: Path) -> Path:
    output = tmp_path / "dist"
    made = make(site, Report(), options=Options(draft=True, engines=("jspi",)))
    write(made.artifacts, output)
    return output


@pytest.fixture
def lenient(browser: Browser, serve: Serve) -> Iterator[Tab]:
    """A tab whose console may show errors."""
    context = browser.new_context()
    yield context.new_page()
    context.close()


def check_panels(tab: Tab) -> None:
    heard = tab.get_by_role("region", name="Heard")
    expect(heard.locator("li").nth(2)).to_contain_text("world!")
    assert heard.locator("li").count() == 3
    assert heard.locator("img").evaluate("(e) => e.decode().then(() => e.naturalWidth)") == 9
    expect(heard.locator("img")).to_have_attribute("alt", "a b")
    heard.get_by_role("button", name="Wide").click()
    expect(heard.locator("li").first).to_have_css("color", "rgb(1, 2, 3)")
    sums = tab.get_by_role("region", name="Sum")
    sums.get_by_role("button", name="Add").click()
    expect(sums.locator("output")).to_have_text("42")
    expect(tab.locator(QUIET)).to_have_count(0)


@pytest.mark.firefox
def test_panels_hear_nodes_and_call_them(tab: Tab, serve: Serve, dist: Path) -> None:
    url = serve(dist, "/mine/")
    tab.goto(url)
    Panel(tab, "server").expect_state("running")
    check_panels(tab)
    link = tab.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          return ros.link();
        }"""
    )
    tab.goto("about:blank")
    tab.goto(url + link)
    expect(tab.get_by_role("region", name="Heard").locator("ol")).to_have_class("wide")


@pytest.mark.firefox
def test_a_panel_works_in_a_single_file(browser: Browser, site: Path, tmp_path: Path) -> None:
    file = tmp_path / "one.html"
    assert main(["build", str(site), "--single-file", "/", "--output", str(file)]) == 0
    with opened(browser) as tab:
        tab.goto(file.as_uri())
        Panel(tab, "server").expect_state("running")
        check_panels(tab)


def test_an_error_stays_in_its_panel(
    site: Path, tmp_path: Path, lenient: Tab, serve: Serve
) -> None:
    broken = HEARD.replace("shorten(data)", "data.missing.here")
    (site / "panels/heard.js").write_text(broken)
    mounting = "export function mount() {\n  throw new RangeError('too far');\n}\n"
    (site / "panels/other.js").write_text(mounting)
    text = SITE + "      - panel: panels/other.js\n"
    (site / "site.yaml").write_text(text)
    made = make(site, Report(), options=Options(draft=True, engines=("jspi",)))
    write(made.artifacts, tmp_path / "dist")
    lenient.goto(serve(tmp_path / "dist"))
    Panel(lenient, "server").expect_state("running")
    heard = lenient.get_by_role("region", name="Heard").get_by_role("alert")
    expect(heard).to_contain_text("panels/heard.js:15: TypeError: ")
    other = lenient.get_by_role("region", name="Other").get_by_role("alert")
    expect(other).to_have_text("panels/other.js:2: RangeError: too far")
    sums = lenient.get_by_role("region", name="Sum")
    sums.get_by_role("button", name="Add").click()
    expect(sums.locator("output")).to_have_text("42")
    expect(sums.locator(".ros-wrong")).to_be_empty()
    # What a handler of an element throws belongs to the panel, too.
    sums.get_by_role("button", name="Break").click()
    expect(sums.get_by_role("alert")).to_contain_text("panels/sum.js:12: TypeError")
