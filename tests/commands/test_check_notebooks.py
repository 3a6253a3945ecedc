"""What `sitegen check` says of the cells of a site: imports, types and topics."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from paths import ROOT

from sitegen.commands.check import check
from sitegen.report import Report

LAB = """\
site: {title: Lab}
nodes:
  listener: {package: py, executable: listener}
pages:
  - path: lab/
    title: Lab
    content:
      - jupyter: {notebooks: notebooks}
      - console: listener
"""
LISTENER = """\
import rclpy
from std_msgs.msg import String

def main():
    rclpy.init()
    node = rclpy.create_node("listener")
    node.create_subscription(String, "/chatter", print, 10)
    rclpy.spin(node)
"""
SETUP = """\
from setuptools import setup
setup(name="py", packages=["py"], entry_points={
    "console_scripts": ["listener = py.listener:main"]})
"""


def write(folder: Path, *cells: str, site: str = LAB) -> Path:
    package = (
        "<package><name>py</name><export><build_type>ament_python</build_type></export></package>"
    )
    notebook = {
        "nbformat": 4,
        "cells": [{"cell_type": "code", "source": c.splitlines(keepends=True)} for c in cells],
    }
    files = {
        "site.yaml": site,
        "src/py/package.xml": package,
        "src/py/setup.py": SETUP,
        "src/py/py/__init__.py": "",
        "src/py/py/listener.py": LISTENER,
        "notebooks/a.ipynb": json.dumps(notebook, indent=1),
        "guide.md": "# Guide\n\n" + "\n\n".join(f"```python\n{cell}\n```" for cell in cells),
    }
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return folder


def warnings(folder: Path) -> list[str]:
    return check(folder, Report())[1]


GOOD = """\
%matplotlib inline
!ls
import os, IPython, jupyros, rclpy
import py.listener
from std_msgs.msg import String
from example_interfaces.srv import AddTwoInts
await rclpy.something()
"""


def test_nothing_is_said_of_what_is_right(tmp_path: Path) -> None:
    cells = [
        GOOD,
        "%%bash\nimport nothing_here",
        "rclpy.init()\nnode = rclpy.create_node('a')",
        "out = node.create_publisher(String, 'chatter', 10)",
        "try:\n    import numpy\nexcept ImportError:\n    pass",
    ]
    assert warnings(write(tmp_path, *cells)) == []


@pytest.mark.parametrize(
    ("cell", "message"),
    [
        ("x = 1\nimport requests", "import requests: module 'requests' is not available in the"),
        ("from numpy import zeros", "'numpy' needs a build for Pyodide"),
        ("from std_msgs.msg import Strin", "no type 'std_msgs/msg/Strin'; did you mean"),
        ("from st_msgs.msg import String", "no package 'st_msgs' with interfaces; did you mean"),
        (
            "node.create_subscription(String, '/chater', print, 10)",
            "this cell subscribes to '/chater' on page /lab/, which has no publisher",
        ),
        (
            "from std_msgs.msg import Int8\nnode.create_publisher(Int8, '/chatter', 10)",
            "'/chatter' is std_msgs/msg/String for 'listener', but std_msgs/msg/Int8 for this cell",
        ),
    ],
)
def test_what_is_wrong_is_said_with_its_line(tmp_path: Path, cell: str, message: str) -> None:
    folder = write(tmp_path, "import rclpy\nnode = rclpy.create_node('a')", cell)
    found = [line for line in warnings(folder) if message in line]
    assert found, warnings(folder)
    name, number, *_ = found[0].split(":")
    if name.endswith(".ipynb"):
        written = (folder / name).read_text().splitlines()[int(number) - 1]
        assert any(line and line in written.replace('\\"', '"') for line in cell.splitlines())
        assert name == "notebooks/a.ipynb"


def test_cells_of_a_page_are_read_too(tmp_path: Path) -> None:
    site = "site: {title: A}\npages: [{path: /, title: A, content: [{notebook: guide.md}]}]\n"
    [line] = warnings(write(tmp_path, "import os", "import requests", site=site))
    assert line.startswith("guide.md:8: import requests: module 'requests' is not available")


def test_what_ipython_brings_is_not_in_the_cells_of_a_page(tmp_path: Path) -> None:
    site = "site: {title: A}\npages: [{path: /, title: A, content: [{notebook: guide.md}]}]\n"
    [line] = warnings(write(tmp_path, "import IPython", site=site))
    assert "module 'IPython' is not available" in line


def test_the_demo_is_right() -> None:
    assert warnings(ROOT / "demos/demo13") == []
