"""C++ nodes of the page do what native rclpy does: the same scenarios print the same lines."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from native import Native
from paths import SITES
from playwright.sync_api import BrowserContext

from tests.native.test_rclpy import printed, run

SITE = SITES / "twins"


@pytest.fixture(scope="module")
def native() -> Native:
    return Native()


@pytest.mark.parametrize("scenario", ["parameters", "services", "actions", "policies", "times"])
def test_a_scenario_goes_as_it_does_natively(
    context: BrowserContext, serve: Serve, built: Built, native: Native, scenario: str
) -> None:
    page = context.new_page()
    page.goto(serve(built(SITE)))
    state, lines = run(page, scenario)
    assert printed(lines) == native.run(SITE / "native" / "play.py", scenario)
    assert state == "stopped", lines[-1]
