"""A node that needs another one says so, and starts it."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import show


@pytest.fixture(params=["buttons", "prompt", "editor"])
def star(request: pytest.FixtureRequest, stage: Tab) -> Tab:
    """The widget of a node that needs two others."""
    stage.evaluate(
        """() => {
          const names = ["star", "turtlesim", "map"];
          window.nodes = names.map((name) => ros.addNode(name, "package", name));
          nodes[0].needs = ["turtlesim", "map"];
          for (const node of nodes) node.start = () => node.become("starting");
        }"""
    )
    show(stage, request.param, {"node": "star", "file": "star.py", "place": "", "text": ""})
    return stage


def test_a_node_without_what_it_needs_says_so_and_starts_it(star: Tab) -> None:
    note = star.locator(".ros-needs")
    expect(note).to_be_attached()
    expect(note).to_be_empty()
    star.evaluate("nodes[0].become('starting')")
    expect(note).to_contain_text("star needs turtlesim, map.")
    note.get_by_role("button", name="Start turtlesim first").click()
    expect(note).to_contain_text("star needs map.")
    assert star.evaluate("nodes[1].state") == "starting"
    note.get_by_role("button", name="Start map first").click()
    expect(note).to_be_empty()
    # What ends meanwhile is needed again; a node that was stopped needs nothing.
    star.evaluate("nodes[1].become('failed')")
    expect(note).to_contain_text("star needs turtlesim.")
    star.evaluate("nodes[0].become('failed')")
    expect(note).to_contain_text("star needs turtlesim.")
    star.evaluate("nodes[0].become('stopped')")
    expect(note).to_be_empty()
