"""What launch files ask for and a page does without."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.launch import launched

LEFT_OUT = {
    "py": """
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import IfCondition, LaunchConfigurationEquals
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from launch.events import Shutdown as ShutdownEvent
from launch.substitutions import *
from launch_ros.actions import LifecycleNode, Node
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from launch_ros.substitutions import ExecutableInPackage, FindPackageShare
from lifecycle_msgs.msg import Transition


def generate_launch_description():
    side = LaunchConfiguration("side")
    spawn = ExecuteProcess(cmd=[[FindExecutable(name="ros2"), " service call ", side]], shell=True)
    first = LifecycleNode(
        package="a", executable="first", name="first", namespace="",
        on_exit=lambda event, context: None)
    configure = ChangeState(
        lifecycle_node_matcher=lambda node: True,
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
        RegisterEventHandler(OnProcessExit(target_action=spawn, on_exit=[says])),
        RegisterEventHandler(OnStateTransition(matcher=lambda event: True, entities=[says])),
        RegisterEventHandler(OnProcessIO(on_stdout=lambda event: says)),
        EmitEvent(event=configure),
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
  <lifecycle_node pkg="a" exec="managed" name="managed" namespace=""/>
  <lifecycle_node pkg="a" exec="left" name="left" namespace="" autostart="false"/>
  <set_use_sim_time value="true"/>
  <node pkg="a" exec="timed"/>
</launch>""",
    "yaml": """
launch:
  - executable: {cmd: ros2 service call}
  - lifecycle_node:
      {pkg: a, exec: first, name: first, namespace: ""}
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
                *("first", "process --rate 3", "runs", "{}/x", "either left", "late"),
                "follows 1.73",
            ],
        ),
        ("xml", ["first 4", "managed", "left", "timed use_sim_time", "late use_sim_time"]),
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
        for node in found.nodes
    ]
    assert said == [each.format(packages["mine"].path) for each in expected]
    kinds = Counter(line.split(": ")[1] for line in notes.lines)
    events = {"change_state": 1, "event_handler": 4, "on_exit": 1, "shutdown": 1}
    assert kinds == {"executable": 1, **(events if kind == "py" else {})}
