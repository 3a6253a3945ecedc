"""Cells of JavaScript: each is a program in a worker of its own, on the graph of the page."""

from __future__ import annotations

import re
from pathlib import Path
from textwrap import dedent

import pytest
from browser import Scripted, Serve
from playwright.sync_api import Locator, Page, expect

from sitegen.build import make, write
from sitegen.options import Options
from sitegen.report import Report

SITE = """\
site: {title: Cells}
pages: [{path: /, file: page.md}]
"""
IMPORT = 'import { ros } from "sitegen";\n'
CELLS = [
    'console.log("sum %d", 3, { x: 0, big: 2n, data: new Float64Array(2) });',
    'const chatter = ros.topic("/chatter", "std_msgs/msg/String");\n'
    'chatter.subscribe(({ data }) => console.log("heard", data));\n'
    'const double = ros.service("/double", "example_interfaces/srv/AddTwoInts");\n'
    "double.serve(({ a }) => ({ sum: a * 2n }));\n"
    'ros.node("/listener").declare("speed", 0.5);',
    'ros.topic("/chatter", "std_msgs/msg/String").publish({ data: "once" });\n'
    'const { sum } = await ros.service("/double").call({ a: 21n });\n'
    'console.log(sum, await ros.parameters("/listener").get("speed"));',
    'console.log("before");\nnull.after();',
]


def fence(text: str, language: str = "js") -> str:
    return f"```{language} ros\n{IMPORT}{text}\n```\n"


def page(*cells: str) -> str:
    return "# Cells\n\n" + "\n".join(cells)


