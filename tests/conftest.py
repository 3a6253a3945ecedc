"""What several test files share."""

from __future__ import annotations

import shutil
import signal
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from browser import Built, Scripted, Serve, opened, running, serving
from panel import Panel, Played
from paths import ROOT, TESTS
from playwright.sync_api import Browser, BrowserContext, Page, expect
from stage import set_up
from webkit import Window, webkit

from sitegen.build import make, write
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.options import Options
from sitegen.report import Report

# How the ROS2WASM project builds.
ROS2WASM = ["-O1", "--bind", "-fexceptions", "-sASYNCIFY=1", "-sEXIT_RUNTIME=1", "-sASSERTIONS=1"]
# A browser that lacks JSPI gets the other build of each node.
WITHOUT_JSPI = "delete WebAssembly.Suspending; delete WebAssembly.promising;"

# A slow machine is no fault of what is tested: what is waited for may take its time.
expect.set_options(timeout=60_000)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--firefox", action="store_true", help="run the tests of pages in Firefox only"
    )


def pytest_configure() -> None:
    """Heed interrupts: a shell ignores them for all that it runs in the background."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run the tests of pages in Chromium, the reference, and in what else they are marked with."""
    if "browser_name" not in metafunc.fixturenames:
        return
    marks = {mark.name for mark in metafunc.definition.iter_markers()}
    if "chromium" in marks:
        names = ["chromium"]
    elif metafunc.config.getoption("firefox"):
        names = ["firefox"]
    else:
        names = ["chromium", *(name for name in ("firefox", "webkit") if name in marks)]
    metafunc.parametrize("browser_name", names, indirect=True, scope="session")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Run a test of a page again when it fails, and name it.

    Firefox without JSPI is left to `--firefox`: Chromium without it runs the same programs.

    The three browsers are programs of others, on a machine that others use, with a second test
    beside this one; a few of a thousand runs fail by that. What is wrong here fails three times.
    """
    if not config.getoption("firefox"):
        items[:] = [item for item in items if not _is_firefox_without_jspi(item)]
    for item in items:
        fixtures = set(getattr(item, "fixturenames", ()))
        if {"browser_name", "webkit_window"} & fixtures:
            item.add_marker(pytest.mark.flaky(reruns=2))


def _is_firefox_without_jspi(item: pytest.Item) -> bool:
    return (_parameter(item, "browser_name"), _parameter(item, "engine")) == ("firefox", "asyncify")


def _parameter(item: pytest.Item, name: str) -> object:
    """Return what a test is run with; its parameters are where pytest keeps them."""
    call = getattr(item, "callspec", None)
    return call.params.get(name) if call else None


@pytest.fixture(scope="session")
def browser_name(request: pytest.FixtureRequest) -> str:
    """The browser that the test runs in."""
    return str(request.param)


@pytest.fixture(scope="session")
def browser(browser_name: str) -> Iterator[Browser]:
    """One Chromium or Firefox for all tests."""
    with running(browser_name) as browser:
        yield browser


@pytest.fixture(autouse=True)
def nothing_left_open(request: pytest.FixtureRequest) -> Iterator[None]:
    """Close the pages that a test opened: their nodes would run beside those of all others."""
    if "browser" not in request.fixturenames:
        yield
        return
    browser: Browser = request.getfixturevalue("browser")
    before = list(browser.contexts)
    yield
    for context in browser.contexts:
        if context not in before:
            context.close()


@pytest.fixture(scope="session")
def webkit_window() -> Iterator[Window]:
    """One WebKitGTK for all tests."""
    with webkit() as window:
        yield window


@pytest.fixture
def window(webkit_window: Window, serve: Serve) -> Iterator[Window]:
    """An empty window of WebKitGTK."""
    yield webkit_window
    webkit_window.goto("about:blank")


@pytest.fixture
def any_tab(browser_name: str, request: pytest.FixtureRequest) -> Scripted:
    """An empty tab or window of any browser, for tests that only run scripts in it."""
    found: Scripted = request.getfixturevalue("window" if browser_name == "webkit" else "tab")
    return found


@pytest.fixture
def serve() -> Iterator[Serve]:
    """A function that serves a folder, below a prefix if given, until the test is over."""
    with ExitStack() as servers:

        def start(folder: Path, prefix: str = "/") -> str:
            return servers.enter_context(serving(folder, prefix))

        yield start


# It asks for `serve` so that it closes before the servers: what still loads would be an error.
@pytest.fixture
def tab(browser: Browser, serve: Serve) -> Iterator[Page]:
    """An empty tab; the test fails when its console shows an error."""
    with opened(browser) as tab:
        yield tab


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Built:
    """A function that builds the site of a folder, once, and returns where it is.

    The programs of sites that are there for tests are drafts: to optimize hundreds of them would
    take longer than the tests. Those of demos are what `sitegen build` makes of them.
    """
    sites: dict[Path, Path] = {}

    def made(folder: Path) -> Path:
        if folder not in sites:
            output = tmp_path_factory.mktemp(folder.name) / "dist"
            draft = TESTS in folder.parents
            write(
                make(folder, Report(), output=output, options=Options(draft=draft)).artifacts,
                output,
            )
            sites[folder] = output
        return sites[folder]

    return made


@pytest.fixture(scope="session")
def ros2wasm(built: Built, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The built site of sites/ros2wasm, with a program that is compiled as theirs are."""
    folder = tmp_path_factory.mktemp("ros2wasm") / "site"
    shutil.copytree(ROOT / "tests/sites/ros2wasm", folder)
    shutil.copytree(ROOT / "demos/demo05/src", folder / "src")
    tools = Toolchain.find()
    pre = [f"--pre-js={folder / name}" for name in ("nodes/middleware.js", "compiled/module.js")]
    source, program = folder / "compiled/program.cpp", folder / "nodes/program.js"
    done = tools.run(tools.compiler, *ROS2WASM, *pre, source, "-o", str(program))
    assert done.returncode == 0, done.stdout
    return built(folder)


@pytest.fixture(params=["jspi", "asyncify"])
def engine(request: pytest.FixtureRequest) -> str:
    """The two kinds of browsers that nodes are built for."""
    return str(request.param)


@pytest.fixture
def context(browser: Browser, serve: Serve, engine: str) -> Iterator[BrowserContext]:
    """A browser of that kind."""
    context = browser.new_context()
    if engine == "asyncify":
        context.add_init_script(WITHOUT_JSPI)
    yield context
    context.close()


@pytest.fixture
def played(context: BrowserContext, serve: Serve, built: Built) -> Played:
    """A function that runs a node of a page to its end, and returns its panel."""

    def play(site: Path, page: str, node: str) -> Panel:
        tab = context.new_page()
        tab.goto(f"{serve(built(site))}{page}/")
        panel = Panel(tab, node)
        panel.start()
        panel.expect_state("stopped")
        return panel

    return play


@pytest.fixture
def stage(tab: Page, serve: Serve, tmp_path: Path) -> Page:
    """A page with a graph that does what the test says; see stage.py."""
    set_up(tmp_path)
    tab.goto(serve(tmp_path))
    tab.wait_for_selector("body[data-ready]")
    return tab
