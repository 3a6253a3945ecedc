"""Python launch files that give arguments by name, with the names of launch and launch_ros."""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import PACKAGE, nodes

FILE = """\
from launch import *
from launch.actions import *
from launch.conditions import *
from launch.launch_description_sources import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import *
from launch_ros.parameter_descriptions import *
from launch_ros.substitutions import FindPackageShare
from launch import condition, LaunchContext


def generate_launch_description():
    context = LaunchContext()
    return LaunchDescription(initial_entities=[{}])
"""
INCLUDED = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    word = LaunchConfiguration(variable_name="word", default="none")
    return LaunchDescription([Node(package="mine", executable="talk", arguments=[word])])
"""
SOURCE = "launch_file_path=[FindPackageShare(package='mine'), '/launch/b.launch.py']"
# What a node has as its argument, and the argument.
ARGUMENTS = [
    ("LaunchConfiguration(variable_name='x', default='3')", "3"),
    ("EnvironmentVariable(name='ROS_NOTHING', default_value='3')", "3"),
    ("PathJoinSubstitution(substitutions=['a', 'b'])", "a/b"),
    ("PythonExpression(expression=['1 + ', '2'])", "3"),
    ("PythonExpression(expression=['math.floor(3.5)'], python_modules=['math'])", "3"),
    ("TextSubstitution(text='x')", "x"),
    ("NotSubstitution(value='true')", "false"),
    ("BooleanSubstitution(value='1')", "true"),
    ("AndSubstitution(left='true', right='false')", "false"),
    ("EqualsSubstitution(left='a', right='a')", "true"),
    ("IfElseSubstitution(condition='true', if_value='a', else_value='b')", "a"),
    ("StringJoinSubstitution(substitutions=['a', 'b'], delimiter='+')", "a+b"),
    ("Command(command=['cat ', FindPackageShare('mine'), '/word'], on_stderr='warn')", "said"),
]
ACTIONS = [
    "Node(package='mine', executable='talk', condition=IfCondition(predicate_expression='1'))",
    "Node(package='mine', executable='talk', condition=UnlessCondition(predicate_expression='0'))",
    "Node(package='mine', executable='talk', condition=LaunchConfigurationNotEquals("
    "launch_configuration_name='x', expected_value='1'))",
    f"IncludeLaunchDescription(launch_description_source=PythonLaunchDescriptionSource({SOURCE}))",
    f"IncludeLaunchDescription(AnyLaunchDescriptionSource({SOURCE}), launch_arguments=[])",
    "GroupAction(actions=[Node(package='mine', executable='talk')], scoped=True, forwarding=True)",
]


@pytest.fixture
def root(tmp_path: Path) -> Path:
    files = {
        "package.xml": PACKAGE.format("mine"),
        "CMakeLists.txt": "add_executable(talk a.cpp)",
        "launch/b.launch.py": INCLUDED,
        "word": "said",
    }
    for name, text in files.items():
        file = tmp_path / "src/mine" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return tmp_path


@pytest.mark.parametrize(("given", "expected"), ARGUMENTS)
def test_substitutions(root: Path, given: str, expected: str) -> None:
    node = f"Node(package='mine', executable='talk', arguments=[{given}])"
    (root / "x.launch.py").write_text(
        FILE.replace("{}", f"DeclareLaunchArgument(name='x', default_value='3'), {node}")
    )
    found, wrong = nodes(root, "x.launch.py")
    assert wrong == []
    assert found[0].arguments == (expected,)


@pytest.mark.parametrize("action", ACTIONS)
def test_actions(root: Path, action: str) -> None:
    (root / "x.launch.py").write_text(
        FILE.replace("{}", f"SetLaunchConfiguration(name='x', value='3'), {action}")
    )
    found, wrong = nodes(root, "x.launch.py")
    assert wrong == []
    assert [node.executable for node in found] == ["talk"]
