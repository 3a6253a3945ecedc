"""The file of a description as the argument of robot_state_publisher, as it was in ROS."""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import PACKAGE, nodes

from sitegen import rclyaml

LAUNCH = """\
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher" args="{args}">{inside}</node>
</launch>
"""
PARAMETER = "<param name='robot_description' value='given' type='str'/>"
ROBOT = "<robot name='{}'><link name='base'/></robot>"


@pytest.fixture
def root(tmp_path: Path) -> Path:
    files = {
        "src/fox/package.xml": PACKAGE.format("fox"),
        "src/fox/CMakeLists.txt": "project(fox)",
        "src/fox/fox.urdf": ROBOT.format("fox"),
        "src/fox/fox.urdf.xacro": ROBOT.format("$(find fox)").replace(
            "<robot", "<robot xmlns:xacro='http://ros.org/wiki/xacro'"
        ),
    }
    for name, text in files.items():
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return tmp_path


@pytest.mark.parametrize(
    ("args", "inside", "description", "rest"),
    [
        ("$(find-pkg-share fox)/fox.urdf", "", "<robot name='fox'>", ()),
        ("$(find-pkg-share fox)/fox.urdf more", "", "<robot name='fox'>", ("more",)),
        ("$(find-pkg-share fox)/fox.urdf.xacro", "", 'name="/ros/share/fox"', ()),
        # The parameter counts, and no other word is a file.
        ("$(find-pkg-share fox)/fox.urdf", PARAMETER, "given", ("/ros/share/fox/fox.urdf",)),
        ("--option", PARAMETER, "given", ("--option",)),
    ],
)
def test_descriptions(
    root: Path, args: str, inside: str, description: str, rest: tuple[str, ...]
) -> None:
    (root / "x.launch.xml").write_text(LAUNCH.format(args=args, inside=inside))
    [node], wrong = nodes(root, "x.launch.xml")
    assert wrong == []
    assert node.arguments == rest
    assert description in str(rclyaml.value(node.parameters["robot_description"]))


def test_a_file_that_is_elsewhere_is_not_published(root: Path) -> None:
    elsewhere = root.parent / "elsewhere.urdf"
    elsewhere.write_text(ROBOT.format("secret"))
    (root / "x.launch.xml").write_text(LAUNCH.format(args=elsewhere, inside=""))
    assert nodes(root, "x.launch.xml") == (
        [],
        [f"x.launch.xml:2: node: '{elsewhere}' is outside the workspace"],
    )
