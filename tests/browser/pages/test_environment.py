"""Nodes of a page have the environment variables that their launch file sets."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import BrowserContext

pytestmark = pytest.mark.firefox

SITE = SITES / "environment"
ROS = ["ROS_DISTRO kilted", "ROS_VERSION 2"]
DATA = "DATA /ros/share/bringup/data"


def told(context: BrowserContext, url: str, node: str) -> list[str]:
    """The lines of a node that starts with its page and ends by itself."""
    page = context.new_page()
    page.goto(url)
    panel = Panel(page, node)
    panel.expect_state("stopped")
    return panel.lines()


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        # C++ programs do not tell the page where they log.
        ("one", ["TEAM blue", "LANE ü 4", DATA, "<one> WARN hello {no}\t:"]),
        ("one_py", ["TEAM blue", "LANE ü 4", DATA, *ROS, "<one_py> WARN hello {no}\tmain:14"]),
        ("of_blue", ["TEAM blue", "LANE (unset)", DATA, "<of_blue> WARN hello {no}\t:"]),
    ],
)
def test_variables_for_all_nodes_and_for_one(
    context: BrowserContext, serve: Serve, built: Built, node: str, expected: list[str]
) -> None:
    assert told(context, serve(built(SITE)), node) == expected


def test_a_node_with_an_environment_of_its_own(
    context: BrowserContext, serve: Serve, built: Built
) -> None:
    *variables, logged = told(context, serve(built(SITE)), "alone")
    assert variables == ["TEAM (unset)", "LANE 5", "DATA (unset)", *ROS]
    # The format of log messages is a variable, too.
    assert logged.startswith("[WARN] [")


@pytest.mark.parametrize("node", ["one", "one_py"])
def test_the_same_in_xml(context: BrowserContext, serve: Serve, built: Built, node: str) -> None:
    lines = told(context, f"{serve(built(SITE))}xml/", node)
    assert lines[:2] == ["TEAM blue", "LANE blue 4"]
    assert lines[-1].endswith(f"[{node}]: hello")
