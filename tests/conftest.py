"""What several test files share."""

from __future__ import annotations

import shutil
import signal
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from browser import (
    TIMEOUT,
    WITHOUT_JSPI,
    Built,
    Scripted,
    Serve,
    opened,
    own_serving,
    running,
    serving,
)
from distribution import distribution
from panel import Panel, Played
from paths import ROOT
from playwright.sync_api import Browser, BrowserContext, Page, expect
from programs import options_of
from stage import set_up
from webkit import Window, webkit

from sitegen.build import make, write
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.report import Report

# How the ROS2WASM project builds.
ROS2WASM = ["-O1", "--bind", "-fexceptions", "-sASYNCIFY=1", "-sEXIT_RUNTIME=1", "-sASSERTIONS=1"]

expect.set_options(timeout=TIMEOUT)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--all", action="store_true", help="run everything: all browsers, engines and counts"
    )
    parser.addoption(
        "--firefox", action="store_true", help="run the tests of pages in Firefox only"
    )


def pytest_configure() -> None:
    """Heed interrupts: a shell ignores them for all that it runs in the background."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Choose the browsers and engines that a test of pages runs in.

    That is Chromium with JSPI, and what else its marks name: `firefox`, `webkit` and `asyncify`
    with `always=True` in every run, without it with `--all`.
    """
    config = metafunc.config
    marks = {mark.name: mark for mark in metafunc.definition.iter_markers()}

    def wanted(name: str) -> bool:
        mark = marks.get(name)
        return mark is not None and (config.getoption("all") or mark.kwargs.get("always", False))

    if "browser_name" in metafunc.fixturenames:
        names = ["chromium", *(name for name in ("firefox", "webkit") if wanted(name))]
        if "chromium" not in marks and config.getoption("firefox"):
            names = ["firefox"]
        metafunc.parametrize("browser_name", names, indirect=True, scope="session")
    if "engine" in metafunc.fixturenames:
        both = config.getoption("all") or wanted("asyncify")
        metafunc.parametrize("engine", ["jspi", "asyncify"] if both else ["jspi"], indirect=True)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave Firefox without JSPI to `--firefox`: Chromium without it runs the same programs.

    What is marked as `exhaustive` runs with `--all` only.
    """
    if not config.getoption("firefox"):
        items[:] = [item for item in items if not _is_firefox_without_jspi(item)]
    if not config.getoption("all"):
        items[:] = [item for item in items if not item.get_closest_marker("exhaustive")]


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
def serve(request: pytest.FixtureRequest) -> Iterator[Serve]:
    """A function that serves a folder, below a prefix if given, until the test is over."""
    server = own_serving if request.node.get_closest_marker("own_server") else serving
    with ExitStack() as servers:

        def start(folder: Path, prefix: str = "/") -> str:
            return servers.enter_context(server(folder, prefix))

        yield start


# It asks for `serve` so that it closes before the servers: what still loads would be an error.
@pytest.fixture
def tab(browser: Browser, serve: Serve) -> Iterator[Page]:
    """An empty tab; the test fails when its console shows an error."""
    with opened(browser) as tab:
        yield tab


@pytest.fixture(scope="session")
def built(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Built:
    """A function that builds the site of a folder, once, and returns where it is.

    Its programs are those that `make test` compiled beforehand; see programs.py.
    """
    sites: dict[Path, Path] = {}

    def made(folder: Path) -> Path:
        if folder not in sites:
            output = tmp_path_factory.mktemp(folder.name) / "dist"
            options = options_of(folder, everything=request.config.getoption("all"))
            write(make(folder, Report(), output=output, options=options).artifacts, output)
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


@pytest.fixture
def engine(request: pytest.FixtureRequest) -> str:
    """The engine that nodes run on: that of browsers with JSPI, or that of browsers without."""
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


@pytest.fixture(scope="session")
def dist(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Path:
    """The folder with the sdist and the wheel of a release, which all processes share."""
    base = tmp_path_factory.getbasetemp()
    return distribution((base if worker_id == "master" else base.parent) / "distribution")
