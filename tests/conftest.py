"""What several test files share."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from browser import Serve, chromium, serving
from playwright.sync_api import Browser, ConsoleMessage, Page


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
