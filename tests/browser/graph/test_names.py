"""Programs of a workspace that use the names of each other's nodes, as many packages do."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from browser import Serve
from playwright.sync_api import Page

from sitegen.commands.build import build
from sitegen.report import Report

PROGRAM = """\
import rclpy
from std_msgs.msg import String

def main():
    rclpy.init()
    node = rclpy.create_node("listener")
    publisher = node.create_publisher(String, "/heard", 1)
    node.create_timer(0.1, lambda: publisher.publish(String(data="{}")))
    rclpy.spin(node)
"""
SITE = """\
site: {title: Names}
workspace: .
nodes:
  listener: {package: names, executable: listener}
  best_effort: {package: names, executable: best_effort}
  shell: {package: sitegen, executable: prompt}
pages:
  - {path: /, title: Names, content: [console: listener, console: best_effort, topics: ]}
  - path: edited/
    title: Edited
    content: [console: listener, editor: {node: best_effort}, console: best_effort, prompt: shell]
"""
# Both nodes run, and both are heard.
BOTH = """async () => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  const late = new Promise((_, reject) => setTimeout(reject, 60_000, new Error("late")));
  const texts = new Set();
  const both = new Promise((resolve) => {
    ros.subscribe("/heard", "std_msgs/msg/String", ({ data }) => {
      if (texts.add(data).size === 2) resolve();
    });
  });
  for (const node of ros.nodes.values()) node.start();
  await Promise.race([both, late]);
  return [[...texts].sort(), ros.graph.nodes().filter((name) => name === "/listener")];
}"""
# The second one is refused beside the first.
REFUSED = """async () => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  const node = ros.nodes.get("best_effort");
  const late = new Promise((_, reject) => setTimeout(reject, 60_000, new Error("late")));
  const refused = new Promise((resolve) => node.addEventListener("lines", ({ detail }) => {
    for (const line of detail) if (line.text.includes("another node")) resolve(line.text);
  }));
  ros.nodes.get("listener").start();
  node.start();
  return await Promise.race([refused, late]);
}"""


@pytest.fixture
def dist(tmp_path: Path) -> Path:
    package = tmp_path / "src/names"
    (package / "names").mkdir(parents=True)
    (package / "package.xml").write_text(
        "<package format='3'><name>names</name><depend>rclpy</depend>"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    scripts = ["listener", "best_effort"]
    points = ", ".join(f"'{name} = names.{name}:main'" for name in scripts)
    (package / "setup.py").write_text(
        "from setuptools import setup\n"
        f"setup(name='names', packages=['names'], entry_points={{'console_scripts': [{points}]}})\n"
    )
    (package / "names/__init__.py").touch()
    for name in scripts:
        (package / f"names/{name}.py").write_text(PROGRAM.format(name))
    (tmp_path / "site.yaml").write_text(SITE)
    build(tmp_path, output=tmp_path / "dist", report=Report())
    return tmp_path / "dist"


def test_they_may_have_the_same_name(tab: Page, serve: Serve, dist: Path) -> None:
    tab.goto(serve(dist))
    found: Any = tab.evaluate(BOTH)
    assert found == [["best_effort", "listener"], ["/listener", "/listener"]]


def test_a_program_that_visitors_can_edit_may_not(tab: Page, serve: Serve, dist: Path) -> None:
    nodes = json.loads((dist / "edited/page.json").read_text())["nodes"]
    foreign = {name: node.get("foreign", False) for name, node in nodes.items()}
    assert foreign == {"listener": False, "best_effort": True, "shell": True}
    tab.goto(f"{serve(dist)}edited/")
    assert tab.evaluate(REFUSED) == (
        "best_effort: announced a node with the name of another node, /listener; it was dropped"
    )
