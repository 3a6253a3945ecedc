"""Launch files of a small workspace, for tests."""

from __future__ import annotations

from pathlib import Path

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.launch import launched
from sitegen.model import Node

PACKAGE = "<package format='3'><name>{}</name><version>1.0.0</version></package>"


def nodes(root: Path, name: str, **arguments: str) -> tuple[list[Node], list[str]]:
    """Return the nodes that a launch file starts, and what is wrong with it."""
    problems = Problems(root)
    found = launched(root / name, arguments, workspace.scan(root), problems)
    return [*found.nodes], problems.lines
