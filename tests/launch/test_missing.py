"""What a Python launch file imports and sitegen lacks costs the use of it, not the file."""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import PACKAGE, nodes

BEGIN = """
from launch import LaunchDescription
from launch_ros.actions import Node
{imports}

def generate_launch_description():
    return LaunchDescription([
        Node(package="p", executable="x", name="first"),
        {use},
        Node(package="p", executable="x", name="last"),
    ])
"""


@pytest.mark.parametrize(
    ("imports", "use", "expected"),
    [
        ("from launch.actions import Dance", "LaunchDescription", ""),
        (
            "from launch.actions import Dance",
            "Dance('fast', steps=3)",
            "9: Dance: this action is not supported in the browser; known: ",
        ),
        (
            "from launch_ros.dances import Waltz",
            "Waltz.of(3)",
            "9: Waltz: this action is not supported in the browser; known: ",
        ),
        (
            "import launch.somewhere.deep as deep",
            "deep.Polka()",
            "9: Polka: this action is not supported in the browser; known: ",
        ),
        (
            "from launch.substitutions import Rhyme",
            "Node(package='p', executable='x', name=['a_', Rhyme('b')])",
            "9: node: $(Rhyme …) is not supported; supported: ",
        ),
        (
            "from launch.conditions import Mood",
            "Node(package='p', executable='x', condition=Mood('good'))",
            "9: condition Mood: this action is not supported in the browser; known: ",
        ),
        (
            "from launch import Action\nclass Own(Action):\n    pass",
            "Own()",
            "11: Own: this action is not supported in the browser; known: ",
        ),
    ],
)
def test_a_name_that_is_missing_costs_its_use(
    root: Path, imports: str, use: str, expected: str
) -> None:
    unused = not expected
    use = "Node(package='p', executable='x', name='middle')" if unused else use
    (root / "x.launch.py").write_text(BEGIN.format(imports=imports, use=use))
    found, wrong = nodes(root, "x.launch.py")
    assert [node.name for node in found] == ["first", *(["middle"] if unused else []), "last"]
    assert len(wrong) == (0 if unused else 1)
    assert "".join(wrong).startswith(f"x.launch.py:{expected}" if expected else "")


def test_each_class_is_in_a_module_of_its_own_too(root: Path) -> None:
    imports = """
from launch.actions.declare_launch_argument import DeclareLaunchArgument
from launch.launch_description import LaunchDescription
from launch.launch_description_sources.python_launch_description_source import *
from launch.substitutions.launch_configuration import LaunchConfiguration
from launch_ros.actions.node import Node as RosNode
import launch.actions.group_action as grouping
"""
    use = """DeclareLaunchArgument("who", default_value="me"),
        grouping.GroupAction([
            RosNode(package="p", executable="x", name=LaunchConfiguration("who")),
        ])"""
    (root / "x.launch.py").write_text(BEGIN.format(imports=imports, use=use))
    found, wrong = nodes(root, "x.launch.py")
    assert wrong == []
    assert [node.name for node in found] == ["first", "me", "last"]


def test_modules_of_the_workspace_are_imported(root: Path) -> None:
    package = root / "src" / "helping"
    (package / "helping").mkdir(parents=True)
    (package / "package.xml").write_text(PACKAGE.format("helping"))
    (package / "helping" / "__init__.py").write_text("")
    (package / "helping" / "names.py").write_text("def name():\n    return 'helped'\n")
    (root / "x.launch.py").write_text(
        BEGIN.format(
            imports="from helping.names import name",
            use="Node(package='p', executable='x', name=name())",
        )
    )
    found, wrong = nodes(root, "x.launch.py")
    assert wrong == []
    assert [node.name for node in found] == ["first", "helped", "last"]


def test_a_package_that_is_missing_is_an_exception(root: Path) -> None:
    (root / "x.launch.py").write_text(
        "from ament_index_python.packages import PackageNotFoundError\n"
        "from ament_index_python.packages import get_package_share_directory\n"
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    try:\n        get_package_share_directory('absent')\n"
        "    except PackageNotFoundError:\n"
        "        return LaunchDescription([Node(package='p', executable='x')])\n"
    )
    found, wrong = nodes(root, "x.launch.py")
    assert (len(found), wrong) == (1, [])
