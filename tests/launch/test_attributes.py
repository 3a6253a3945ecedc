"""Nothing that an action of a launch file has is dropped: it works, is noted, or is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import nodes

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.launch import attributes, launched


@pytest.mark.parametrize(
    ("inside", "expected"),
    [
        (
            "<node pkg='p' exec='x' nmae='n'/>",
            "node: 'node' has no attribute 'nmae'; did you mean 'name'?",
        ),
        (
            "<node pkg='p' exec='x' namepsace='n'/>",
            "node: 'node' has no attribute 'namepsace'; did you mean 'namespace'?",
        ),
        (
            "<node pkg='p' exec='x'><param name='a' value='1' typ='int'/></node>",
            "node: 'param' has no attribute 'typ'; did you mean 'type'?",
        ),
        (
            "<node pkg='p' exec='x'><remap from='a' too='b'/></node>",
            "node: 'remap' has no attribute 'too'; did you mean 'to'?",
        ),
        (
            "<node pkg='p' exec='x'><parma name='a' value='1'/></node>",
            "node: 'node' has no 'parma' inside; did you mean 'param'?",
        ),
        ("<let name='a' value='b'><arg/></let>", "let: 'let' has no 'arg' inside; remove it"),
        (
            "<group scope='false'/>",
            "group: 'group' has no attribute 'scope'; did you mean 'scoped'?",
        ),
        (
            "<arg name='a' default='1'><choice value='2'/><choice value='3'/></arg>",
            "arg: 'a' is '1', but must be one of: 2, 3",
        ),
        (
            "<node pkg='p' exec='x'><param name='a' value='1' type='double'/></node>",
            "node: 'double' is not a type of parameters; ",
        ),
    ],
)
def test_what_ros_refuses_is_refused(root: Path, inside: str, expected: str) -> None:
    (root / "x.launch.xml").write_text(f"<launch>\n{inside}\n</launch>")
    _, wrong = nodes(root, "x.launch.xml")
    assert len(wrong) == 1
    assert wrong[0].startswith(f"x.launch.xml:2: {expected}")


def test_the_same_in_yaml_and_python(root: Path) -> None:
    (root / "x.launch.yaml").write_text("launch:\n- node: {pkg: p, exec: x, nmae: n}\n")
    _, wrong = nodes(root, "x.launch.yaml")
    assert wrong == ["x.launch.yaml:2: node: 'node' has no attribute 'nmae'; did you mean 'name'?"]
    (root / "x.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='p', executable='x', nmae='n')])\n"
    )
    _, wrong = nodes(root, "x.launch.py")
    assert wrong == [
        "x.launch.py:4: launch: TypeError: Node() got an unexpected keyword argument 'nmae'"
    ]


def test_errors_about_arguments_have_the_names_of_launch_files(root: Path) -> None:
    (root / "x.launch.py").write_text(
        "from launch_ros.descriptions import ComposableNode\n"
        "def generate_launch_description():\n"
        "    return ComposableNode(package='p', node_plugin='p::Part')\n"
    )
    _, [wrong] = nodes(root, "x.launch.py")
    assert wrong == (
        "x.launch.py:3: launch: TypeError: ComposableNode() missing 1 required keyword-only "
        "argument: 'plugin'"
    )


IGNORED = {
    "xml": """<launch>
<shutdown reason="done"/>
<node pkg="p" exec="x" launch-prefix="gdb" output="screen" cwd="node"/></launch>
""",
    "py": """from launch import LaunchDescription
from launch.actions import Shutdown
from launch_ros.actions import Node
def generate_launch_description():
    return LaunchDescription([
        Shutdown(reason="done"),
        Node(package="p", executable="x", prefix="gdb", output="screen",
             cwd="/tmp")])
""",
}


@pytest.mark.parametrize("kind", IGNORED)
def test_what_is_ignored_is_noted(root: Path, kind: str) -> None:
    (root / f"x.launch.{kind}").write_text(IGNORED[kind])
    problems, notes = Problems(root), Problems(root)
    file = root / f"x.launch.{kind}"
    assert len(launched(file, {}, workspace.scan(root), problems, notes).nodes) == 1
    assert problems.lines == []
    assert sorted(line.partition(": ")[2].split(" ignored")[0] for line in notes.lines) == [
        "node: 'cwd' is",
        "node: 'launch-prefix' is",
        "shutdown: skipped: the nodes of the page would stop at once",
    ]


GROUPS = {
    "xml": """<launch>
      <let name="side" value="none"/><let name="speed" value="5"/>
      <group><keep name="side" value="left"/>
        <node pkg="p" exec="x" name="arm_$(var side)"><param name="s" value="$(var speed)"/></node>
      </group>
      <group scoped="true" forwarding="false">
        <keep name="side" value="right"/><arg name="speed" default="1"/>
        <node pkg="p" exec="x" name="arm_$(var side)"><param name="s" value="$(var speed)"/></node>
      </group>
      <node pkg="p" exec="x" name="base_$(var side)"/></launch>""",
    "py": """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, SetLaunchConfiguration
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def arm():
    return Node(package="p", executable="x", name=["arm_", LaunchConfiguration("side")],
                parameters=[{"s": LaunchConfiguration("speed")}])

def generate_launch_description():
    return LaunchDescription([
        SetLaunchConfiguration("side", "none"), SetLaunchConfiguration("speed", "5"),
        GroupAction([arm()], launch_configurations={"side": "left"}),
        GroupAction([DeclareLaunchArgument("speed", default_value="1"), arm()],
                    forwarding=False, launch_configurations={"side": "right"}),
        Node(package="p", executable="x", name=["base_", LaunchConfiguration("side")])])
""",
}


@pytest.mark.parametrize("kind", GROUPS)
def test_a_group_sets_arguments_and_may_forward_none(root: Path, kind: str) -> None:
    (root / f"x.launch.{kind}").write_text(GROUPS[kind])
    found, wrong = nodes(root, f"x.launch.{kind}")
    assert wrong == []
    assert {node.name: node.parameters for node in found} == {
        "arm_left": {"s": "5"},
        "arm_right": {"s": "1"},
        "base_none": {},
    }


def test_files_may_give_parameters_to_all_nodes(root: Path) -> None:
    (root / "p.yaml").write_text("/**:\n  ros__parameters: {rate: 5, name: all}\n")
    (root / "x.launch.xml").write_text(
        "<launch><set_parameters_from_file filename='$(dirname)/p.yaml'/>"
        "<node pkg='p' exec='x'><param name='rate' value='7'/></node></launch>"
    )
    [node], wrong = nodes(root, "x.launch.xml")
    assert wrong == []
    assert node.parameters == {"rate": "7", "name": "'all'"}


def test_the_parts_of_actions_are_known() -> None:
    assert {*attributes.OF} <= {*attributes.KNOWN, *attributes.PARTS}
    assert {part for parts in attributes.OF.values() for part in parts} <= {*attributes.PARTS}
