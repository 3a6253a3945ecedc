"""The options of a node's next start: its parameters, remaps and arguments."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect

LINK = """async () => (await import(
  document.querySelector("script[type=module]").src)).ros.link()"""


@pytest.fixture
def url(serve: Serve, built: Built) -> Iterator[str]:
    yield serve(built(SITES / "terminal")) + "options/"


def test_a_node_starts_with_parameters_remaps_and_arguments(tab: Tab, url: str) -> None:
    tab.goto(url)
    talker = Panel(tab, "talker")
    talker.button("Options").click()
    panel = talker.panel
    for index, (name, value) in enumerate([("greeting", "good day"), ("volume", "9")]):
        panel.get_by_label("parameter").nth(index).fill(name)
        panel.get_by_label("value").nth(index).fill(value)
    panel.get_by_label("from").first.fill("__node")
    panel.get_by_label("to", exact=True).first.fill("other")
    command = "--ros-args -r __node:=other -p 'greeting:=good day' -p volume:=9"
    expect(panel.locator(".ros-command")).to_have_text(f"ros2 run speaking talker {command}")
    talker.start()
    talker.wait_for("good day")
    assert "[other]: good day" in talker.lines()[-1]
    # They go on to apply until they are reset.
    talker.button("Reset").click()
    expect(panel.locator(".ros-command")).to_have_text("ros2 run speaking talker")
    expect(panel.get_by_label("parameter")).to_have_count(1)
    talker.button("Start with these").click()
    talker.wait_for("[talker]: hello")


def test_arguments_are_words_of_a_shell(tab: Tab, url: str) -> None:
    tab.goto(url)
    typist = Panel(tab, "typist")
    typist.button("Options").click()
    field = typist.panel.get_by_label("Arguments")
    field.fill("one 'two")
    expect(typist.panel.get_by_text("close every quote")).to_be_visible()
    field.fill("one 'two  three' $HOME")
    typist.button("Start with these").click()
    typist.wait_for("argument $HOME")
    assert typist.lines()[:3] == ["argument one", "argument two  three", "argument $HOME"]


def test_options_travel_in_links_and_start_nothing_by_themselves(tab: Tab, url: str) -> None:
    tab.goto(url)
    talker = Panel(tab, "talker")
    talker.button("Options").click()
    talker.panel.get_by_label("parameter").first.fill("greeting")
    talker.panel.get_by_label("value").first.fill("linked")
    talker.start()
    talker.wait_for("linked")
    fragment = tab.evaluate(LINK)
    tab.goto("about:blank")
    tab.goto(url + fragment)
    # The visitor sees them, and is asked.
    expect(talker.panel.get_by_label("value").first).to_have_value("linked")
    talker.expect_state("stopped")
    tab.get_by_text("This link starts talker.").wait_for()
    tab.locator(".notice, [role=status]").get_by_role("button", name="Start").click()
    talker.wait_for("linked")


def test_odd_options_in_links_are_ignored(tab: Tab, url: str) -> None:
    tab.goto(url)
    for options in [
        {"parameters": "none"},
        {"parameters": [["a", 1]]},
        {"words": ["a"]},
        {"remaps": [["a", "b"]] * 51},
    ]:
        fragment = tab.evaluate(
            """(options) => {
              const state = { show: { "buttons-1": { options } } };
              return `#share=1.${btoa(JSON.stringify(state)).replace(/=+$/, "")}`;
            }""",
            options,
        )
        tab.goto("about:blank")
        tab.goto(url + fragment)
        tab.get_by_text("Parts of this link no longer match").wait_for()
        expect(Panel(tab, "talker").panel.get_by_label("parameter")).to_have_value("")
