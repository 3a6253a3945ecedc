"""Launch files: the nodes that they start, and what is said of those that cannot be had."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import Page

from sitegen import workspace
from sitegen.config import load
from sitegen.errors import Problems, SiteError
from sitegen.launch import launched
from sitegen.model import Container, Node

SITE = SITES / "launch"
PACKAGE = "<package format='3'><name>{}</name><version>1.0.0</version></package>"


def nodes(root: Path, name: str, **arguments: str) -> tuple[list[Node], list[str]]:
    """Return the nodes that a launch file starts, and what is wrong with it."""
    problems = Problems(root)
    found = launched(root / name, arguments, workspace.scan(root), problems)
    return found, problems.lines


@pytest.mark.parametrize("kind", ["xml", "py"])
def test_nodes_are_those_that_ros_would_start(kind: str) -> None:
    found, wrong = nodes(SITE, f"src/bringup/launch/all.launch.{kind}", team="blue")
    assert wrong == []
    assert {node.name: " ".join(node.command_line()) for node in found} == {
        "first": "--mood very good --ros-args -r __node:=first -r chatter:=/shared "
        "-p greeting:=Hello blue -p limits.top:=2.5",
        "second": "--ros-args -r __node:=second -r __ns:=/blue/left -p number:=7 "
        "-p /**:everybody:=true -p /blue/left/second:greeting:=it's me "
        "-p /blue/left/second:limits.top:=3.0 -p /blue/left/second:limits.low:=[1.0, 2.0] "
        "-p /nobody:greeting:=false",
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


@pytest.fixture
def root(tmp_path: Path) -> Path:
    package = tmp_path / "src" / "mine"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(PACKAGE.format("mine"))
    return tmp_path


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<launch><node pkg='a'></launch>", "launch: mismatched tag; check the tags here"),
        ("<robot/>", "launch: expected <launch>, found <robot>"),
        ("<!DOCTYPE x><launch/>", "launch: a document type declaration is not allowed"),
        ("<launch><node pkg='a'/></launch>", "node: 'exec' is missing"),
        (
            "<launch><nod pkg='a'/></launch>",
            "nod: this action is not supported in the browser; did you mean",
        ),
        ("<launch><let name='x' value='$(eval 1/0)'/></launch>", "let: '1/0' is not a valid"),
        ("<launch><let name='x' value='$(eval open)'/></launch>", "let: 'open' is not a valid"),
        ("<launch><arg name='x'/></launch>", "arg: 'x' has no value; give one in 'launch_arg"),
        ("<launch><let name='x' value='$(var y)'/></launch>", "let: argument 'y' is not set"),
        ("<launch><let name='x' value='$(var y'/></launch>", "let: '$(var y' has an unclosed"),
        (
            "<launch><let name='x' value='$(command ls)'/></launch>",
            "let: $(command …) runs",
        ),
        (
            "<launch><node pkg='a' exec='b' if='perhaps'/></launch>",
            "node: 'perhaps' is not a boolean",
        ),
        (
            "<launch><include file='$(find-pkg-share other)/x.xml'/></launch>",
            "include: no package 'other' in the workspace; ",
        ),
        ("<launch><include file='/etc/x.xml'/></launch>", "include: '/etc/x.xml' is outside"),
        ("<launch><include file='$(dirname)/no.xml'/></launch>", "include: 'no.xml': No such"),
        ("<launch><include file='$(filename)'/></launch>", "include: launch files include each"),
        ("<launch><include file='$(dirname)/x.sh'/></launch>", "include: 'x.sh' is not a"),
        (
            "<launch><node pkg='a' exec='b'><param from='$(dirname)/no.yaml'/></node></launch>",
            "node: no file '",
        ),
    ],
)
def test_what_is_wrong_is_said_with_its_line(root: Path, text: str, expected: str) -> None:
    (root / "x.launch.xml").write_text(f"<?xml version='1.0'?>\n{text}\n")
    found, [line, *_] = nodes(root, "x.launch.xml")
    assert found == []
    assert line.startswith(f"x.launch.xml:2: {expected}")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("launch: {node: {}}", "1: launch: expected a list"),
        ("- node:", "1: launch: expected one key, 'launch', with a list of actions"),
        ("launch:\n- node: {pkg: a}", "2: node: 'exec' is missing"),
        ("launch:\n- node: {pkg: a, exec: [b]}", "2: launch: 'exec' of 'node' must be a string"),
        ("launch: [", "2: launch: "),
    ],
)
def test_the_same_of_yaml(root: Path, text: str, expected: str) -> None:
    (root / "x.launch.yaml").write_text(f"{text}\n")
    found, [line, *_] = nodes(root, "x.launch.yaml")
    assert found == []
    assert line.startswith(f"x.launch.yaml:{expected}")


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


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "def generate(): pass",
            "1: launch: LookupError: no function generate_launch_description() found",
        ),
        ("import nowhere", "1: launch: ModuleNotFoundError: No module named 'nowhere'"),
        ("x = (\n", "1: launch: SyntaxError: '(' was never closed"),
        (
            "import os\nos._exit(0)",
            "1: launch: the launch file exited before it described anything",
        ),
        (
            "from launch import LaunchDescription\nfrom launch.actions import OpaqueFunction\n"
            "def generate_launch_description():\n"
            "  return LaunchDescription([OpaqueFunction(function=lambda _: 1 / 0)])\n",
            "4: launch: ZeroDivisionError: division by zero",
        ),
        (
            "from ament_index_python import get_package_share_directory as share\n"
            "def generate_launch_description():\n    return share('other')\n",
            "3: launch: LookupError: no package 'other' in the workspace",
        ),
    ],
)
def test_the_same_of_python(root: Path, text: str, expected: str) -> None:
    (root / "x.launch.py").write_text(text)
    found, [line, *_] = nodes(root, "x.launch.py")
    assert found == []
    assert line.startswith(f"x.launch.py:{expected}")


LEFT_OUT = {
    "py": """
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import IfCondition, LaunchConfigurationEquals
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch.events import Shutdown as ShutdownEvent, matches_action
from launch.substitutions import *
from launch_ros.actions import LifecycleNode, LifecycleTransition, Node
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from launch_ros.substitutions import ExecutableInPackage, FindPackageShare
from lifecycle_msgs.msg import Transition


