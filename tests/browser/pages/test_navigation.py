"""Finding one's way on a phone and on a desktop: the groups of the menu, contents, wide tables."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from playwright.sync_api import ViewportSize, expect

from sitegen.__main__ import main

PHONE: ViewportSize = {"width": 390, "height": 844}
DESKTOP: ViewportSize = {"width": 1440, "height": 900}
SITE = """\
site: {title: Fox, repository: "https://github.com/me/fox"}
pages:
  - {path: /, file: index.md}
  - {path: den/, file: den.md}
  - {path: hunt/, file: hunt.md}
nav:
  - Home: /
  - Dens: [den/]
  - Hunts: [hunt/]
"""
WIDE = f"""\
# Den

## Rooms

{"| a long name of a column " * 8}|
{"|---" * 8}|
{"| 1 " * 8}|

## Ways

```mermaid
flowchart LR
  one --> two --> three --> four --> five --> six --> seven --> eight
```
"""
# Whether it is wider than its box, and its box scrolls with a shade at the edge.
SCROLLS = """(box) => {
  const style = getComputedStyle(box);
  const wide = box.scrollWidth > box.clientWidth;
  return [wide, style.overflowX, style.backgroundAttachment, box.tabIndex];
}"""


@pytest.fixture
def url(tmp_path: Path, serve: Serve) -> str:
    files = {"site.yaml": SITE, "index.md": "# Fox\n", "den.md": WIDE, "hunt.md": "# Hunt\n"}
    for name, text in files.items():
        tmp_path.joinpath(name).write_text(text, encoding="utf-8")
    assert main(["build", str(tmp_path)]) == 0
    return serve(tmp_path / "dist", "/fox/")


def test_groups_of_the_menu_open_and_close_by_keyboard(tab: Tab, url: str) -> None:
    tab.set_viewport_size(DESKTOP)
    tab.goto(f"{url}den/")
    menu = tab.get_by_role("navigation", name="Pages")
    # That of the page is open, and none is a link.
    expect(menu.get_by_role("link")).to_have_text(["Home", "Den"])
    hunts = menu.locator("summary", has_text="Hunts")
    hunts.press("Enter")
    expect(menu.get_by_role("link")).to_have_text(["Home", "Den", "Hunt"])
    hunts.press("Enter")
    expect(menu.get_by_role("link")).to_have_text(["Home", "Den"])
    trail = tab.get_by_role("navigation", name="You are here")
    expect(trail).to_have_text("Dens")
    expect(trail.get_by_role("link")).to_have_count(0)


@pytest.mark.parametrize("path", ["guide/text/", "guide/nodes/"])
def test_a_phone_has_a_folded_table_of_contents(
    path: str, tab: Tab, built: Built, serve: Serve
) -> None:
    tab.set_viewport_size(PHONE)
    tab.goto(serve(built(SITES / "prose")) + path)
    contents = tab.get_by_role("navigation", name="On this page")
    expect(contents).to_be_hidden()
    tab.locator("summary", has_text="On this page").press("Enter")
    link = contents.get_by_role("link").last
    heading = link.get_attribute("href")
    link.press("Enter")
    expect(tab.locator(str(heading))).to_be_in_viewport()


def test_a_wide_screen_has_one_table_of_contents(tab: Tab, url: str) -> None:
    tab.set_viewport_size(DESKTOP)
    tab.goto(f"{url}den/")
    expect(tab.get_by_role("navigation", name="On this page")).to_have_count(1)
    expect(tab.locator(".contents")).to_be_hidden()


@pytest.mark.parametrize("size", [PHONE, DESKTOP], ids=["phone", "desktop"])
def test_every_page_leads_to_the_repository(size: ViewportSize, tab: Tab, url: str) -> None:
    tab.set_viewport_size(size)
    tab.goto(f"{url}den/")
    link = tab.get_by_role("contentinfo").get_by_role("link", name="Source code")
    expect(link).to_have_attribute("href", "https://github.com/me/fox")
    expect(tab.locator(".site .repository")).to_be_visible(visible=size is DESKTOP)


def test_what_is_wider_than_a_phone_says_so_and_scrolls(tab: Tab, url: str) -> None:
    tab.set_viewport_size(PHONE)
    tab.goto(f"{url}den/")
    table = tab.get_by_role("group", name="Rooms")
    diagram = tab.locator(".diagram[role=img]")
    expect(diagram).to_have_accessible_name(
        "one → two; two → three; three → four; four → five; five → six; six → seven; seven → eight"
    )
    for box in (table, diagram):
        wide, overflow, attachment, index = box.evaluate(SCROLLS)
        assert (wide, overflow, index) == (True, "auto", 0)
        assert attachment.split(", ")[:4] == ["local", "local", "scroll", "scroll"]
    table.press("ArrowRight")
    expect(table).not_to_have_js_property("scrollLeft", 0)
    assert tab.evaluate("document.documentElement.scrollWidth <= innerWidth")
