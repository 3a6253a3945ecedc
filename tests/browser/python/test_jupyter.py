"""JupyterLab on a page: its kernels take part in the graph of the page."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from browser import Built, Serve, serving
from panel import Panel, graph
from paths import ROOT
from playwright.sync_api import Browser, Error, FrameLocator, Locator, expect
from playwright.sync_api import Page as Tab
from waiting import until

CELL = ".jp-Notebook .jp-Cell"
# The application has a tab for each notebook; the others are hidden.
SHOWN = ".jp-NotebookPanel:not(.lm-mod-hidden)"


class Notebook:
    """An open notebook, in a frame of a page or in a tab of its own."""

    def __init__(self, tab: Tab, inside: Tab | FrameLocator) -> None:
        self._tab = tab
        self._inside = inside
        expect(self.cell(0)).to_be_visible()

    def cell(self, number: int) -> Locator:
        return self._inside.locator(f"{SHOWN} {CELL}").nth(number)

    def output(self, number: int) -> Locator:
        return self.cell(number).locator(".jp-OutputArea-output")

    def run(self, number: int) -> Locator:
        """Run a cell without waiting for it, and return its outputs."""
        self.cell(number).locator(".cm-content").click()
        self._tab.keyboard.press("Shift+Enter")
        return self.output(number)

    def expect_ready(self) -> None:
        """Wait for the kernel: JupyterLab ignores what is run before it has one."""
        # The status bar first: the indicator of a notebook shows "idle" before it knows a status.
        expect(self._inside.locator("#jp-main-statusbar")).to_contain_text("Python (ROS 2) | Idle")
        indicator = self._inside.locator(f"{SHOWN} .jp-Notebook-ExecutionIndicator")
        expect(indicator).to_have_attribute("data-status", "idle")

    def expect_done(self, number: int) -> None:
        expect(self.cell(number).locator(".jp-InputPrompt")).to_have_text(re.compile(r"\[\d+\]:"))

    def press(self, title: str) -> None:
        """Press a button of the toolbar whose title begins with `title`."""
        button = self._inside.locator(f"{SHOWN} jp-button[title^='{title}']")
        button.first.click()

    def confirm(self) -> None:
        self._inside.locator(".jp-Dialog .jp-mod-accept").click()

    def answer(self, text: str) -> None:
        field = self._inside.locator(f"{SHOWN} .jp-Stdin-input")
        field.fill(text)
        field.press("Enter")

    def close(self) -> None:
        """Close the notebook that is shown, without saving it."""
        tab = self._inside.locator("#jp-main-dock-panel .lm-TabBar-tab.lm-mod-current")
        tab.locator(".lm-TabBar-tabCloseIcon").click()

    def discard(self) -> None:
        self._inside.locator(".jp-Dialog button", has_text="Discard").click()

    def open(self, folder: str, name: str) -> None:
        browser = self._inside.locator(".jp-DirListing-content")
        if folder:
            browser.get_by_text(folder, exact=True).dblclick()
        browser.get_by_text(name, exact=True).dblclick()
        tab = self._inside.locator("#jp-main-dock-panel .lm-TabBar-tab.lm-mod-current")
        expect(tab).to_contain_text(name)
        self.expect_ready()


@pytest.fixture
def tab(browser: Browser, serve: Serve) -> Iterator[Tab]:
    """An empty tab. JupyterLab looks for the files of tracebacks, so some are not found."""
    context = browser.new_context(viewport={"width": 1280, "height": 900})
    tab = context.new_page()
    errors: list[str] = []
    tab.on("pageerror", lambda error: errors.append(str(error)))
    yield tab
    context.close()
    assert errors == []


@pytest.fixture
def notebook(tab: Tab, serve: Serve, lab: Path) -> Iterator[Notebook]:
    """The first notebook, on its page; nothing is requested from elsewhere."""
    asked: list[str] = []
    tab.on("request", lambda request: asked.append(request.url))
    # Below a prefix, as on GitHub Pages.
    url = serve(lab, "/robot/")
    tab.goto(f"{url}lab/")
    found = Notebook(tab, tab.frame_locator("iframe"))
    found.expect_ready()
    yield found
    hosts = {urlsplit(each).netloc for each in asked if each.startswith("http")}
    assert hosts == {urlsplit(url).netloc}


@pytest.mark.firefox(always=True)
def test_a_notebook_hears_a_compiled_node(tab: Tab, notebook: Notebook) -> None:
    Panel(tab, "talker").start()
    expect(notebook.run(1)).to_have_text("'web_node'")
    expect(notebook.run(2)).to_have_text("True")
    assert "/web_node" in graph(tab)["nodes"]


def test_what_spins_is_interrupted_and_a_restart_leaves_nothing(
    tab: Tab, notebook: Notebook
) -> None:
    notebook.run(1)
    notebook.expect_done(1)
    notebook.run(3)
    expect(notebook.cell(3).locator(".jp-InputPrompt")).to_have_text("[*]:")
    notebook.press("Interrupt")
    expect(notebook.output(3)).to_contain_text(re.compile("KeyboardInterrupt|ExternalShutdown"))
    assert graph(tab)["nodes"] == ["/web_node"]
    notebook.press("Restart the kernel")
    notebook.confirm()
    expect(notebook.run(1)).to_have_text("'web_node'")
    assert graph(tab)["nodes"] == ["/web_node"]


def test_two_notebooks_have_a_kernel_each(tab: Tab, notebook: Notebook) -> None:
    notebook.run(1)
    notebook.expect_done(1)
    notebook.open("more", "outputs.ipynb")
    outputs = notebook.run(0)
    expect(outputs).to_have_text(["printed", "wrong", "bold", "42"])
    expect(outputs.locator("b")).to_have_text("bold")
    expect(notebook.run(1)).to_have_text("'awaited'")
    expect(notebook.run(2)).to_contain_text("ValueError: no such robot")
    notebook.run(3)
    notebook.answer("Marvin")
    expect(notebook.output(3)).to_contain_text(["Your name? ", "'Hello Marvin'"])
    assert graph(tab)["nodes"] == ["/web_node"]


@pytest.mark.parametrize("cell", [4, 5], ids=["await", "sleep"])
def test_what_waits_is_interrupted(notebook: Notebook, cell: int) -> None:
    notebook.open("more", "outputs.ipynb")
    notebook.run(0)
    notebook.expect_done(0)
    notebook.run(cell)
    expect(notebook.cell(cell).locator(".jp-InputPrompt")).to_have_text("[*]:")
    notebook.press("Interrupt")
    expect(notebook.output(cell)).to_contain_text(re.compile("KeyboardInterrupt|CancelledError"))
    expect(notebook.run(6)).to_have_text("'still here'")


def test_without_a_page_around_it_a_notebook_has_a_graph_of_its_own(
    tab: Tab, serve: Serve, lab: Path
) -> None:
    tab.goto(f"{serve(lab, '/robot/')}jupyter/lab/index.html?path=first.ipynb")
    notebook = Notebook(tab, tab)
    notebook.expect_ready()
    expect(notebook.run(1)).to_have_text("'web_node'")


def test_nothing_of_a_notebook_is_left_when_its_frame_goes_away(
    tab: Tab, notebook: Notebook
) -> None:
    notebook.run(1)
    notebook.expect_done(1)
    tab.locator("iframe").evaluate("frame => frame.contentWindow.location.replace('about:blank')")
    tab.wait_for_function(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          return !ros.graph.nodes().length && [...ros.nodes.keys()].join() === "notebook,talker";
        }"""
    )


