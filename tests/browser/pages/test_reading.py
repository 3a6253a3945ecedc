"""What the default theme offers readers: colours, copies, the table of contents, paper."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Browser, expect
from playwright.sync_api import Page as Tab

EVERYTHING = SITES / "prose"
# The paper of the page, as it is drawn.
PAPER = "getComputedStyle(document.body).backgroundColor"
LIGHT, DARK = "rgb(252, 252, 253)", "rgb(12, 15, 23)"


@pytest.fixture
def url(built: Built, serve: Serve) -> str:
    return serve(built(EVERYTHING))


def test_colours_are_as_the_device_or_as_chosen(tab: Tab, url: str) -> None:
    tab.emulate_media(color_scheme="dark")
    tab.goto(url)
    assert tab.evaluate(PAPER) == DARK
    button = tab.get_by_role("button", name="Colours")
    expect(button).to_have_accessible_name("Colours: system")
    button.press("Enter")
    expect(button).to_have_accessible_name("Colours: light")
    assert tab.evaluate(PAPER) == LIGHT
    tab.goto(f"{url}guide/text/")
    assert tab.evaluate(PAPER) == LIGHT, "the choice is kept"
    button.press("Enter")
    tab.emulate_media(color_scheme="light")
    assert tab.evaluate(PAPER) == DARK
    button.press("Enter")
    expect(button).to_have_accessible_name("Colours: system")
    assert tab.evaluate(PAPER) == LIGHT


def test_chosen_colours_are_there_before_anything_is_drawn(browser: Browser, url: str) -> None:
    context = browser.new_context(color_scheme="light")
    context.add_init_script("localStorage.setItem('colours', 'dark')")
    tab = context.new_page()
    # The modules of the page never come.
    tab.route("**/page.js", lambda route: route.abort())
    tab.goto(url)
    assert tab.evaluate(PAPER) == DARK
    context.close()


def test_without_scripts_nothing_is_offered_that_does_not_work(browser: Browser, url: str) -> None:
    context = browser.new_context(java_script_enabled=False)
    tab = context.new_page()
    tab.goto(f"{url}guide/text/")
    assert (
        tab.locator(".colours-button, .search-button, .copy, dialog")
        .locator("visible=true")
        .count()
        == 0
    )
    assert tab.get_by_role("link", name="Next").is_visible()
    assert tab.locator("main math").count() == 4
    assert tab.locator("main .diagram[role=img]").count() == 2
    context.close()


def test_code_is_copied_without_its_numbers(browser: Browser, url: str) -> None:
    context = browser.new_context(permissions=["clipboard-read", "clipboard-write"])
    tab = context.new_page()
    tab.goto(f"{url}guide/text/")
    tab.locator(".code").first.hover()
    tab.locator(".code .copy").first.click()
    expect(tab.locator(".code .copy").first).to_have_text("Copied")
    text = tab.evaluate("navigator.clipboard.readText()")
    assert text.startswith("// Says hello.\nRCLCPP_INFO(get_logger()")
    context.close()


def test_the_table_of_contents_follows_the_reader(tab: Tab, url: str) -> None:
    tab.set_viewport_size({"width": 1400, "height": 700})
    tab.goto(f"{url}guide/text/")
    links = tab.get_by_role("navigation", name="On this page").get_by_role("link")
    assert links.all_inner_texts()[:3] == ["Code", "Tabs", "Admonitions"]
    tab.get_by_role("link", name="Diagrams", exact=True).click()
    expect(tab.locator(".toc [data-current]")).to_have_text("Diagrams")


def test_the_menu_of_a_phone_opens_and_closes_by_keyboard(tab: Tab, url: str) -> None:
    tab.set_viewport_size({"width": 390, "height": 800})
    tab.goto(url)
    menu = tab.get_by_role("navigation", name="Pages")
    expect(menu).to_be_hidden()
    tab.get_by_role("button", name="Pages").press("Enter")
    expect(menu).to_be_visible()
    tab.keyboard.press("Escape")
    expect(menu).to_be_hidden()


def test_the_first_key_skips_to_the_content(tab: Tab, url: str) -> None:
    tab.goto(f"{url}guide/text/")
    tab.keyboard.press("Tab")
    expect(tab.get_by_role("link", name="Skip to content")).to_be_focused()
    tab.keyboard.press("Enter")
    assert tab.evaluate("document.activeElement.id") == "main"


def test_paper_has_the_text_alone(tab: Tab, url: str) -> None:
    tab.emulate_media(media="print", color_scheme="dark")
    tab.goto(f"{url}guide/text/")
    assert tab.evaluate(PAPER) == "rgb(255, 255, 255)"
    for gone in (".menu", ".toc", ".tools", ".around", ".skip"):
        expect(tab.locator(gone).first).to_be_hidden()
    # Nothing can be opened on paper.
    expect(tab.get_by_text("A node spins.")).to_be_visible()
    expect(tab.get_by_text("It was hidden.")).to_be_visible()


def test_nothing_moves_for_those_who_want_it_so(tab: Tab, url: str) -> None:
    tab.emulate_media(reduced_motion="reduce")
    tab.goto(f"{url}guide/nodes/")
    moving = "[...document.querySelectorAll('*')].filter((each) => {"
    moving += "const style = getComputedStyle(each);"
    moving += "return style.animationName !== 'none' || style.transitionDuration !== '0s';"
    assert tab.evaluate(f"{moving} }}).map((each) => each.className)") == []
