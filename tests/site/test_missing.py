"""The page for addresses where nothing is."""

from __future__ import annotations

import urllib.error
import urllib.request
from pathlib import Path

import pytest
from browser import Serve
from playwright.sync_api import Browser, expect

from sitegen.commands.build import build
from sitegen.commands.serve.live import LiveSite
from sitegen.commands.serve.server import Server
from sitegen.report import Report

SITE = """\
site:
  title: My robot
  url: https://me.github.io/my-robot/
  footer: "[manual](manual.pdf)"
pages:
  - {path: /, title: Home, content: [{markdown: Welcome}]}
  - {path: guide/start/, title: Start, content: [{markdown: Begin}]}
"""


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "site.yaml").write_text(SITE)
    (tmp_path / "manual.pdf").write_bytes(b"%PDF")
    return tmp_path


@pytest.mark.parametrize("where", ["nothing", "guide/start/nothing/at/all/"])
def test_it_looks_and_leads_as_the_site_does_at_any_depth(
    site: Path, browser: Browser, serve: Serve, where: str
) -> None:
    build(site, output=site / "dist", report=Report())
    url = serve(site / "dist", "/my-robot/")
    tab = browser.new_page()
    failed: list[str] = []
    tab.on("requestfailed", lambda request: failed.append(request.url))
    tab.on(
        "response", lambda response: failed.append(response.url) if response.status > 400 else None
    )
    assert (answer := tab.goto(url + where)) and answer.status == 404
    expect(tab.get_by_role("heading", name="Page not found")).to_be_visible()
    expect(tab.locator("header.site")).to_have_css("position", "sticky")
    assert failed == [url + where]
    tab.get_by_role("button", name="Search").click()
    tab.get_by_role("searchbox").fill("begin")
    expect(tab.locator("dialog.search li a")).to_have_attribute("href", "/my-robot/guide/start/")
    tab.locator("dialog.search").get_by_role("button", name="Close").click()
    manual = tab.get_by_role("link", name="manual").get_attribute("href")
    assert tab.evaluate("async (path) => (await fetch(path)).status", manual) == 200
    tab.get_by_role("link", name="Go to the home page").click()
    tab.wait_for_url(url)
    tab.close()


def test_without_an_address_the_site_has_a_server_of_its_own(site: Path) -> None:
    text = (site / "site.yaml").read_text()
    (site / "site.yaml").write_text(text.replace("  url: https://me.github.io/my-robot/\n", ""))
    build(site, output=site / "dist", report=Report())
    page = (site / "dist/404.html").read_text()
    assert '<link rel="stylesheet" href="/theme/all-text.css">' in page
    assert 'href="/guide/start/"' in page


def test_it_is_nothing_that_others_should_find(site: Path) -> None:
    build(site, output=site / "dist", report=Report())
    assert "404" not in (site / "dist/sitemap.xml").read_text()
    assert "not found" not in (site / "dist/search.en.json").read_text()
    page = (site / "dist/404.html").read_text()
    assert 'rel="canonical"' not in page
    assert "og:image" not in page


def test_an_author_sees_it_too(site: Path) -> None:
    live = LiveSite(site, Report())
    live.rebuild()
    with Server(live, 0) as server:
        with pytest.raises(urllib.error.HTTPError) as missing:
            urllib.request.urlopen(f"{server.url}guide/nothing")
        assert "Page not found" in missing.value.read().decode()
        with urllib.request.urlopen(f"{server.url}my-robot/guide/start/") as page:
            assert page.url == f"{server.url}guide/start/"
