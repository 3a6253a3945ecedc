"""Launch files: the nodes that they start, in XML, YAML and Python."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Built, Serve
from launching import PACKAGE, nodes
from panel import Panel
from paths import SITES
from playwright.sync_api import Page

from sitegen.model import Container

SITE = SITES / "launch"


@pytest.mark.parametrize("kind", ["xml", "py"])
def test_nodes_are_those_that_ros_would_start(kind: str) -> None:
    found, wrong = nodes(SITE, f"src/bringup/launch/all.launch.{kind}", team="blue")
    assert wrong == []
    assert {node.name: " ".join(node.command_line()) for node in found} == {
        "first": "--mood very good --ros-args -r __node:=first -r chatter:=/shared "
        "-p greeting:='Hello blue' -p limits.top:=2.5",
        "second": "--ros-args -r __node:=second -r __ns:=/blue/left -p number:=7 "
        "-p everybody:=true -p greeting:='it''s me' -p limits.top:=3.0 "
        "-p limits.low:=[1.0, 2.0]",
        "blue_fan": "--ros-args -r __node:=blue_fan -r chatter:=other -r __ns:=/blue/deep "
        "-p number:=7 -p list:=[1, 2] -p flag:=true",
        "last": "--ros-args -r __node:=last -r __ns:=/blue -p number:=7",
        "speak": "",
    }
    assert {node.package for node in found} == {"speaker"}
    loud, _ = nodes(SITE, f"src/bringup/launch/all.launch.{kind}", team="red", loud="True")
    assert [node.name for node in loud][-1] == "third"


CONTAINERS = {
    "xml": """<launch>
      <push_ros_namespace namespace="robot"/>
      <node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">
        <composable_node pkg="parts" plugin="parts::Eye" name="eye">
          <remap from="image" to="/image"/>
          <param name="rate" value="5"/>
        </composable_node>
      </node_container>
      <load_composable_node target="/robot/box">
        <composable_node pkg="parts" plugin="parts::Ear" namespace="/head" if="true"/>
        <composable_node pkg="parts" plugin="parts::Nose" if="false"/>
      </load_composable_node>
    </launch>""",
    "yaml": """
launch:
  - push_ros_namespace: {namespace: robot}
  - node: {pkg: rclcpp_components, exec: component_container, name: box}
  - load_composable_node:
      target: /robot/box
      composable_node:
        - pkg: parts
          plugin: parts::Eye
          name: eye
          remap: [{from: image, to: /image}]
          param: [{name: rate, value: 5}]
          extra_arg: [{name: use_intra_process_comms, value: true}]
        - {pkg: parts, plugin: "parts::Ear", namespace: /head}
""",
    "py": """
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes, PushRosNamespace
from launch_ros.descriptions import ComposableNode

def generate_launch_description():
    box = ComposableNodeContainer(
        name="box", namespace="", package="rclcpp_components", executable="component_container",
        composable_node_descriptions=[ComposableNode(
            package="parts", plugin="parts::Eye", name="eye", parameters=[{"rate": 5}],
            remappings=[("image", "/image")], extra_arguments=[{"use_intra_process_comms": True}],
        )], output="screen")
    more = LoadComposableNodes(target_container=box, composable_node_descriptions=[
        ComposableNode(package="parts", plugin="parts::Ear", namespace="/head")])
    return LaunchDescription([PushRosNamespace("robot"), box, more])
