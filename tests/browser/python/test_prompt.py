"""The Python prompt, as a visitor types at it."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Browser, Page, expect

pytestmark = pytest.mark.own_server
SITE = SITES / "prompt"


class Prompt:
    """A prompt that was started and is ready."""

    def __init__(self, page: Page) -> None:
        self.panel = page.get_by_role("region", name="shell", exact=True)
        self.panel.get_by_role("button", name="Start").click()
        self.line = self.panel.get_by_role("textbox")
        self.output = self.panel.get_by_role("log")
        expect(self.output).to_contain_text("rclpy is imported", timeout=60_000)

    def type(self, text: str) -> None:
        self.line.fill(text)
        self.line.press("Enter")

    def last(self, text: str) -> None:
        expect(self.output.locator("> div").last).to_have_text(text)


@pytest.fixture
def page(browser: Browser, serve: Serve, built: Built) -> Page:
    page = browser.new_page()
    page.goto(serve(built(SITE)))
    return page


@pytest.fixture
def prompt(page: Page) -> Prompt:
    return Prompt(page)


def test_it_runs_what_is_typed_on_the_graph_of_the_page(page: Page, prompt: Prompt) -> None:
    prompt.type("1 + 1")
    prompt.last("2")
    prompt.type('node = rclpy.create_node("web_node")')
    prompt.type("from std_msgs.msg import String")
    prompt.type('publisher = node.create_publisher(String, "chatter", 10)')
    expect(page.get_by_text("/chatter")).to_be_visible()
    prompt.type("from mine.words import GREETING; GREETING")
    prompt.last("'Hello'")
    prompt.type("1 / 0")
    prompt.last("ZeroDivisionError: division by zero")
    prompt.type("<b>markup</b>")
    prompt.last("SyntaxError: invalid syntax")


def test_blocks_go_on_until_they_are_complete(prompt: Prompt) -> None:
    prompt.type("for i in range(3):")
    expect(prompt.panel.locator(".ros-sign")).to_have_text("...")
    prompt.type("    last = i * 10")
    prompt.type("")
    prompt.type("last")
    prompt.last("20")
    prompt.line.fill("if last:")
    prompt.line.press("Shift+Enter")
    expect(prompt.panel.locator(".ros-sign")).to_have_text(">>>\n...", use_inner_text=True)
    prompt.line.press_sequentially("    print('yes')")
    prompt.line.press("Enter")
    prompt.last("yes")


def test_tab_completes_and_leaves_after_esc(prompt: Prompt) -> None:
    prompt.line.fill("rclpy.create_nod")
    prompt.line.press("Tab")
    expect(prompt.line).to_have_value("rclpy.create_node(")
    prompt.line.press("Escape")
    prompt.line.press("Tab")
    expect(prompt.line).not_to_be_focused()
    expect(prompt.line).to_have_value("rclpy.create_node(")


def test_what_was_typed_comes_back(prompt: Prompt) -> None:
    prompt.type("a = 1")
    prompt.type("b = 2")
    prompt.line.fill("draft")
    for key, text in [
        *[("ArrowUp", "b = 2"), ("ArrowUp", "a = 1"), ("ArrowUp", "a = 1")],
        *[("ArrowDown", "b = 2"), ("ArrowDown", "draft"), ("ArrowDown", "draft")],
    ]:
        prompt.line.press(key)
        expect(prompt.line).to_have_value(text)


def test_what_runs_may_ask(prompt: Prompt) -> None:
    prompt.type("name = input('name? ')")
    expect(prompt.output.locator("> div", has_text="name?").last).to_have_text("name? ")
    prompt.type("Ada")
    prompt.type("name * 2")
    prompt.last("'AdaAda'")


def test_tab_completes(prompt: Prompt) -> None:
    prompt.line.fill("rclpy.create_no")
    prompt.line.press("Tab")
    expect(prompt.line).to_have_value("rclpy.create_node(")
    prompt.line.fill("rclpy.spin")
    prompt.line.press("Tab")
    expect(prompt.output.locator("> div").last).to_contain_text("spin_once(")
    prompt.line.fill("")
    prompt.line.press("Tab")
    expect(prompt.line).not_to_be_focused()


def test_what_waits_can_be_interrupted_and_the_prompt_goes_on(prompt: Prompt) -> None:
    prompt.type("import time; time.sleep(1000)")
    prompt.type("'after'")
    prompt.panel.get_by_role("button", name="Interrupt").click()
    prompt.last("'after'")
    expect(prompt.output).to_contain_text("KeyboardInterrupt")
    expect(prompt.output).not_to_contain_text("rclpy_backend")
    prompt.line.fill("half of a li")
    prompt.line.press("Control+c")
    expect(prompt.line).to_have_value("")
    prompt.last("KeyboardInterrupt")
    prompt.type("rclpy.ok()")
    prompt.last("True")


def test_it_can_be_left_and_started_again(prompt: Prompt, page: Page) -> None:
    prompt.type("x = 1")
    prompt.type("exit()")
    expect(prompt.line).to_be_disabled()
    again = Prompt(page)
    again.type("'x' in globals()")
    again.last("False")
    again.type("while True: pass")
    again.panel.get_by_role("button", name="Stop").click()
    expect(again.panel.get_by_role("button", name="Start")).to_be_enabled()