NODES = """async (names) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  return ros.graph.nodes().sort().join() === names.join();
}"""


def test_several_kernels_spin_beside_each_other_and_a_closed_one_leaves(
    tab: Tab, notebook: Notebook
) -> None:
    notebook.run(1)
    notebook.expect_done(1)
    notebook.open("", "second.ipynb")
    Panel(tab, "talker").start()
    expect(notebook.run(0)).to_have_text("'second'")
    # What spins in the background blocks no cell.
    expect(notebook.run(1)).to_have_text("'spinning'")
    expect(notebook.run(2)).to_have_text("True")
    tab.wait_for_function(NODES, arg=["/second", "/talker", "/web_node"])
    notebook.close()
    notebook.discard()
    tab.wait_for_function(NODES, arg=["/talker", "/web_node"])


def test_a_loop_that_never_waits_is_ended_by_a_restart(tab: Tab, notebook: Notebook) -> None:
    notebook.open("", "second.ipynb")
    notebook.run(0)
    notebook.expect_done(0)
    notebook.run(5)
    expect(notebook.cell(5).locator(".jp-InputPrompt")).to_have_text("[*]:")
    notebook.press("Restart the kernel")
    notebook.confirm()
    expect(notebook.run(0)).to_have_text("'second'")
    tab.wait_for_function(NODES, arg=["/second"])


