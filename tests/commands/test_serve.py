"""A site that is served while it is edited, in a real browser."""

from __future__ import annotations

import io
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, Page, expect

from sitegen.commands.serve.live import LiveSite
from sitegen.commands.serve.server import Server
from sitegen.commands.serve.watcher import changes
from sitegen.report import Report

SITE = """\
site: {title: My robot}
pages:
  - {path: /, file: index.md}
  - {path: other/, title: Other, content: [{markdown: The other page.}]}
"""

PAGE = """\
---
title: Two nodes
nodes:
  talker: {package: cpp_pubsub, executable: talker}
  listener: {package: cpp_pubsub, executable: listener}
---
```ros
- buttons: talker
- console: talker
- buttons: listener
- console: listener
```
"""


class Serving:
    """A site in a folder that follows its author."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.said = io.StringIO()
        self.live = LiveSite(folder, Report(self.said))
        self.server = Server(self.live, 0)

    @property
    def url(self) -> str:
        return self.server.url

    def write(self, path: str, text: str) -> None:
        (self.folder / path).write_text(text)


@pytest.fixture
def serving(tmp_path: Path) -> Iterator[Callable[[Path], Serving]]:
    """A function that serves a folder, and follows its changes, until the test is over."""
    servers: list[Server] = []

    def start(folder: Path) -> Serving:
        serving = Serving(folder)
        serving.live.rebuild()
        servers.append(serving.server.__enter__())

        def follow() -> None:
            for changed in changes(folder):
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


def test_an_edited_page_is_shown_at_once(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    tab.goto(served.url)
    expect(tab.locator("main")).to_contain_text("The first text.")
    served.write("index.md", "# Welcome\n\nThe second text.\n")
    expect(tab.locator("main")).to_contain_text("The second text.", timeout=20_000)
    # What is about another page leaves this one alone.
    tab.evaluate("window.still = true")
    served.write("site.yaml", SITE.replace("The other page.", "Edited."))
    served.write("index.md", "# Welcome\n\nThe second text.\n")
    tab.wait_for_timeout(500)
    assert tab.evaluate("window.still")


def test_a_broken_edit_is_told_and_the_last_good_page_stays(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    tab.goto(served.url)
    served.write("site.yaml", SITE.replace("title: Other", "titel: Other"))
    problems = tab.get_by_role("alert")
    expect(problems).to_contain_text("did you mean 'title'?", timeout=20_000)
    expect(problems).to_contain_text("site.yaml:4: pages[1].titel: unknown key")
    expect(tab.locator("main")).to_contain_text("The first text.")
    assert "the pages are unchanged" in served.said.getvalue()
    # Also to who comes now.
    tab.goto(f"{served.url}other/")
    expect(tab.get_by_role("alert")).to_contain_text("unknown key")
    served.write("site.yaml", SITE)
    expect(tab.get_by_role("alert")).to_be_hidden(timeout=20_000)


def test_a_site_that_was_never_good_is_shown_when_it_is(
    browser: Browser, site: Path, serving: Callable[[Path], Serving]
) -> None:
    (site / "site.yaml").write_text("site: {}\n")
    served = serving(site)
    page = browser.new_page()
    page.goto(served.url)
    expect(page.get_by_role("alert")).to_contain_text("site.yaml:1: site.title: missing")
    served.write("site.yaml", SITE)
    expect(page.locator("main")).to_contain_text("The first text.", timeout=20_000)
    page.close()


def test_looks_change_without_loading_the_page_anew(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    shutil.copytree(ROOT / "themes/default", site / "themes/own")
    (site / "site.yaml").write_text(SITE.replace("My robot", "My robot, theme: own"))
    served = serving(site)
    tab.goto(served.url)
    tab.evaluate("window.still = true")
    css = site / "themes/own/style.css"
    css.write_text(css.read_text() + "\nmain { outline: 3px solid rgb(1, 2, 3); }\n")
    expect(tab.locator("main")).to_have_css("outline-color", "rgb(1, 2, 3)", timeout=20_000)
    assert tab.evaluate("window.still")


def test_only_the_node_that_changed_starts_again(
    tab: Page, tmp_path: Path, serving: Callable[[Path], Serving]
) -> None:
    site = tmp_path / "demo"
    shutil.copytree(ROOT / "demos/demo03", site, ignore=shutil.ignore_patterns("dist"))
    config = site / "site.yaml"
    config.write_text(config.read_text().replace("site:\n", "site:\n  asyncify: false\n"))
    # A page that shows its sources would change with them.
    (site / "page.md").write_text(PAGE)
    served = serving(site)
    tab.goto(served.url)
    talker, listener = Panel(tab, "talker"), Panel(tab, "listener")
    listener.start()
    talker.start()
    listener.wait_for("Hello, world!")
    before = listener.lines()[0]
    source = site / "src/cpp_pubsub/src/talker.cpp"
    source.write_text(source.read_text().replace("Hello, world!", "Good evening!"))
    expect(listener.console).to_contain_text("Good evening!", timeout=90_000)
    assert listener.lines()[0] == before
    listener.expect_state("running")


def test_a_port_in_use_is_left_to_who_has_it(site: Path) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with subprocess.Popen(
            [sys.executable, "-m", "sitegen", "serve", site, "--port", str(port)],
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | {"PYTHONUNBUFFERED": "1"},
        ) as process:
            assert process.stdout
            lines = []
            for line in process.stdout:
                lines.append(line)
                if "Ctrl-C" in line:
                    break
            assert f"port {port} is in use\n" in lines
            url = lines[-1].split()[0]
            assert url != f"http://localhost:{port}/"
            with urllib.request.urlopen(url) as page:
                assert b"The first text." in page.read()
            process.send_signal(signal.SIGINT)
            assert process.wait(10) == 0
    assert not (site / "dist").exists()


def test_nothing_outside_of_the_site_is_served(
    site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    for path in (
        "../site.yaml",
        "%2e%2e/site.yaml",
        "site.yaml",
        "_sitegen/server.py",
        "/etc/passwd",
    ):
        with pytest.raises(urllib.error.HTTPError, match="404"):
            urllib.request.urlopen(served.url + path)
    assert json.dumps(served.live.file("../site.yaml")) == "null"
