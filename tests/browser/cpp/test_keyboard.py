"""What visitors type in the console of a program that reads a keyboard."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import BrowserContext, Page, expect

pytestmark = pytest.mark.firefox

SITE = SITES / "keyboard"
UP = "\x1b[A"


KEYS = ["i", "é", "ArrowUp", "Enter", "Backspace", "Control+d", "q"]
TYPED = [[105], [195, 169], [27, 91, 65], [10], [127], [4], [113]]


class Typist:
    """Who types in the console of a node."""

    def __init__(self, page: Page, node: str) -> None:
        self.panel = Panel(page, node)
        self.keyboard = self.panel.panel.get_by_role("textbox")

    def answer(self, question: str, text: str) -> None:
        self.panel.wait_for(question)
        self.keyboard.press_sequentially(text)
        self.keyboard.press("Enter")

    def press(self, key: str) -> None:
        lines = self.panel.console.locator("> div", has_text=" key ")
        count = lines.count()
        self.keyboard.press_sequentially(key) if len(key) == 1 else self.keyboard.press(key)
        expect(lines).to_have_count(count + 1)


@pytest.fixture(params=["compiled", "interpreted"])
def typist(
    context: BrowserContext, serve: Serve, built: Built, request: pytest.FixtureRequest
) -> Typist:
    if request.param == "interpreted" and request.getfixturevalue("engine") == "asyncify":
        pytest.skip("Python needs JSPI")
    page = context.new_page()
    page.goto(serve(built(SITE)))
    return Typist(page, request.param)


def test_it_is_read_by_lines_unseen_and_key_by_key(typist: Typist) -> None:
    panel, keyboard = typist.panel, typist.keyboard
    expect(keyboard).to_be_hidden()
    panel.start()
    typist.answer("name?", "Ada <b>L</b>")
    panel.wait_for("meanwhile")
    expect(keyboard).to_have_attribute(
        "placeholder", f"Input for {panel.node}; press Enter to send the line"
    )
    typist.answer("number?", "21")
    panel.wait_for("twice 42")
    expect(keyboard).to_have_attribute("type", "password")
    typist.answer("twice", "hush")
    panel.wait_for("0 before any key")
    expect(keyboard).to_have_attribute("placeholder", f"{panel.node} reads each key pressed here")
    for key in KEYS:
        typist.press(key)
    expect(keyboard).to_have_value("")
    expect(keyboard).to_have_attribute(
        "placeholder", f"Input for {panel.node}; press Enter to send the line"
    )
    typist.answer("key 113", "one")
    panel.wait_for("line one")
    keyboard.press("Control+d")
    panel.expect_state("stopped")
    expect(keyboard).to_be_hidden()
    lines = [line.strip() for line in panel.lines()]
    assert [line for line in lines if line not in ("meanwhile", "secret?")] == [
        *("name?", "Ada <b>L</b>", "hello Ada <b>L</b>", "number?", "21", "twice 42"),
        *("a secret of 4", "0 before any key"),
        *(" ".join(["1 key", *map(str, bytes_)]) for bytes_ in TYPED),
        *(["-1 when nobody waits"] if panel.node == "compiled" else []),
        *("one", "line one", "the end"),
    ]


def test_control_c_interrupts_what_waits_for_it(typist: Typist) -> None:
    panel, keyboard = typist.panel, typist.keyboard
    panel.start()
    panel.wait_for("name?")
    keyboard.press("Control+c")
    if panel.node == "compiled":  # only its streams fail, as at a terminal
        panel.wait_for("hello")
        panel.stop()
    panel.expect_state("stopped")
    expect(keyboard).to_be_hidden()
