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
    page = context.new_page()
    page.goto(serve(built(SITE)))
    panel = Panel(page, node)
    panel.expect_state("stopped")
    assert panel.lines() == expected


def test_a_node_with_an_environment_of_its_own(
    context: BrowserContext, serve: Serve, built: Built
) -> None:
    page = context.new_page()
    page.goto(serve(built(SITE)))
    panel = Panel(page, "alone")
    panel.expect_state("stopped")
    *variables, logged = panel.lines()
    assert variables == ["TEAM (unset)", "LANE 5", "DATA (unset)", *ROS]
    # The format of log messages is a variable, too.
    assert logged.startswith("[WARN] [")


@pytest.mark.parametrize("node", ["one", "one_py"])
def test_the_same_in_xml(context: BrowserContext, serve: Serve, built: Built, node: str) -> None:
    page = context.new_page()
    page.goto(f"{serve(built(SITE))}xml/")
    panel = Panel(page, node)
    panel.expect_state("stopped")
    assert panel.lines()[:2] == ["TEAM blue", "LANE blue 4"]
    assert panel.lines()[-1].endswith(f"[{node}]: hello")
