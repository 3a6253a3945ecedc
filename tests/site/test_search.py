"""The search: its index is written at build, and it works by keyboard."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from browser import Built, Serve
from paths import ROOT
from playwright.sync_api import Browser, Route, expect
from playwright.sync_api import Page as Tab
from waiting import until

from sitegen.commands.build import build
from sitegen.report import Report

GUIDE = """\
# Guide

How to *build* a robot.

## Install

Install the `rclcpp` package, then call `create_publisher`.

## Große Fahrt

Motors & wheels, 3 < 4.

```cpp
rclcpp::spin(node);
```
"""


@pytest.fixture
def site(tmp_path: Path) -> Path:
    pages = {"index.md": "# Home\n\nWelcome.\n", "guide.md": GUIDE}
    pages["index.de.md"] = "# Start\n\nWillkommen beim Roboter.\n"
    for name, text in pages.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    (tmp_path / "site.yaml").write_text(
        "site: {title: T, languages: [de]}\npages:\n"
        "  - {path: /, file: index.md}\n  - {path: a/guide/, file: guide.md}\n"
    )
    build(tmp_path, output=tmp_path / "dist", report=Report())
    return tmp_path / "dist"


@pytest.fixture
def tab_at_home(tab: Tab, site: Path, serve: Serve) -> Tab:
    tab.goto(serve(site, "/me/robots/"))
    return tab


def found(tab: Tab, query: str) -> list[str]:
    """Type a query and return the titles found, when the count is there."""
    tab.get_by_role("searchbox").fill(query)
    # The old count goes before the new one comes, so an empty field is waited for first.
    expect(tab.get_by_role("status")).to_have_text(re.compile(r"result|Nothing"))
    return tab.locator("dialog li b").all_inner_texts()


@pytest.mark.parametrize(
    ("query", "titles"),
    [
        ("install", ["Install"]),
        ("publis", ["Install"]),  # unfinished, and a part of a name
        ("instal rclcpp", ["Install"]),
        ("robbot", ["Guide"]),  # with a mistake
        ("große", ["Große Fahrt"]),
        ("guide", ["Guide"]),
        ("spin node", ["Große Fahrt"]),
        ("willkommen", []),  # is in the other language
        ("nonsense", []),
    ],
)
def test_what_is_found(tab_at_home: Tab, query: str, titles: list[str]) -> None:
    tab_at_home.keyboard.press("Control+k")
    assert found(tab_at_home, query) == titles


def test_it_works_by_keyboard(tab_at_home: Tab) -> None:
    tab = tab_at_home
    tab.keyboard.press("/")
    found(tab, "r")
    links = tab.locator("dialog li a")
    assert links.count() == 3
    tab.keyboard.press("ArrowDown")
    tab.keyboard.press("ArrowDown")
    expect(links.nth(1)).to_be_focused()
    tab.keyboard.press("ArrowUp")
    tab.keyboard.press("ArrowUp")
    expect(tab.get_by_role("searchbox")).to_be_focused()
    found(tab, "wheels")
    tab.keyboard.press("Enter")
    tab.wait_for_url("**/me/robots/a/guide/#gro%C3%9Fe-fahrt")
    tab.keyboard.press("Control+k")
    expect(tab.locator("dialog")).to_be_visible()
    tab.keyboard.press("Escape")
    expect(tab.locator("dialog")).to_be_hidden()


def test_what_is_typed_at_once_is_the_query(tab: Tab, site: Path, serve: Serve) -> None:
    late: list[Route] = []
    for part in ("**/search.js", "**/search.en.json"):
        tab.route(part, lambda route: late.append(route))
    tab.goto(serve(site))
    tab.keyboard.press("/")
    tab.keyboard.type("wheels")
    tab.keyboard.press("Enter")
    expect(tab.get_by_role("searchbox")).to_have_value("wheels")
    until(lambda: tab.evaluate("1") and late)
    late.pop().continue_()
    until(lambda: tab.evaluate("1") and late)
    expect(tab.locator("dialog")).to_be_visible()
    late.pop().continue_()
    tab.wait_for_url("**/a/guide/#gro%C3%9Fe-fahrt")


@pytest.mark.parametrize("part", ["search.js", "search.en.json"])
def test_a_search_that_cannot_be_loaded_says_so(
    part: str, browser: Browser, site: Path, serve: Serve
) -> None:
    tab = browser.new_page()
    tab.route(f"**/{part}", lambda route: route.abort())
    tab.goto(serve(site))
    tab.keyboard.press("/")
    expect(tab.get_by_role("status")).to_have_text("The search could not be loaded")
    expect(tab.locator("dialog")).to_have_css("opacity", "1")
    tab.close()


def test_an_index_is_asked_for_again(browser: Browser, site: Path, serve: Serve) -> None:
    tab = browser.new_page()
    tab.route("**/search.en.json", lambda route: route.abort())
    tab.goto(serve(site))
    tab.keyboard.press("/")
    expect(tab.get_by_role("status")).to_have_text("The search could not be loaded")
    tab.unroute("**/search.en.json")
    tab.keyboard.press("Escape")
    expect(tab.locator("dialog")).to_be_hidden()
    # A slash would be typed into the field if it still had the focus.
    tab.keyboard.press("Control+k")
    expect(tab.locator("dialog li")).to_have_count(2)
    expect(tab.locator("dialog .count")).to_be_empty()
    tab.close()


def test_enter_takes_the_result_of_all_that_was_typed(tab_at_home: Tab) -> None:
    tab = tab_at_home
    tab.keyboard.press("Control+k")
    found(tab, "welcome")
    # All at once, as from a fast hand: the page has no time to search between the letters.
    tab.evaluate(
        """() => {
          const field = document.querySelector("dialog input");
          const options = { bubbles: true, cancelable: true };
          for (const text of ["in", "inst", "install"]) {
            field.value = text;
            field.dispatchEvent(new InputEvent("input", options));
          }
          field.dispatchEvent(new KeyboardEvent("keydown", { ...options, key: "Enter" }));
        }"""
    )
    tab.wait_for_url("**/a/guide/#install")


def test_what_pages_say_is_shown_as_text(tab_at_home: Tab) -> None:
    tab_at_home.keyboard.press("Control+k")
    found(tab_at_home, "motors")
    text = tab_at_home.locator("dialog li span").inner_text()
    assert text.startswith("Motors & wheels, 3 < 4.")
    assert tab_at_home.locator("dialog mark").all_inner_texts() == ["Motors"]


def test_nothing_of_it_is_loaded_before(tab: Tab, site: Path, serve: Serve) -> None:
    loaded: list[str] = []
    tab.on("request", lambda request: loaded.append(request.url.rpartition("/")[2]))
    tab.goto(serve(site))
    tab.wait_for_load_state("networkidle")
    parts = {"search.js", "search.css", "searchIndex.js", "search.en.json"}
    assert not parts & set(loaded)
    tab.get_by_role("button", name="Search").click()
    found(tab, "install")
    assert parts <= set(loaded)


def test_each_language_has_its_own(tab: Tab, site: Path, serve: Serve) -> None:
    tab.goto(f"{serve(site)}de/")
    tab.get_by_role("button", name="Suchen").click()
    tab.get_by_role("searchbox").fill("roboter")
    expect(tab.get_by_role("status")).to_have_text("1 Treffer")
    assert tab.locator("dialog li b").all_inner_texts() == ["Start"]


# What readers of this site's own pages ask for, and the page that must come first.
ASKED = {
    "publish a message": "docs/panels/",
    "edit code": "demo08/",
    "edit the code": "demo08/",
    "start a node": "demo02/",
    "dark mode": "docs/themes/",
    "tutorial": "docs/tutorial/",
    "turtle": "demo09/",
    "turtlesim": "demo09/",
    "python prompt": "demo07/",
    "python and c++": "demo06/",
    "robot dance": "demo04/",
    "a real robot": "demo04/",
    "launch file": "docs/launch/",
    "how do i use a launch file": "docs/launch/",
    "github pages": "docs/publish/",
    "publish on github": "docs/publish/",
    "share a link": "docs/sharing/",
    "embed a page": "docs/sharing/",
    "own theme": "docs/themes/",
    "colors of the theme": "docs/themes/",
    "tabs": "docs/layouts/",
    "columns": "docs/layouts/",
    "editor": "docs/widgets/",
    "console": "docs/widgets/",
    "parameters": "docs/node-panels/",
    "packages from pypi": "docs/python-packages/",
    "numpy": "docs/python-packages/",
    "isolated pages": "docs/python/",
    "sitegen serve": "docs/commands/",
    "which browsers": "docs/browsers/",
    "safari": "docs/browsers/",
    "navigation": "docs/writing/",
    "several languages": "docs/writing/",
    "mermaid diagram": "docs/writing/",
    "architecture": "docs/architecture/",
    "quality of service": "docs/what-runs/",
}


def test_what_readers_ask_for_comes_first(tab: Tab, built: Built, serve: Serve) -> None:
    tab.goto(serve(built(ROOT)))
    # With no query, the dialog lists the pages.
    tab.keyboard.press("Control+k")
    links = tab.locator("dialog li a")
    expect(links.nth(1)).to_contain_text("A node that says hello")
    first = tab.evaluate(
        """async (queries) => {
          const { engine, index } = document.querySelector("dialog.search").dataset;
          const { loadIndex } = await import(new URL(engine, location.href).href);
          const { search } = await loadIndex(new URL(index, location.href));
          return queries.map((query) => search(query)[0]?.href.replace(/#.*/, ""));
        }""",
        list(ASKED),
    )
    assert dict(zip(ASKED, first, strict=True)) == ASKED
