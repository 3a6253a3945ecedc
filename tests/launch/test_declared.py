"""The arguments that launch files declare, for `ros2 launch --show-args`."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.launch import launched
from sitegen.model import Argument

XML = """\
<launch>
  <arg name="red" default="69" description="How red it is"/>
  <arg name="copy" default="$(var red)"/>
  <arg name="needed"/>
</launch>
"""
YAML = """\
launch:
  - arg: {name: red, default: "69", description: How red it is}
  - arg: {name: copy, default: $(var red)}
  - arg: {name: needed}
"""
PYTHON = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("red", default_value="69", description="How red it is"),
        DeclareLaunchArgument("copy", default_value=LaunchConfiguration("red")),
        DeclareLaunchArgument("needed"),
    ])
"""


@pytest.mark.parametrize(
    ("name", "text"), [("a.launch.xml", XML), ("a.launch.yaml", YAML), ("a.launch.py", PYTHON)]
)
def test_declared_arguments_are_told(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text)
    problems = Problems(tmp_path)
    found = launched(
        tmp_path / name, {"needed": "1", "red": "3"}, workspace.scan(tmp_path), problems
    )
    assert problems.lines == []
    assert found.arguments == [
        Argument("red", "69", "How red it is"),
        Argument("copy", "3"),
        Argument("needed"),
    ]