""",
}


@pytest.mark.parametrize("kind", CONTAINERS)
def test_a_container_is_one_node_with_its_components(root: Path, kind: str) -> None:
    (root / f"x.launch.{kind}").write_text(CONTAINERS[kind])
    [box], wrong = nodes(root, f"x.launch.{kind}")
    assert wrong == []
    assert isinstance(box.kind, Container)
    assert box.executable.startswith("component_container-")
    assert [component.package for component in box.kind.components] == ["parts", "parts"]
    assert " ".join(box.command_line()) == (
        "--ros-args -r __node:=box -r __ns:=/robot "
        "--component parts::Eye 9 --ros-args -r __node:=eye -r __ns:=/robot -r image:=/image "
        "-p rate:=5 --component parts::Ear 3 --ros-args -r __ns:=/head"
    )


@pytest.mark.parametrize("target", ["/robot/box", "robot/box", "box"])
def test_the_names_of_containers_are_outside_of_all_namespaces(root: Path, target: str) -> None:
    (root / "x.launch.xml").write_text(f"""<launch>
      <push_ros_namespace namespace="robot"/>
      <node_container pkg="rclcpp_components" exec="component_container" name="box" namespace=""/>
      <load_composable_node target="{target}">
        <composable_node pkg="parts" plugin="parts::Ear"/>
      </load_composable_node>
    </launch>""")
    [box], wrong = nodes(root, "x.launch.xml")
    expected = "no component container '/box' in this launch file; known: /robot/box"
    if target == "box":
        assert wrong == [f"x.launch.xml:4: load_composable_node: {expected}"]
    else:
        assert wrong == []
        assert isinstance(box.kind, Container)
        assert [component.plugin for component in box.kind.components] == ["parts::Ear"]


def test_a_function_loads_into_a_container_of_its_file(root: Path) -> None:
    given = CONTAINERS["py"].replace(
        "box, more]", "box, OpaqueFunction(function=lambda _: [more])]"
    )
    (root / "x.launch.py").write_text(f"from launch.actions import OpaqueFunction\n{given}")
    [box], wrong = nodes(root, "x.launch.py")
    assert wrong == []
    assert isinstance(box.kind, Container)
    assert [component.plugin for component in box.kind.components] == ["parts::Eye", "parts::Ear"]


def test_a_container_that_is_not_started_is_said(root: Path) -> None:
    given = CONTAINERS["py"].replace("box, more]", "more]")
    (root / "x.launch.py").write_text(given)
    found, [wrong] = nodes(root, "x.launch.py")
    assert found == []
    assert wrong.endswith("the launch file does not start the component container before")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "<node_container pkg='rclcpp_components' exec='mine' name='a' namespace=''/>",
            "node_container: 'mine' is not a supported component container; ",
        ),
        (
            "<load_composable_node target='none'/>",
            "load_composable_node: no component container '/none' in this launch file; ",
        ),
    ],
)
def test_containers_are_known(root: Path, text: str, expected: str) -> None:
    (root / "x.launch.xml").write_text(f"<launch>\n{text}\n</launch>")
    found, [line] = nodes(root, "x.launch.xml")
    assert found == []
    assert line.startswith(f"x.launch.xml:2: {expected}")


def test_they_start_with_the_page(tab: Page, serve: Serve, built: Built) -> None:
    tab.goto(serve(built(SITE)))
    for name, lines in {
        "first": ["/first /shared --mood very good", "greeting 'Hello blue'", "limits.top 2.5"],
        "second": [
            "/blue/left/second /blue/left/chatter",
            "everybody True",
            '''greeting "it's me"''',
            "limits.low [1.0, 2.0]",
            "limits.top 3.0",
            "number 7",
        ],
        "blue_fan": [
            "/blue/deep/blue_fan /blue/deep/other",
            "flag True",
            "list [1, 2]",
            "number 7",
        ],
        "speak": ["/speaker /chatter"],
    }.items():
        node = Panel(tab, name)
        node.expect_state("stopped")
        # Where nodes share an interpreter, the first of them says that it starts.
        assert [line for line in node.lines() if line != "starting Python…"] == lines


FUNCTIONS = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, OpaqueFunction
from launch.actions import SetLaunchConfiguration
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch.utilities import perform_substitutions
from launch_ros.actions import Node, PushRosNamespace


def robots(context, kind, *, suffix):
    if not IfCondition(LaunchConfiguration("wanted")).evaluate(context):
        return None
    context.launch_configurations["found"] = "yes"
    number = int(LaunchConfiguration("number").perform(context))
    name = perform_substitutions(context, [kind, "_", LaunchConfiguration("name")])
    return [
        Node(package="a", executable="drive", name=f"{name}_{each}{suffix}")
        for each in range(number)
    ] + [OpaqueFunction(function=inner)]


def inner(context):
    return [Node(package="a", executable="inner", name=context.launch_configurations["found"])]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("number", default_value="1"),
        DeclareLaunchArgument("wanted", default_value="true"),
        OpaqueFunction(function=lambda context: [
            SetLaunchConfiguration("name", "n" + context.perform_substitution("$(var number)"))]),
        GroupAction([
            PushRosNamespace("left"),
            OpaqueFunction(function=robots, args=["fox"], kwargs={"suffix": "x"}),
        ]),
        OpaqueFunction(function=robots, args=["never"], condition=IfCondition("false")),
    ])
"""


