"""What `sitegen init` writes for the packages of two demos, built and used in a browser."""

from __future__ import annotations

import shutil
from pathlib import Path

from browser import Serve
from panel import Panel
from paths import ROOT
from playwright.sync_api import Page, expect

from sitegen.__main__ import main


def test_its_pages_run(tmp_path: Path, serve: Serve, tab: Page) -> None:
    for demo in ("demo05", "demo09"):
        shutil.copytree(ROOT / "demos" / demo / "src", tmp_path / "src", dirs_exist_ok=True)
    shutil.rmtree(tmp_path / "src/cpp_chatter")
    assert main(["init", str(tmp_path)]) == 0
    assert main(["check", "--strict", str(tmp_path)]) == 0
    assert main(["build", str(tmp_path)]) == 0
    url = serve(tmp_path / "dist")

    tab.goto(url)
    tab.get_by_role("main").get_by_role("listitem").filter(has_text="A server").click()
    client = Panel(tab, "client")
    expect(tab.locator("main")).to_contain_text("auto client = node->create_client")
    client.start()
    # It says what it waits for, and offers to start it.
    client.panel.get_by_role("button", name="Start server first").click()
    client.wait_for("Sum: 3")

    tab.goto(f"{url}py_artist/")
    Panel(tab, "turtlesim").start()
    topics = tab.get_by_role("region", name="Topics")
    topics.scroll_into_view_if_needed()
    expect(topics).to_contain_text("theta: 0.0")
