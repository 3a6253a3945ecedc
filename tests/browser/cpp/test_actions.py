"""Actions of compiled nodes, which are components: alone, each in its program, and both in one."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from panel import Panel, Played, expect_nothing_left
from paths import SITES
from playwright.sync_api import BrowserContext

pytestmark = pytest.mark.firefox

SITE = SITES / "rclcpp"
CLIENT = [
    "accepted",
    "result 4 0 1 1 2 3 5 8 after feedback",
    "refused",
    "accepted",
    "result 6 0 1 ",
    "accepted",
    "canceling 1, 0",
    "result 5 after feedback",
    "none left: 0",
]
SERVER = [
    "asked for 6",
    "asked for 41",
    "asked for -1",
    "asked for 40",
    "asked to cancel",
    "canceled",
]


@pytest.mark.parametrize("first", ["server", "client"])
def test_goals_are_executed_refused_aborted_and_canceled(
    context: BrowserContext, serve: Serve, built: Built, first: str
) -> None:
    page = context.new_page()
    page.goto(f"{serve(built(SITE))}actions/")
    server, client = Panel(page, "fibonacci_server"), Panel(page, "fibonacci_client")
    both = (server, client) if first == "server" else (client, server)
    for panel in both:
        panel.start()
        panel.expect_started()
    client.expect_state("stopped")
    assert client.messages() == CLIENT
    server.wait_for("canceled")
    assert [one for one in server.messages() if not one.startswith("there is ")] == SERVER
    server.stop()
    expect_nothing_left(page)


def test_components_of_one_program_are_found_by_name(played: Played) -> None:
    composed = played(SITE, "actions", "composed")
    lines = [line for line in composed.lines() if "[shapes]: " not in line]
    factory = "Load rclcpp_components::NodeFactoryTemplate<components::Fibonacci{}>"
    assert lines[:4] == [
        factory.format("Client"),
        factory.format("Server"),
        "1",
        "Could not load library libnothing.so: this program is not linked with it",
    ]
    assert lines[4] == "round 13"
    assert [line for line in lines[5:] if not line.startswith("[")][:4] == [
        "loaded 1 /deep/spare",
        "Failed to find class with the requested plugin name.",
        "1 nodes, unloaded 1 ",
        "0 nodes, unloaded 0 No node found with unique_id: 1",
    ]
    said = [line.split("]: ")[1] for line in lines if "[fibonacci_client]: " in line]
    assert said == CLIENT


def test_components_of_a_launch_file_share_their_container(
    context: BrowserContext, serve: Serve, built: Built
) -> None:
    page = context.new_page()
    page.goto(f"{serve(built(SITE))}container/")
    both = Panel(page, "both")
    both.expect_state("stopped")
    lines = both.lines()
    assert [line.rpartition("::")[2] for line in lines if "Instantiate class" in line] == [
        "FibonacciServer>",
        "FibonacciClient>",
    ]
    said = [line.split("]: ")[1] for line in lines if "[deep.fibonacci_client]: " in line]
    assert said == CLIENT
    # Components find the plugins of their own package and of others.
    found = {line.split("]: ")[1] for line in lines if "[shapes]: " in line}
    assert found == {"there is components::Circle", "there is round", "there is square"}
