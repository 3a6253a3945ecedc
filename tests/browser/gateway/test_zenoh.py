"""A page of one gateway and a robot of another one, which are joined over Zenoh."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import gateways
import pytest
from browser import Built
from joined import Robot
from paths import SITES
from playwright.sync_api import Browser, Page, expect
from station import state, use_each_other

SITE = SITES / "gateway"


@pytest.fixture
def elsewhere(browser: Browser, robot: Robot, built: Built, tmp_path: Path) -> Iterator[Page]:
    """The same page of a gateway that is in another graph, and has joined that of the robot."""
    assert robot
    port = str(gateways.free_port())
    far: list[str | Path] = [
        "--zenoh",
        f"localhost:{port}",
        "--zenoh-port",
        "0",
        "--site",
        built(SITE),
    ]
    with (
        gateways.gateway("--zenoh", "--zenoh-port", port, folder=tmp_path),
        gateways.gateway(*far, folder=tmp_path, apart=True) as running,
        browser.new_context() as context,
    ):
        tab = context.new_page()
        tab.goto(running.url.replace("ws:", "http:"))
        expect(state(tab)).to_contain_text("Connected to")
        expect(tab.locator(".ros-connect")).to_contain_text("/robot")
        tab.get_by_role("button", name="Start", exact=True).first.click()
        yield tab


def test_they_are_one_graph_through_two_gateways(elsewhere: Page, robot: Robot) -> None:
    use_each_other(elsewhere, robot)
