"""Sites that are served, for the tests of `sitegen serve`."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from served import SITE, Serving

from sitegen.commands.serve.server import Server
from sitegen.commands.serve.watcher import changes


@pytest.fixture
def serving(tmp_path: Path) -> Iterator[Callable[[Path], Serving]]:
    """A function that serves a folder, and follows its changes, until the test is over."""
    servers: list[Server] = []

    def start(folder: Path) -> Serving:
        serving = Serving(folder)
        edits = changes(folder)
        serving.live.rebuild()
        servers.append(serving.server.__enter__())

        def follow() -> None:
            for changed in edits:
                serving.live.rebuild(changed)

        threading.Thread(target=follow, daemon=True).start()
        return serving

    yield start
    for server in servers:
        server.__exit__()


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "site.yaml").write_text(SITE)
    (tmp_path / "index.md").write_text("# Welcome\n\nThe first text.\n")
    return tmp_path
