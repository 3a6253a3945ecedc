"""Processes of launch files: those that run a node of the workspace are that node."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.launch import launched

PROCESSES = {
    "py": """
from launch import LaunchDescription
from launch.actions import ExecuteProcess, GroupAction
from launch.substitutions import FindExecutable, LaunchConfiguration
from launch_ros.actions import PushRosNamespace, SetParameter
from launch_ros.substitutions import ExecutableInPackage, FindPackagePrefix


def generate_launch_description():
    talk = ExecutableInPackage(package="mine", executable="talk")
    listen = FindPackagePrefix("mine") / "lib/mine/listen"
    return LaunchDescription([GroupAction([
        PushRosNamespace("robot"),
        SetParameter("rate", 2),
        ExecuteProcess(cmd=[talk, "very good", "--depth", str(1)], output="screen"),
        ExecuteProcess(cmd=[[listen], "--ros-args", "-r", "__node:=ear"]),
        ExecuteProcess(cmd=[FindExecutable(name="ros2"), "run", "mine", "talk"]),
        ExecuteProcess(cmd=["ros2 run mine talk 'it is'"], shell=True),
        ExecuteProcess(cmd=["ros2", "bag", "record", "-a"]),
        ExecuteProcess(cmd=["/usr/lib/mine/talk"]),
    ])])
""",
    "xml": """<launch><group>
  <push_ros_namespace namespace="robot"/>
  <set_parameter name="rate" value="2"/>
  <executable cmd="$(exec-in-pkg talk mine) 'very good' --depth 1" output="screen"/>
  <executable cmd="$(find-pkg-prefix mine)/lib/mine/listen --ros-args -r __node:=ear"/>
  <executable cmd="$(find-exec ros2) run mine talk"/>
  <executable cmd="ros2 run mine talk 'it is'"/>
  <executable cmd="ros2 bag record -a"/>
  <executable cmd="/usr/lib/mine/talk"/>
</group></launch>""",
}


@pytest.mark.parametrize("kind", PROCESSES)
def test_processes_that_are_nodes_of_the_workspace_run(tmp_path: Path, kind: str) -> None:
    package = tmp_path / "src" / "mine"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(
        "<package format='3'><name>mine</name><version>1.0.0</version></package>"
    )
    file = tmp_path / f"x.launch.{kind}"
    file.write_text(PROCESSES[kind])
    problems, notes = Problems(tmp_path), Problems(tmp_path)
    found = launched(file, {}, workspace.scan(tmp_path), problems, notes)
    assert problems.lines == []
    assert {node.name: (node.executable, *node.command_line()) for node in found.nodes} == {
        "talk": ("talk", "very good", "--depth", "1"),
        "listen": ("listen", "--ros-args", "-r", "__node:=ear"),
        "talk_2": ("talk",),
        "talk_3": ("talk", "it is"),
    }
    assert [line.split(": ", 1)[1] for line in notes.lines] == [
        "executable: skipped: system programs cannot run in the browser"
    ] * 2
