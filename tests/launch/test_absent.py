"""Packages that a launch file names and the workspace lacks: what needs them is left out."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from launching import PACKAGE

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.launch import LaunchDescription, launched
from sitegen.launch.again import read_again
from sitegen.model import Container

CLONE = "clone its sources there: git clone -b ros2 https://github.com/ros-drivers/"
ERROR = f"needs package 'joy', which is not in the workspace; {CLONE}joystick_drivers.git"
JOY = f"{ERROR} (left out)"
BEGIN = """
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from launch import LaunchDescription
from launch.actions import *
from launch.event_handlers import OnProcessStart
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


"""
FILES = {
    "xml": """<launch>
  <node pkg="joy" exec="joy_node"/>
  <include file="$(find-pkg-share joy)/launch/joy.launch.xml"><arg name="a" value="b"/></include>
  <node pkg="mine" exec="x"/>
</launch>""",
    "py": BEGIN
    + """def generate_launch_description():
    folder = get_package_share_directory("joy")
    joy = Node(package="joy", executable="joy_node")
    return LaunchDescription([
        joy,
        IncludeLaunchDescription(PythonLaunchDescriptionSource(folder + "/launch/joy.launch.py")),
        RegisterEventHandler(OnProcessStart(
            target_action=joy, on_start=[Node(package="mine", executable="x")])),
    ])
""",
}


def read(root: Path, name: str, text: str) -> tuple[LaunchDescription, list[str], list[str]]:
    (root / name).write_text(text)
    problems, notes = Problems(root), Problems(root)
    found = launched(root / name, {}, workspace.scan(root), problems, notes)
    return found, problems.lines, notes.lines


@pytest.mark.parametrize(("kind", "lines"), [("xml", (2, 3)), ("py", (13, 16))])
def test_nodes_and_files_of_packages_of_ros_are_left_out(
    root: Path, kind: str, lines: tuple[int, int]
) -> None:
    name = f"x.launch.{kind}"
    found, problems, notes = read(root, name, FILES[kind])
    assert problems == []
    assert [node.executable for node in found.nodes] == ["x"]
    assert notes == [f"{name}:{lines[0]}: node: {JOY}", f"{name}:{lines[1]}: include: {JOY}"]


def test_a_file_that_handles_the_exception_gets_it(root: Path) -> None:
    text = (
        BEGIN
        + """def generate_launch_description():
    try:
        get_package_share_directory("joy")
        name = "there"
    except PackageNotFoundError:
        name = "absent"
    return LaunchDescription([Node(package="mine", executable=name)])
"""
    )
    found, problems, notes = read(root, "x.launch.py", text)
    assert (problems, notes) == ([], [])
    assert [node.executable for node in found.nodes] == ["absent"]


@pytest.mark.parametrize(
    ("body", "line"),
    [
        ("open(get_package_share_directory('joy') + '/joy.yaml')", "12: launch: "),
        ("import joy.names", "12: launch: "),
        (
            "return LaunchDescription([Node(package='mine', executable='x', "
            "parameters=[get_package_share_directory('joy') + '/joy.yaml'])])",
            "12: node: ",
        ),
    ],
)
def test_what_cannot_go_on_without_a_package_names_it(root: Path, body: str, line: str) -> None:
    text = f"{BEGIN}def generate_launch_description():\n    {body}\n"
    found, problems, _ = read(root, "x.launch.py", text)
    assert found.nodes == []
    assert problems == [f"x.launch.py:{line}{ERROR}"]


@pytest.mark.parametrize(
    ("components", "expected"), [("joy mine", ["mine"]), ("joy", None), ("mine", ["mine"])]
)
def test_components_are_left_out_and_containers_of_only_these(
    root: Path, components: str, expected: list[str] | None
) -> None:
    inside = "".join(
        f"<composable_node pkg='{each}' plugin='{each}::A' name='a'/>"
        for each in components.split()
    )
    found, problems, notes = read(
        root,
        "x.launch.xml",
        "<launch><node_container pkg='rclcpp_components' exec='component_container' name='c' "
        f"namespace=''>{inside}</node_container></launch>",
    )
    assert problems == []
    kinds = [node.kind for node in found.nodes]
    loaded = [[c.package for c in kind.components] for kind in kinds if isinstance(kind, Container)]
    assert (len(kinds), loaded) == ((1, [expected]) if expected else (0, []))
    assert notes == ([f"x.launch.xml:1: composable_node: {JOY}"] if "joy" in components else [])


def test_a_package_of_the_workspace_takes_precedence(root: Path) -> None:
    folder = root / "src" / "joy"
    (folder / "launch").mkdir(parents=True)
    (folder / "package.xml").write_text(PACKAGE.format("joy"))
    (folder / "launch" / "joy.launch.xml").write_text("<launch><arg name='a'/></launch>")
    found, problems, notes = read(root, "x.launch.xml", FILES["xml"])
    assert (problems, notes) == ([], [])
    assert [node.package for node in found.nodes] == ["joy", "mine"]


def test_what_no_page_can_have_is_not_cloned(root: Path) -> None:
    text = "<launch><include file='$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py'/></launch>"
    _, problems, notes = read(root, "x.launch.xml", text)
    assert problems == []
    why = "needs 'ros_gz_sim', which has no build for the page (left out)"
    assert notes == [f"x.launch.xml:1: include: {why}"]


def test_a_page_says_which_other_error_a_file_has(root: Path) -> None:
    share = root / "share"
    (share / "mine").mkdir(parents=True)
    (share / "mine" / "x.launch.py").write_text("1 / 0\n")
    found = json.loads(read_again("mine/x.launch.py", "{}", "{}", share))
    [line] = found["problems"]
    assert line.endswith("launch: ZeroDivisionError: division by zero")


def test_a_page_leaves_out_the_same(root: Path) -> None:
    share = root / "share"
    (share / "mine").mkdir(parents=True)
    (share / "mine" / "x.launch.xml").write_text(FILES["xml"])
    found = json.loads(read_again("mine/x.launch.xml", "{}", "{}", share))
    assert [node["executable"] for node in found["nodes"]] == ["x"]
    assert found["problems"] == []
    note = "needs package 'joy', which is not on this page (left out)"
    assert [line.split(": ", 2)[2] for line in found["notes"]] == [note, note]
