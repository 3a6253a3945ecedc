"""What several test files share."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from browser import Built, Serve, chromium, serving
from playwright.sync_api import Browser, BrowserContext, ConsoleMessage, Page, expect

from sitegen.build import build
from sitegen.report import Report

ROOT = Path(__file__).parent.parent
# A browser that lacks JSPI gets the other build of each node.
WITHOUT_JSPI = "delete WebAssembly.Suspending; delete WebAssembly.promising;"


# A slow machine is no fault of what is tested: what is waited for may take its time.
expect.set_options(timeout=60_000)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """One Chromium for all tests."""
    with chromium() as browser:
        yield browser


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
    context = browser.new_context()
    errors: list[str] = []
    tab = context.new_page()

    def note(message: ConsoleMessage) -> None:
        if message.type == "error":
            errors.append(message.text)

    tab.on("console", note)
    tab.on("pageerror", lambda error: errors.append(str(error)))
    yield tab
    context.close()
    assert errors == []


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Built:
    """A function that builds the site of a folder, once, and returns where it is."""
    sites: dict[Path, Path] = {}

    def made(folder: Path) -> Path:
        if folder not in sites:
            output = tmp_path_factory.mktemp(folder.name) / "dist"
            build(folder, output=output, report=Report())
            sites[folder] = output
        return sites[folder]

    return made


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
def stage(tab: Page, serve: Serve, tmp_path: Path) -> Page:
    """A page with a graph that does what the test says; see stage.py."""
    shutil.copytree(ROOT / "sitegen/runtime", tmp_path / "runtime")
    shutil.copytree(ROOT / "themes/default", tmp_path / "theme")
    shutil.copytree(ROOT / "tests/panels", tmp_path, dirs_exist_ok=True)
    tab.goto(serve(tmp_path))
    tab.wait_for_selector("body[data-ready]")
    return tab