def test_panels_of_the_page_are_shown_in_outputs(tab: Tab, notebook: Notebook) -> None:
    notebook.open("", "second.ipynb")
    notebook.run(3)
    panel = notebook.cell(3).frame_locator("iframe")
    panel.get_by_label("data string").fill("from the lab")
    panel.get_by_role("button", name="Publish once").click()
    expect(panel.get_by_role("status")).to_have_text("1 message published")
    tab.wait_for_function(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          return ros.graph.topics().some((one) => one.name === "/typed" && one.publishers.length);
        }"""
    )
    notebook.run(6)
    expect(notebook.cell(6).frame_locator("iframe").locator("canvas").first).to_be_visible()


def test_a_bag_of_the_folder_is_read(notebook: Notebook) -> None:
    notebook.open("", "second.ipynb")
    expect(notebook.run(4)).to_have_text("[('/words', 'word 0'), ('/words', 'word 1')]")


@pytest.mark.exhaustive
def test_fifty_restarts_leave_nothing(tab: Tab, notebook: Notebook) -> None:
    for _ in range(50):
        expect(notebook.run(1)).to_have_text("'web_node'")
        assert graph(tab)["nodes"] == ["/web_node"]
        notebook.press("Restart the kernel")
        notebook.confirm()
        tab.wait_for_function(NODES, arg=[])
        notebook.expect_ready()


@pytest.mark.firefox(always=True)
def test_a_cell_calls_a_compiled_server_of_the_page_beside_it(
    tab: Tab, serve: Serve, beside: Path
) -> None:
    # In a narrow column, JupyterLab hides the indicator of a notebook.
    tab.set_viewport_size({"width": 1900, "height": 900})
    tab.goto(f"{serve(beside, '/robot/')}lab/")
    notebook = Notebook(tab, tab.frame_locator("iframe"))
    status = tab.frame_locator("iframe").locator("#jp-main-statusbar")
    expect(status).to_contain_text("Python (ROS 2) | Idle")
    Panel(tab, "server").start()
    expect(notebook.run(0)).to_have_text("42")


def test_a_page_of_a_notebook_opens_it_in_the_lab(tab: Tab, serve: Serve, lab: Path) -> None:
    tab.goto(f"{serve(lab, '/robot/')}lab/second/")
    tab.get_by_role("link", name="Open in the lab").click()
    notebook = Notebook(tab, tab.frame_locator("iframe"))
    expect(notebook.cell(0)).to_contain_text('create_node("second")')


def test_only_the_lab_has_a_policy_that_allows_more(lab: Path) -> None:
    loose = {
        page.relative_to(lab).as_posix()
        for page in lab.rglob("*.html")
        if re.search("unsafe-(inline|eval)'", page.read_text().replace("wasm-unsafe-eval", ""))
    }
    assert loose and all(name.startswith("jupyter/") for name in loose)
    assert "jupyter/panel.html" not in loose


def make(folder: Path, keys: str) -> Path:
    """Return the folder of sites/lab without its C++ node, with other keys of the site."""
    shutil.copytree(ROOT / "tests/sites/lab", folder)
    pages = "pages:\n  - {path: /, title: Start, content: [{markdown: Hello.}]}\n"
    pages += "  - {path: lab/, title: Lab, jupyter: {notebooks: notebooks, open: second.ipynb}}\n"
    (folder / "site.yaml").write_text(f"site:\n  title: Lab\n  {keys}\n{pages}")
    return folder


@pytest.mark.chromium
def test_an_isolated_lab_interrupts_a_loop_and_works_without_a_network(
    tab: Tab, built: Built, tmp_path: Path
) -> None:
    dist = built(make(tmp_path / "site", "isolate: true\n  offline: true"))
    with serving(dist, "/robot/") as url:
        tab.goto(f"{url}lab/")
        until(lambda: told(tab, "crossOriginIsolated && document.readyState === 'complete'"))
        notebook = Notebook(tab, tab.frame_locator("iframe"))
        notebook.expect_ready()
        notebook.run(0)
        notebook.expect_done(0)
        notebook.run(5)
        expect(notebook.cell(5).locator(".jp-InputPrompt")).to_have_text("[*]:")
        notebook.press("Interrupt")
        expect(notebook.output(5)).to_contain_text("KeyboardInterrupt")
        until(lambda: told(tab, KEPT))
    tab.reload()
    notebook = Notebook(tab, tab.frame_locator("iframe"))
    notebook.expect_ready()
    expect(notebook.run(0)).to_have_text("'second'")


def told(tab: Tab, expression: str) -> object:
    """Return what a page says; one that is about to be loaded again says nothing."""
    try:
        return tab.evaluate(expression)
    except Error:
        return None


# All that the page needs without a network is in the cache.
KEPT = """async () => {
  const worker = await (await fetch("../sw.js")).text();
  const { pages } = JSON.parse(worker.match(/^const BUILD = (.*);$/m)[1]);
  const kept = new Set();
  for (const name of await caches.keys()) {
    const requests = await (await caches.open(name)).keys();
    for (const { url } of requests) kept.add(decodeURIComponent(new URL(url).pathname));
  }
  return pages["lab/"].every((name) => name.includes(".asyncify.") || kept.has(`/robot/${name}`));
}"""
