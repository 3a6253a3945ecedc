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
    expect(cell(tab, number).locator(".ros-cell-state")).to_have_text(text)


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
    expect_state(guide, 3, "failed")
    expect_state(guide, 4, "not run")
    assert graph(guide)["nodes"] == ["/guide"]


def test_a_cell_is_edited_interrupted_and_reset(guide: Tab) -> None:
    replace(guide, 4, "import time\nprint('begun')\ntime.sleep(60)")
    guide.keyboard.press("Control+Enter")
    expect(output(guide, 4)).to_have_text("begun")
    expect_state(guide, 4, "running")
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
    expect_state(guide, 1, "done")
    guide.get_by_role("button", name="Restart").click()
    run(guide, 2)
    expect(output(guide, 2).last).to_contain_text("NameError: name 'node' is not defined")
    assert graph(guide)["nodes"] == []
    expect_state(guide, 1, "not run")


@pytest.fixture
def cells(tab: Tab, serve: Serve, lab: Path) -> Tab:
    """Cells in the text of a page."""
    tab.goto(f"{serve(lab)}cells/")
    return tab


@pytest.mark.firefox(always=True)
def test_a_cell_is_outdated_when_one_above_changes(cells: Tab) -> None:
    for number in (1, 2):
        run(cells, number)
        expect_state(cells, number, "done")
    expect(output(cells, 2)).to_have_text("42")
    replace(cells, 1, "number = 5")
    expect_state(cells, 1, "outdated")
    expect_state(cells, 2, "outdated")
    run(cells, 1)
    expect_state(cells, 1, "done")
    expect_state(cells, 2, "outdated")
    run(cells, 2)
    expect(output(cells, 2)).to_have_text("35")
    expect_state(cells, 2, "done")
    run(cells, 1)
    expect_state(cells, 2, "outdated")


def test_html_is_cleaned(cells: Tab) -> None:
    run(cells, 3)
    expect(output(cells, 3).locator("td")).to_have_text("cell")
    assert output(cells, 3).evaluate("one => one.innerHTML") == (
        "<table><tbody><tr><td>cell</td></tr></tbody></table>"
    )


def test_panels_are_shown_below_cells(cells: Tab) -> None:
    run(cells, 4)
    run(cells, 5)
    form = cell(cells, 4).locator(".ros-publish")
    form.get_by_label("data string").fill("hello")
    form.get_by_role("button", name="Publish once").click()
    expect(form.get_by_role("status")).to_have_text("1 message published")
    # The other panel hears what comes after its subscription.
    cells.wait_for_function(ENDPOINTS, arg=["/typed", "subscriptions", 1])
    form.get_by_role("button", name="Publish once").click()
    expect(cell(cells, 5).locator(".ros-topics")).to_contain_text("hello")
    # A cell that runs again takes its panel away first.
    run(cells, 4)
    cells.wait_for_function(ENDPOINTS, arg=["/typed", "publishers", 0])


# Whether so many endpoints of a topic are there.
ENDPOINTS = """async ([topic, kind, count]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  return (ros.graph.topics().find(({ name }) => name === topic)?.[kind].length ?? 0) === count;
}"""


def test_names_are_completed_and_errors_marked(cells: Tab) -> None:
    run(cells, 1)
    expect_state(cells, 1, "done")
    replace(cells, 2, "numb")
    cells.keyboard.press("Tab")
    expect(cell(cells, 2).locator(".cm-line")).to_have_text("number")
    replace(cells, 2, "number.re")
    cells.keyboard.press("Tab")
    expect(cell(cells, 2).locator(".cm-line")).to_have_text("number.real")
    cells.keyboard.type("(")
    expect(cell(cells, 2).locator(".ros-cell-note")).to_have_text("syntax error in line 1")
    expect(cell(cells, 2).locator(".cm-wrong")).to_have_count(1)


def test_a_link_has_the_changes_but_runs_nothing(cells: Tab) -> None:
    replace(cells, 2, "number * 100")
    fragment = cells.evaluate(
        "async () => (await import(document.querySelector('script[type=module]').src)).ros.link()"
    )
    url = cells.url.partition("#")[0]
    cells.goto("about:blank")
    cells.goto(url + fragment)
    expect(cell(cells, 2).locator(".cm-line")).to_have_text("number * 100")
    expect(cell(cells, 2).locator(".ros-cell-note")).to_have_text(
        "changed by the link: read it before you run it"
    )
    expect_state(cells, 2, "not run")
    cell(cells, 2).get_by_role("button", name="Reset").click()
    expect(cell(cells, 2).locator(".cm-line")).to_have_text("number * 7")


def test_the_outputs_of_a_saved_notebook_are_shown(tab: Tab, serve: Serve, lab: Path) -> None:
    tab.goto(f"{serve(lab)}saved/")
    expect(output(tab, 1)).to_have_text(["once", "42"])
    assert output(tab, 2).evaluate("image => image.complete && image.naturalWidth") == 1
    expect(output(tab, 2)).to_have_attribute("alt", "<a picture>")
    run(tab, 2)
    expect(output(tab, 2)).to_have_text("54")
