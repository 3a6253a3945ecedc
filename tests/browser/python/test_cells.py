"""Python cells of a page: they run in one interpreter, on the graph of the page."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Serve
from panel import graph
from playwright.sync_api import Locator, Route, expect
from playwright.sync_api import Page as Tab


@pytest.fixture
def guide(tab: Tab, serve: Serve, lab: Path) -> Tab:
    tab.goto(f"{serve(lab)}guide/")
    return tab


def cell(tab: Tab, number: int) -> Locator:
    return tab.locator(".ros-cell").nth(number - 1)


def output(tab: Tab, number: int) -> Locator:
    return cell(tab, number).locator(".ros-output > *")


def run(tab: Tab, number: int) -> None:
    tab.get_by_role("button", name=f"Run cell {number}", exact=True).click()


def expect_state(tab: Tab, number: int, text: str) -> None:
    expect(cell(tab, number).locator(".ros-count")).to_have_text(text)


def replace(tab: Tab, number: int, text: str) -> None:
    """Type `text` in place of the only line of a cell."""
    tab.get_by_role("textbox", name=f"Python cell {number}").focus()
    tab.keyboard.press("End")
    tab.keyboard.press("Shift+Home")
    tab.keyboard.type(text)


def test_cells_run_in_order_until_one_fails(tab: Tab, serve: Serve, lab: Path) -> None:
    def delay(route: Route) -> None:
        tab.wait_for_timeout(300)
        route.continue_()

    # Imports of one module by several cells end in any order while it is loading.
    tab.route("**/cell.js*", delay)
    guide = tab
    guide.goto(f"{serve(lab)}guide/")
    guide.get_by_role("button", name="Run all").click()
    expect(output(guide, 1)).to_have_text(["hello from guide", "'guide'"])
    expect(output(guide, 2)).to_have_text(["'GUIDE'"])
    expect(output(guide, 3)).to_have_text(
        [
            "Traceback (most recent call last):\n"
            '  File "<cell 3>", line 5, in <module>\n'
            "    fail()\n"
            "    ~~~~^^\n"
            '  File "<cell 3>", line 2, in fail\n'
            '    raise ValueError("no such robot")\n'
            "ValueError: no such robot\n"
        ]
    )
    expect_state(guide, 3, "[!]")
    expect_state(guide, 4, "[ ]")
    assert graph(guide)["nodes"] == ["/guide"]


def test_a_cell_is_edited_interrupted_and_reset(guide: Tab) -> None:
    replace(guide, 4, "import time\nprint('begun')\ntime.sleep(60)")
    guide.keyboard.press("Control+Enter")
    expect(output(guide, 4)).to_have_text("begun")
    expect_state(guide, 4, "[*]")
    guide.get_by_role("button", name="Interrupt").click()
    expect(output(guide, 4).last).to_contain_text("KeyboardInterrupt")
    cell(guide, 4).get_by_role("button", name="Reset").click()
    run(guide, 4)
    expect(output(guide, 4)).to_have_text("'not reached'")
    replace(guide, 4, "'<b>text</b>'")
    guide.keyboard.press("Control+Enter")
    expect(output(guide, 4)).to_have_text("'<b>text</b>'")


def test_a_restart_forgets_the_variables(guide: Tab) -> None:
    run(guide, 1)
    expect_state(guide, 1, "[ok]")
    guide.get_by_role("button", name="Restart").click()
    run(guide, 2)
    expect(output(guide, 2).last).to_contain_text("NameError: name 'node' is not defined")
    assert graph(guide)["nodes"] == []


def test_the_outputs_of_a_saved_notebook_are_shown(tab: Tab, serve: Serve, lab: Path) -> None:
    tab.goto(f"{serve(lab)}saved/")
    expect(output(tab, 1)).to_have_text(["once", "42"])
    assert output(tab, 2).evaluate("image => image.complete && image.naturalWidth") == 1
    expect(output(tab, 2)).to_have_attribute("alt", "<a picture>")
    run(tab, 2)
    expect(output(tab, 2)).to_have_text("54")