def generate_launch_description():
    side = LaunchConfiguration("side")
    spawn = ExecuteProcess(cmd=[[FindExecutable(name="ros2"), " service call ", side]], shell=True)
    first = LifecycleNode(
        package="a", executable="first", name="first", namespace="", on_exit=Shutdown(),
        autostart=True)
    configure = ChangeState(
        lifecycle_node_matcher=matches_action(first),
        transition_id=Transition.TRANSITION_CONFIGURE)
    says = LogInfo(msg=[LocalSubstitution("event.reason"), EnvironmentVariable("USER")])
    return LaunchDescription([
        DeclareLaunchArgument("side", default_value="3"),
        DeclareLaunchArgument("mood", default_value="it's"),
        first,
        spawn,
        ExecuteProcess(cmd=[
            ExecutableInPackage(package="mine", executable="process"), "--rate", side]),
        ExecuteProcess(cmd=["ros2", "run", "a", "runs"]),
        TimerAction(period=2.0, actions=[
            spawn,
            Node(package="a", executable="late", condition=IfCondition(
                PythonExpression([side, " == 3 and ", "'\\"' not in 'x y'"])))]),
        RegisterEventHandler(event_handler=OnProcessStart(target_action=first, on_start=[
            Node(package="a", executable="follows", arguments=[
                PythonExpression(["'%.2f' % sqrt(", side, ")"])])])),
        RegisterEventHandler(OnProcessExit(target_action=spawn, on_exit=lambda event: says)),
        RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=first, goal_state="inactive",
            entities=[Node(package="a", executable="never")])),
        EmitEvent(event=configure),
        LifecycleTransition(lifecycle_node_names=["/first"], transition_ids=[1, 3]),
        EmitEvent(event=ShutdownEvent(reason="done")),
        Node(package="a", executable="equal", name=[FindPackageShare("mine") / "x"],
             condition=LaunchConfigurationEquals("mood", "it's")),
        Node(package="a", executable="not_equal", condition=IfCondition(
            AndSubstitution(NotEqualsSubstitution(side, "3"), "true"))),
        Node(package="a", executable="either", namespace=IfElseSubstitution(
            OrSubstitution("false", EqualsSubstitution(side, "3")), "left", "right")),
    ])
""",
    "xml": """<launch>
  <arg name="side" default="3"/>
  <executable cmd="ros2 service call"/>
  <node pkg="a" exec="first" args="$(eval '1 + $(var side)')"/>
  <timer period="2.0">
    <node pkg="a" exec="late" if="$(eval '$(var side) == 3 and &quot;x y&quot; != &quot;x&quot;')"/>
    <node pkg="a" exec="never" if="$(eval 'len(str($(var side))) > 1')"/>
  </timer>
  <lifecycle_node pkg="a" exec="managed" name="managed" namespace="" autostart="true"
    on_exit="shutdown"/>
  <lifecycle_node pkg="a" exec="left" name="left" namespace="" autostart="false"/>
  <lifecycle_transition lifecycle_node_names="/left" transition_ids="1"/>
  <set_use_sim_time value="true"/>
  <node pkg="a" exec="timed"/>
</launch>""",
    "yaml": """
launch:
  - executable: {cmd: ros2 service call}
  - lifecycle_node:
      {pkg: a, exec: first, name: first, namespace: "", autostart: "true", on_exit: shutdown}
  - lifecycle_transition: {lifecycle_node_names: /first, transition_ids: "1"}
  - timer:
      period: 2.0
      children:
        - node: {pkg: a, exec: late}
        - node: {pkg: a, exec: never, if: "$(eval '1 > 2')"}
""",
}


@pytest.mark.parametrize(
    ("kind", "expected"),
    [
        (
            "py",
            [
                *("first", "process --rate 3", "runs", "late", "follows 1.73", "{}/x"),
                "either left",
            ],
        ),
        ("xml", ["first 4", "late", "managed", "left", "timed use_sim_time"]),
        ("yaml", ["first", "late"]),
    ],
)
def test_what_a_page_does_without_is_left_out(root: Path, kind: str, expected: list[str]) -> None:
    (root / f"x.launch.{kind}").write_text(LEFT_OUT[kind])
    problems, notes = Problems(root), Problems(root)
    packages = workspace.scan(root)
    found = launched(root / f"x.launch.{kind}", {}, packages, problems, notes)
    assert problems.lines == []
    said = [
        " ".join([node.name, *node.arguments, *node.parameters, node.namespace.strip("/")]).strip()
        for node in found
    ]
    assert said == [each.format(packages["mine"].path) for each in expected]
    kinds = {line.split(": ")[1] for line in notes.lines}
    events = {"event", "event_handler"} if kind == "py" else set()
    managed = {"lifecycle_node", "lifecycle_transition"}
    assert kinds == {"executable", "timer", *managed, *events}
    for name in ("autostart", "on_exit"):
        assert [line for line in notes.lines if f"'{name}' is ignored" in line]


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


def test_the_workspace_has_to_have_what_is_launched(root: Path) -> None:
    (root / "x.launch.xml").write_text("<launch>\n<node pkg='mine' exec='twice'/>\n</launch>")
    (root / "site.yaml").write_text(
        "site: {title: A}\nnodes: {twice: {package: mine, executable: x}}\n"
        "pages: [{path: /, title: A, launch: x.launch.xml}]\n"
    )
    with pytest.raises(SiteError) as caught:
        load(root / "site.yaml")
    text = "\n".join(caught.value.lines)
    assert "launch: 'twice', which 'x.launch.xml' starts, is also a node in site.yaml" in text
    assert "x.launch.xml:2: node: package 'mine' is of build type 'catkin'" in text
