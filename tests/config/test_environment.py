"""The environment variables that site.yaml gives to nodes and to launch files."""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import PACKAGE

from sitegen.config import load
from sitegen.errors import SiteError

FILES = {
    "src/mine/package.xml": PACKAGE.format("mine"),
    "src/mine/CMakeLists.txt": "add_executable(talk a.cpp)",
    "a.launch.xml": """\
<launch>
  <node pkg="mine" exec="talk" name="first" args="$(env MODEL)"/>
  <set_env name="MODEL" value="cat"/>
  <node pkg="mine" exec="talk" name="second" args="$(env MODEL)"><env name="X" value="y"/></node>
  <reset_env/>
  <node pkg="mine" exec="talk" name="third" args="$(env MODEL)"/>
  <group forwarding="false">
    <node pkg="mine" exec="talk" name="fourth" args="$(env MODEL)"/>
  </group>
</launch>
""",
    "b.launch.py": """\
import os

from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch_ros.actions import Node

MODEL = os.environ["MODEL"]


def later(context):
    return [Node(package="mine", executable="talk", name="later", arguments=[os.environ["MODEL"]])]


def generate_launch_description():
    first = Node(package="mine", executable="talk", name="py", arguments=[MODEL])
    return LaunchDescription([first, OpaqueFunction(function=later)])
""",
}
SITE = """\
site: {title: A}
nodes:
  own: {package: mine, executable: talk, environment: {LANG: C, SIZE: "1"}}
pages:
  - {path: /, title: A, launch: a.launch.xml, environment: {MODEL: fox}}
  - {path: b/, title: B, launch: b.launch.py, environment: {MODEL: fox}}
  - {path: c/, title: C, content: [console: own]}
"""


def write(folder: Path, site: str) -> Path:
    for name, text in {**FILES, "site.yaml": site}.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return folder / "site.yaml"


def test_launch_files_read_the_environment_of_their_page(tmp_path: Path) -> None:
    pages = load(write(tmp_path, SITE)).pages
    nodes = {name: node for page in pages for name, node in page.nodes.items()}
    found = {name: (node.arguments, dict(node.environment)) for name, node in nodes.items()}
    assert found == {
        "first": (("fox",), {"MODEL": "fox"}),
        "second": (("cat",), {"MODEL": "cat", "X": "y"}),
        "third": (("fox",), {"MODEL": "fox"}),
        "fourth": (("fox",), {"MODEL": "fox"}),
        "py": (("fox",), {"MODEL": "fox"}),
        "later": (("fox",), {"MODEL": "fox"}),
        "own": ((), {"LANG": "C", "SIZE": "1"}),
    }
    assert pages[0].launch
    assert pages[0].launch.environment == {"MODEL": "fox"}


def test_what_is_not_set_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("MODEL", raising=False)
    site = SITE.replace(", environment: {MODEL: fox}", "")
    site += "  - {path: d/, title: D, environment: {A: b}, content: [console: own]}\n"
    with pytest.raises(SiteError) as caught:
        load(write(tmp_path, site))
    unread = (
        "node: environment variable 'MODEL' is not read, because the page would publish its value; "
        "set it in 'environment' of the page, or use a default: $(env MODEL …)"
    )
    assert caught.value.lines == [
        *(f"a.launch.xml:{line}: {unread}" for line in (2, 6, 8)),
        "b.launch.py:7: launch: environment variable 'MODEL' is not set; set it in 'environment' "
        "of the page",
        "site.yaml:8: pages[3].environment: needs 'launch'; a node has an 'environment' of its own",
    ]