def test_functions_get_the_arguments_where_they_are_called(root: Path) -> None:
    (root / "x.launch.py").write_text(FUNCTIONS)
    found, lines = nodes(root, "x.launch.py", number="2")
    assert lines == []
    assert [(node.namespace, node.name) for node in found] == [
        ("/left", "fox_n2_0x"),
        ("/left", "fox_n2_1x"),
        ("/left", "yes"),
    ]
    found, lines = nodes(root, "x.launch.py", wanted="false")
    assert (found, lines) == ([], [])


INSTALLED = """
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory("robots")
    file = os.path.join(share, "fox.txt")
    with open(file) as opened:
        return LaunchDescription([
            Node(package="robots", executable="fox", arguments=[opened.read(), file],
                 parameters=[{"file": file, "more": share + "_more"}])])
"""


def test_files_are_where_the_package_installs_them(root: Path) -> None:
    package = root / "robots"
    for name, text in {
        "package.xml": PACKAGE.format("robots").replace(
            "</package>", "<export><build_type>ament_python</build_type></export></package>"
        ),
        "setup.py": "from glob import glob\nfrom setuptools import setup\n"
        "setup(packages=[], data_files=[('share/robots', glob('texts/*'))])\n",
        "texts/fox.txt": "a fox",
        "x.launch.py": INSTALLED,
    }.items():
        (package / name).parent.mkdir(parents=True, exist_ok=True)
        (package / name).write_text(text)
    found, wrong = nodes(root, "robots/x.launch.py")
    assert wrong == []
    # Programs of a page find them elsewhere than the launch file does.
    assert found[0].arguments == ("a fox", "/ros/share/robots/fox.txt")
    assert found[0].parameters["file"] == "'/ros/share/robots/fox.txt'"
    assert "/ros/" not in found[0].parameters["more"]
    # What is not there is told by the package, not by where the launch file looked for it.
    wrong_name = INSTALLED.replace("fox.txt", "wolf.txt")
    content = INSTALLED.replace("opened.read()", "FileContent(file + 's')")
    for text, told in [
        (wrong_name, "No such file or directory: '$(find-pkg-share robots)/wolf.txt'"),
        (content, "no file '$(find-pkg-share robots)/fox.txts'"),
    ]:
        file = package / "x.launch.py"
        file.write_text(f"from launch.substitutions import FileContent\n{text}")
        _, [line] = nodes(root, "robots/x.launch.py")
        assert line.endswith(told)


CONTENT = """<robot name='fox "of" $5'>\n  <link name='tail'/>\n</robot>\n"""
WORDS = {
    "py": """
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.substitutions import FileContent, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    robot = FileContent(PathJoinSubstitution([FindPackageShare("robots"), "fox.urdf"]))
    mood = LaunchConfiguration("mood", default="it's fine")
    none = LaunchConfiguration("none", default="")
    return LaunchDescription([
        Node(package="a", executable="fox", parameters=[{"robot": robot}],
             arguments=[robot, mood, ["so ", mood], "a b", [none, "one"]]),
        ExecuteProcess(cmd=["ros2", "run", "a", "ran", mood]),
    ])
""",
    "xml": """<launch>
  <arg name="mood" default="it's fine"/>
  <arg name="none" default=""/>
  <node pkg="a" exec="fox" args="$(file-content $(find-pkg-share robots)/fox.urdf) $(var mood)
                                 'so $(var mood)' 'a b' $(var none)one">
    <param name="robot" value="$(file-content $(find-pkg-share robots)/fox.urdf)"/>
  </node>
  <executable cmd="ros2 run a ran $(var mood)"/>
</launch>""",
}


@pytest.mark.parametrize("kind", ["py", "xml"])
def test_what_substitutions_stand_for_is_one_word(root: Path, kind: str) -> None:
    """It is not read again, whatever quotes and spaces it has, as in the text of a robot."""
    (root / "robots").mkdir()
    (root / "robots/package.xml").write_text(PACKAGE.format("robots"))
    (root / "robots/fox.urdf").write_text(CONTENT)
    (root / f"x.launch.{kind}").write_text(WORDS[kind])
    found, wrong = nodes(root, f"x.launch.{kind}")
    assert wrong == []
    assert found[0].arguments == (CONTENT, "it's fine", "so it's fine", "a b", "one")
    assert CONTENT.partition("'")[0] in found[0].parameters["robot"]
    assert found[1].arguments == ("it's fine",)
