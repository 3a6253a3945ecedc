"""The editor, as a reader uses it."""

from __future__ import annotations

import io
import re
import shutil
from pathlib import Path

import pytest
from browser import Built, Serve
from panel import Panel
from paths import ROOT
from PIL import Image
from playwright.sync_api import Browser, Page, Route, expect

from sitegen.commands.build import build
from sitegen.errors import SiteError
from sitegen.report import Report

pytestmark = pytest.mark.own_server
DEMO = ROOT / "demos" / "demo08"


class Editor:
    """The editor of a page, and the node it is about."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.node = Panel(page, "counter", region="counter: Editor")
        self.code = page.get_by_role("textbox", name="Python source py_counter/counter.py")
        self.state = page.locator(".ros-edited")
        expect(self.code).to_be_visible()

    def replace(self, old: str, new: str) -> None:
        """Write `new` for the line `old`, with the keyboard."""
        self.code.get_by_text(old, exact=True).click()
        self.page.keyboard.press("End")
        self.page.keyboard.press("Shift+Home")
        self.page.keyboard.type(new)

    def run(self) -> None:
        self.page.get_by_role("button", name="Run").click()


@pytest.fixture
def editor(tab: Page, serve: Serve, built: Built) -> Editor:
    tab.goto(serve(built(DEMO)))
    return Editor(tab)


def test_the_header_of_the_page_is_above_the_ring_of_the_focus(editor: Editor) -> None:
    page = editor.page
    header = page.locator(".site").bounding_box()
    assert header
    editor.code.focus()
    page.keyboard.press("Control+Home")
    top = page.locator(".ros-code").bounding_box()
    assert top
    page.evaluate("(top) => scrollBy({ top, behavior: 'instant' })", top["y"] - 20)
    # The ring goes on behind the header, which lets little of it through.
    x, y = int(top["x"] + top["width"]) - 1, int(header["height"] / 2)
    clip = {"x": x - 10, "y": y, "width": 20, "height": 1}
    with Image.open(io.BytesIO(page.screenshot(clip=clip))) as picture:  # type: ignore[arg-type]
        # The page is light, and the ring is blue.
        reds = picture.getchannel("R").tobytes()
    assert max(reds) - min(reds) < 24


@pytest.mark.firefox
def test_what_is_changed_runs_and_stays_until_it_is_reset(editor: Editor) -> None:
    expect(editor.state).to_have_text("unchanged")
    editor.replace("STEP = 1", "STEP = 100")
    expect(editor.state).to_have_text("changed")
    editor.page.keyboard.press("Control+Enter")
    editor.node.wait_for("Now it is 200")
    assert "STEP = 100" in editor.code.inner_text().split("\n")
    # Esc, then Tab leaves; Tab alone indents.
    editor.code.focus()
    editor.page.keyboard.press("Escape")
    editor.page.keyboard.press("Tab")
    expect(editor.code).not_to_be_focused()

    editor.page.reload()
    expect(editor.state).to_have_text("changed")
    editor.run()
    editor.node.wait_for("Now it is 200")
    editor.page.get_by_role("button", name="Reset").click()
    expect(editor.state).to_have_text("unchanged")
    expect(editor.code).to_be_focused()
    editor.node.button("Clear").click()
    editor.run()
    editor.node.wait_for("Now it is 1")
    editor.node.stop()
    assert editor.page.evaluate("Object.keys(localStorage)") == []


def test_source_that_came_with_a_link_waits_for_its_reader(
    editor: Editor, browser: Browser
) -> None:
    page, address = editor.page, editor.page.url
    editor.replace("STEP = 1", "STEP = 1000")
    expect(editor.state).to_have_text("changed")
    editor.run()
    editor.node.wait_for("Now it is 1000")
    link = page.evaluate("""async () => {
      const { ros } = await import(document.querySelector("script[type=module][src*=rosMain]").src);
      return ros.link();
    }""")
    # Somebody else opens it.
    page = browser.new_context().new_page()
    page.goto(f"{address}{link}")
    editor = Editor(page)
    # The link says that the node runs; when its reader agrees, it runs as its author wrote it.
    expect(editor.state).to_have_text("changed by the link: read it before you run it")
    page.locator(".ros-word").get_by_role("button", name="Start").click()
    editor.node.wait_for("Now it is 2")
    assert page.evaluate("Object.keys(localStorage)") == []
    editor.node.button("Clear").click()
    editor.run()
    editor.node.wait_for("Now it is 1000")
    expect(editor.state).to_have_text("changed")


def test_one_button_runs_and_shows_what_is_loaded(editor: Editor) -> None:
    page = editor.page
    held: list[Route] = []
    buttons = editor.node.panel.get_by_role("group").get_by_role("button")
    expect(buttons).to_have_text(["Run", "Stop", "Reset"])
    page.route("**/python_stdlib.zip", lambda route: held.append(route))
    expect(editor.node.button("Stop")).to_be_disabled()
    with page.expect_request("**/python_stdlib.zip"):
        editor.run()
    bar = page.locator(".ros-editor")
    expect(bar.get_by_role("progressbar", name="Loading Python")).to_be_visible()
    expect(bar.locator(".ros-state")).to_contain_text("loading Python: ")
    held[0].continue_()
    editor.node.wait_for("Now it is 2")
    expect(bar.get_by_role("progressbar")).to_be_hidden()
    expect(buttons).to_have_text(["Run again", "Stop", "Reset"])
    editor.node.stop()
    expect(buttons).to_have_text(["Run", "Stop", "Reset"])
    expect(page.get_by_role("button", name="Start")).to_have_count(0)


def test_syntax_errors_are_marked_while_typing(editor: Editor) -> None:
    wrong = editor.page.locator(".cm-wrong")
    editor.replace("STEP = 1", "STEP = 1 +")
    expect(editor.state).to_have_text("syntax error in line 9")
    expect(wrong).to_have_text("STEP = 1 +")
    editor.page.keyboard.type(" int(1.)")
    expect(editor.state).to_have_text("changed")
    expect(wrong).to_have_count(0)
    # The interpreter of the running node knows what is wrong.
    editor.run()
    editor.node.wait_for("Now it is 2")
    editor.code.get_by_text("def main():", exact=True).click()
    editor.page.keyboard.press("Home")
    editor.page.keyboard.type("  ")
    expect(editor.state).to_have_text(re.compile("line 28: unindent does not match any outer"))
    expect(wrong).to_have_text("  def main():")
    # The node runs on as it was.
    editor.node.expect_state("running")


def test_a_traceback_has_no_frames_of_what_imports_the_program(
    browser: Browser, serve: Serve, built: Built
) -> None:
    page = browser.new_page()
    page.goto(serve(built(DEMO)))
    editor = Editor(page)
    editor.replace("STEP = 1", "STEP = (1")
    editor.run()
    editor.node.expect_state("failed")
    expect(editor.state).to_have_text("error in line 9")
    assert editor.node.lines() == [
        '  File "/ros/python/py_counter/counter.py", line 9',
        "    STEP = (1",
        "           ^",
        "SyntaxError: '(' was never closed",
        "counter: exited with code 1",
    ]
    editor.node.button("Clear").click()
    editor.replace("STEP = (1", "import missing")
    editor.run()
    editor.node.wait_for("exited with")
    assert editor.node.lines() == [
        "Traceback (most recent call last):",
        '  File "/ros/python/py_counter/counter.py", line 9, in <module>',
        "    import missing",
        "ModuleNotFoundError: No module named 'missing'",
        "counter: exited with code 1",
    ]


def test_the_line_of_an_exception_is_marked(browser: Browser, serve: Serve, built: Built) -> None:
    page = browser.new_page()
    page.goto(serve(built(DEMO)))
    editor = Editor(page)
    editor.replace("self.number += STEP", "self.number += STEP / 0")
    editor.run()
    editor.node.expect_state("failed")
    expect(editor.state).to_have_text("error in line 25")
    expect(editor.page.locator(".cm-wrong")).to_have_text("        self.number += STEP / 0")
    editor.replace("self.number += STEP / 0", "self.number += 2")
    expect(editor.page.locator(".cm-wrong")).to_have_count(0)
    expect(editor.state).to_have_text("changed")


@pytest.mark.parametrize(
    ("option", "expected"),
    [
        (
            "{node: counter, file: py_counter/conter.py}",
            "editor: no Python file 'py_counter/conter.py' of py_counter is installed; "
            "did you mean 'py_counter/counter.py'?",
        ),
        (
            "shell",
            "editor: 'shell' has no Python source in this workspace; use 'source' instead",
        ),
        (
            "counter}, {buttons: counter",
            "buttons: the editor of 'counter' starts and stops it; remove the buttons",
        ),
    ],
)
def test_what_cannot_be_edited_is_said(tmp_path: Path, option: str, expected: str) -> None:
    folder = tmp_path / "site"
    shutil.copytree(DEMO / "src", folder / "src")
    (folder / "site.yaml").write_text(
        "site: {title: Test}\n"
        "nodes:\n"
        "  counter: {package: py_counter, executable: counter}\n"
        "  shell: {package: sitegen, executable: prompt}\n"
        f"pages: [{{path: /, title: Test, content: [{{editor: {option}}}]}}]\n"
    )
    with pytest.raises(SiteError) as caught:
        build(folder, output=tmp_path / "dist", report=Report())
    assert caught.value.lines == [f"site.yaml:5: {expected}"]


def test_a_slash_is_typed_and_opens_no_search(tab: Page, serve: Serve, built: Built) -> None:
    # The demo alone has one page, and so no search.
    tab.goto(f"{serve(built(ROOT))}demo08/")
    editor = Editor(tab)
    expect(tab.locator(".search-button")).to_be_visible()
    editor.replace("STEP = 1", "STEP = 10 / 2")
    expect(editor.code).to_contain_text("STEP = 10 / 2")
    expect(tab.locator("dialog.search")).to_be_hidden()


def test_the_console_stands_beside_the_editor_where_there_is_room(editor: Editor) -> None:
    for width, beside in ((1280, True), (390, False)):
        editor.page.set_viewport_size({"width": width, "height": 844})
        source = editor.page.locator(".ros-editor").bounding_box()
        lines = editor.page.locator(".ros-panel:has(> .ros-editor) .ros-lines").bounding_box()
        assert source
        assert lines
        assert (lines["x"] >= source["x"] + source["width"]) == beside
        assert (lines["y"] < source["y"] + source["height"]) == beside
