"""Python nodes that share an interpreter."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import Browser, Page, expect

from tests.site.test_offline import until

pytestmark = pytest.mark.own_server
SITE = SITES / "group"


@pytest.fixture
def page(browser: Browser, serve: Serve, built: Built) -> Page:
    page = browser.new_page()
    page.goto(serve(built(SITE)))
    return page


@pytest.mark.firefox
def test_each_node_of_a_group_is_a_program_of_its_own(page: Page) -> None:
    left, right = Panel(page, "left"), Panel(page, "right")
    left.start()
    right.start()
    for node, words, other in ((left, "['one']", "/right"), (right, "['two', 'words']", "/left")):
        node.wait_for(f"heard {other}")
        node.wait_for("same True")
        assert node.lines()[:2] == [f"calls 1 words {words}", "main True MainThread True"]
        assert sum("calls" in line for line in node.lines()) == 1
    if page.context.browser and page.context.browser.browser_type.name == "chromium":
        assert len(page.workers) == 1

    left.button("Stop").click()
    left.expect_state("failed")
    left.wait_for("interrupted False")
    assert left.lines()[-2:] == ["RuntimeError: over", "left: exited with code 1"]
    # The other one goes on, whichever it is and how often, and hears it when it is back.
    for _ in range(3):
        left.button("Clear").click()
        right.button("Clear").click()
        left.start()
        left.wait_for("same True")
        assert left.lines()[0].startswith("calls 1 words")
        right.expect_state("running")
        assert right.lines() == []
        right.button("Stop").click()
        right.expect_state("failed")
        left, right = right, left


def test_one_that_cannot_be_ended_takes_the_others_with_it(page: Page) -> None:
    left, stubborn = Panel(page, "left"), Panel(page, "stubborn")
    left.start()
    left.wait_for("main True")
    stubborn.start()
    stubborn.wait_for("computing")
    stubborn.stop()
    stubborn.wait_for("did not end within a second and was terminated")
    left.expect_state("failed")
    left.wait_for("it shared its interpreter with stubborn, which had to be terminated")
    left.start()
    expect(left.console.get_by_text("main True")).to_have_count(2)
    left.expect_state("running")


@pytest.mark.firefox
def test_one_that_computes_is_interrupted_when_another_has_ended(
    browser: Browser, serve: Serve, built: Built, tmp_path: Path
) -> None:
    folder = shutil.copytree(SITE, tmp_path / "site")
    config = folder / "site.yaml"
    config.write_text(config.read_text().replace("Group}", "Group, isolate: true}"))
    tab = browser.new_page()
    tab.goto(serve(built(folder)))
    until(tab, "() => crossOriginIsolated && document.readyState === 'complete'")
    elder, heir, right = (Panel(tab, name) for name in ("elder", "heir", "right"))
    for node, line in ((elder, "waiting"), (right, "main True"), (heir, "waiting")):
        node.start()
        node.wait_for(line)
    elder.stop()
    heir.wait_for("computing")
    # While it handles the interrupt, another one can end.
    right.button("Stop").click()
    right.wait_for("RuntimeError: over")
    heir.stop()
    assert heir.lines() == ["waiting", "computing", "interrupted"]