@pytest.fixture(scope="session")
def dist(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a built site, whose page has only cells."""
    site = tmp_path_factory.mktemp("cells")
    (site / "site.yaml").write_text(SITE)
    cells = [fence(text) for text in CELLS]
    (site / "page.md").write_text(page(*cells, fence("", "javascript")))
    write(make(site, Report(), options=Options(draft=True)).artifacts, site / "dist")
    return site / "dist"


@pytest.fixture
def cells(tab: Page, serve: Serve, dist: Path) -> Page:
    tab.goto(serve(dist))
    expect(tab.locator(".ros-cell-state")).to_have_count(len(CELLS) + 1)
    return tab


def cell(tab: Page, number: int) -> Locator:
    return tab.locator(".ros-javascript").nth(number - 1)


def run(tab: Page, number: int) -> None:
    tab.get_by_role("button", name=f"Run JavaScript cell {number}", exact=True).click()


def stop(tab: Page, number: int) -> None:
    tab.get_by_role("button", name=f"Stop JavaScript cell {number}", exact=True).click()


PASTE = """(editor, text) => {
  const clipboardData = new DataTransfer();
  clipboardData.setData("text/plain", text);
  const event = { clipboardData, bubbles: true, cancelable: true };
  editor.dispatchEvent(new ClipboardEvent("paste", event));
}"""


def write_into(tab: Page, number: int, text: str) -> None:
    """Paste `text` in place of all that a cell has."""
    editor = tab.get_by_role("textbox", name=f"JavaScript cell {number}")
    editor.focus()
    tab.keyboard.press("Control+A")
    editor.evaluate(PASTE, dedent(text))


def run_text(tab: Page, number: int, text: str) -> None:
    write_into(tab, number, text)
    tab.keyboard.press("Control+Enter")


def expect_state(tab: Page, number: int, text: str) -> None:
    expect(cell(tab, number).locator(".ros-cell-state")).to_have_text(text)


def expect_output(tab: Page, number: int, lines: list[str | re.Pattern[str]]) -> None:
    expect(cell(tab, number).locator(".ros-output > *")).to_have_text(lines)


def nodes(tab: Page) -> list[str]:
    """The names of the nodes in the page's graph."""
    found: list[str] = tab.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          return ros.graph.nodes();
        }"""
    )
    return found


def test_a_cell_prints_values_as_consoles_do(cells: Page) -> None:
    expect_state(cells, 1, "not run")
    run(cells, 1)
    expect_output(cells, 1, ["sum 3 { x: 0, big: 2n, data: Float64Array(2) [ 0, 0 ] }"])
    expect_state(cells, 1, "done")


def test_places_of_a_format_are_filled_as_in_node_js(cells: Page) -> None:
    text = """
    console.log("%s is %d%%, %j %o", "speed", 42, { a: [1] }, { b: "x" });
    console.log("%O", { list: Array(200).fill(0) });
    """
    run_text(cells, 1, text)
    expect_output(
        cells,
        1,
        [
            "speed is 42%, {\"a\":[1]} { b: 'x' }",
            "{",
            "  list: [",
            *[re.compile(r"^ +0(, 0)*,$")] * 9,
            "    ... 100 more items",
            "  ]",
            "}",
        ],
    )


def test_a_node_that_leaves_takes_only_what_is_its_own(cells: Page) -> None:
    text = """
    import { ros } from "sitegen";
    const [first, second] = [ros.node("/twin"), ros.node("/twin")];
    for (const node of [first, second]) {
      const type = "std_msgs/msg/String";
      node.topic("/twins", type).subscribe(({ data }) => console.log(node === second, data));
    }
    first.close();
    ros.topic("/twins", "std_msgs/msg/String").publish({ data: "still there" });
    """
    run_text(cells, 1, text)
    expect_output(cells, 1, [re.compile("another node with the name /twin"), "true still there"])
    assert nodes(cells).count("/twin") == 1


def test_cells_share_the_graph_until_they_are_stopped(cells: Page) -> None:
    run(cells, 2)
    expect_state(cells, 2, "running")
    run(cells, 3)
    # The first message of a new publisher arrives, too.
    expect_output(cells, 2, ["heard once"])
    expect_output(cells, 3, ["42n 0.5"])
    expect_state(cells, 3, "done")
    assert nodes(cells) == ["/_cell2", "/_cell3", "/listener"]
    expect(cells.get_by_role("button", name="Run JavaScript cell 2")).to_be_hidden()
    stop(cells, 2)
    expect_state(cells, 2, "stopped")
    assert nodes(cells) == ["/_cell3"]


def test_what_a_cell_was_is_gone_before_it_runs_again(cells: Page) -> None:
    run(cells, 2)
    expect_state(cells, 2, "running")
    run_text(cells, 2, IMPORT + "console.log(ros.nodes(), ros.topics().length);")
    expect_output(cells, 2, ["[ '/_cell2' ] 0"])
    expect_state(cells, 2, "done")
    write_into(cells, 2, "// Later.")
    expect_state(cells, 2, "outdated")
    cell(cells, 2).get_by_role("button", name="Reset").click()
    run(cells, 2)
    expect_state(cells, 2, "running")


def test_errors_name_their_line(cells: Page) -> None:
    run(cells, 4)
    expect_output(cells, 4, ["before", re.compile(r"^TypeError: .*null.*\n    at line 3$")])
    expect_state(cells, 4, "failed")
    expect(cell(cells, 4).locator(".cm-wrong")).to_have_text("null.after();")
    # What a callback throws does not end the program.
    text = "setInterval(() => console.log('goes on'), 10);\nsetTimeout(() => {\n  never(); });"
    run_text(cells, 4, text)
    expect(cell(cells, 4).locator(".ros-output > .ros-error")).to_have_text(
        re.compile(r"^ReferenceError: never is not defined\n    at line 3$")
    )
    expect(cell(cells, 4).get_by_text("goes on").nth(30)).to_be_attached()
    expect_state(cells, 4, "running")
    run_text(cells, 4, "throw 'a text';")
    expect_output(cells, 4, ["uncaught: a text"])


def test_syntax_errors_are_told_while_one_types(cells: Page) -> None:
    write_into(cells, 5, "const a = 1;\nconst b = ;\n")
    expect(cell(cells, 5).locator(".ros-cell-note")).to_have_text("syntax error in line 2")
    run(cells, 5)
    expect_output(cells, 5, [re.compile("^SyntaxError: ")])
    expect_state(cells, 5, "failed")
    # The parser of the editor does not know this pattern, which is right.
    write_into(cells, 5, "const a = {};\n[a.b, a.c] = [1, 2];")
    run(cells, 5)
    expect_state(cells, 5, "done")
    expect(cell(cells, 5).locator(".ros-cell-note")).to_be_hidden()


def test_cells_import_only_modules_of_sitegen(cells: Page) -> None:
    run_text(cells, 1, 'import { Ros } from "roslib"; // from "sitegen"')
    wrong = "cells cannot import 'roslib'; they can import sitegen$"
    expect_output(cells, 1, [re.compile(f"^{wrong}")])
    expect_state(cells, 1, "failed")
    text = """\
    const { GoalError } = await import("sitegen");
    // A text such as from "roslib" is none.
    const told = 'import "roslib"';
    console.log(typeof GoalError, told);
    """
    run_text(cells, 1, text)
    expect_output(cells, 1, ['function import "roslib"'])


def test_a_loop_without_an_end_is_terminated(cells: Page) -> None:
    run_text(cells, 1, "console.log('begins');\nfor (;;);")
    expect_output(cells, 1, ["begins"])
    stop(cells, 1)
    expect_state(cells, 1, "stopped")
    expect_output(cells, 1, ["begins", re.compile("did not end within a second")])
    # Also by its next run.
    run_text(cells, 1, "for (;;);")
    expect_state(cells, 1, "running")
    run_text(cells, 1, "console.log('again');")
    expect_output(cells, 1, ["again"])


def test_a_cell_is_a_guest(cells: Page) -> None:
    text = """\
    import { ros } from "sitegen";
    // What is no answer of the runtime harms nobody.
    for (const text of ["{", "", "null"]) postMessage({ op: "answer", text });
    console.log(typeof WebSocket, typeof indexedDB, typeof Worker, typeof document);
    for (const act of [() => eval("1"), () => ros.programs, () => fetch("https://example.org")]) {
      try { await act(); } catch (error) { console.log(error.message.slice(0, 48)); }
    }
    """
    run_text(cells, 1, text)
    expect_output(
        cells,
        1,
        [
            "undefined undefined undefined undefined",
            re.compile("^(Evaluating a string as JavaScript|call to eval|Refused to evaluate)"),
            "a cell cannot start or stop programs; scripts of",
            "programs of a page can fetch the files of its si",
        ],
    )


def test_a_cell_is_done_when_it_waits_for_nothing(cells: Page) -> None:
    text = """\
    setTimeout(() => {
      console.log("timer");
      fetch(`${location.origin}/page.json`).then(({ status }) => console.log(status));
    }, 20);
    clearInterval(setInterval(() => {}, 1000));
    """
    run_text(cells, 1, text)
    expect_output(cells, 1, ["timer", "200"])
    expect_state(cells, 1, "done")
    run_text(cells, 1, IMPORT + "(async () => { for await (const one of ros.events()) one; })();")
    expect_state(cells, 1, "running")


def test_links_bring_the_text_and_do_not_run_it(cells: Page) -> None:
    write_into(cells, 1, "console.log('shared');")
    link = cells.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          return location.origin + location.pathname + ros.link();
        }"""
    )
    cells.goto("about:blank")
    cells.goto(link)
    expect(cell(cells, 1)).to_contain_text("console.log('shared');")
    expect(cell(cells, 1).locator(".ros-cell-note")).to_have_text(
        "changed by the link: read it before you run it"
    )
    expect_state(cells, 1, "not run")
    run(cells, 1)
    expect_output(cells, 1, ["shared"])


RUN_TWO = """async () => {
  const until = async (find) => {
    for (let found; !(found = find()); await new Promise((resolve) => setTimeout(resolve, 20)));
    return find();
  };
  const cell = (number) => document.querySelectorAll(".ros-javascript")[number - 1];
  const lines = (number) => [...cell(number).querySelectorAll(".ros-output > *")];
  const printed = (number) => lines(number).map((one) => one.textContent);
  const run = async (number, state) => {
    (await until(() => cell(number)?.querySelector(".ros-start"))).click();
    await until(() => cell(number).querySelector(".ros-cell-state").textContent === state);
  };
  await run(2, "running");
  await run(3, "done");
  await until(() => printed(2).length);
  await run(4, "failed");
  return [2, 3, 4].map(printed);
}"""


@pytest.mark.firefox(always=True)
@pytest.mark.webkit(always=True)
def test_cells_run_in_all_browsers(any_tab: Scripted, serve: Serve, dist: Path) -> None:
    any_tab.goto(serve(dist))
    heard, called, failed = any_tab.evaluate(RUN_TWO)
    assert (heard, called, failed[0]) == (["heard once"], ["42n 0.5"], "before")
    assert re.fullmatch(r"TypeError: .+\n    at line 3", failed[1])
