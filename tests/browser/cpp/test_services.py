"""Services between compiled nodes, with a definition of the workspace's own, in a real browser."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from panel import Panel, expect_nothing_left
from paths import SITES
from playwright.sync_api import BrowserContext

pytestmark = pytest.mark.firefox

SITE = SITES / "services"


def test_callers_get_their_own_answers(context: BrowserContext, serve: Serve, built: Built) -> None:
    page = context.new_page()
    page.goto(serve(built(SITE)))
    server, client, zero, callers = (
        Panel(page, name) for name in ("server", "client", "zero", "callers")
    )

    # The client comes first and finds the server later.
    client.start()
    client.wait_for("No service yet, waiting")
    server.start()
    client.wait_for("Quotient: 42")
    client.expect_state("stopped")

    zero.start()
    callers.start()
    zero.wait_for("Quotient: 0division by zero")
    callers.wait_for("ready")
    assert callers.messages() == [
        "right 200, wrong 0, 1.000000, removed 1 0, early 1, late 1: at last",
        "ready 0, answered 0",
    ]
    assert "84 / 2" in server.messages()

    # A server that is gone is no longer found; one that is back is.
    server.stop()
    client.button("Clear").click()
    client.start()
    client.wait_for("No service yet, waiting")
    server.start()
    client.wait_for("Quotient: 42")
    client.expect_state("stopped")
    server.stop()
    expect_nothing_left(page)


def test_a_program_may_serve_itself_and_use_the_interfaces_of_the_tutorials(
    context: BrowserContext, serve: Serve, built: Built
) -> None:
    page = context.new_page()
    page.goto(serve(built(SITE)))
    adder = Panel(page, "adder")
    adder.expect_state("stopped")
    adder.start()
    adder.wait_for("Sum: 42")
    adder.expect_state("stopped")
