"""Loops and joined strings, as launch 3.8 documents them."""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import nodes

ROBOTS = "{name: a, id: 1};{name: b, id: 2.50};{name: c, opt: '*'}; {};"
LOOPS = {
    "xml": f"""<launch>
<arg name="robots" default="{ROBOTS}"/><let name="count" value="2"/>
<for_each values="$(var robots)">
  <let name="last" value="$(for-var name none)"/>
  <node pkg="p" exec="x" name="n_$(for-var name '')" args="$(for-var id 0) $(for-var opt '-')"/>
</for_each>
<for len="$(var count)" name="i"><for len="2" name="j">
  <node pkg="p" exec="x" name="m" args="$(string-join . $(index i) $(index j) $(var last))"/>
</for></for>
</launch>""",
    "yaml": f"""launch:
- arg: {{name: robots, default: "{ROBOTS}"}}
- let: {{name: count, value: '2'}}
- for_each:
    values: $(var robots)
    children:
    - let: {{name: last, value: $(for-var name none)}}
    - node:
        {{pkg: p, exec: x, name: "n_$(for-var name '')",
          args: "$(for-var id 0) $(for-var opt '-')"}}
- for:
    len: $(var count)
    name: i
    children:
    - for:
        len: '2'
        name: j
        children:
        - node:
            {{pkg: p, exec: x, name: m,
              args: "$(string-join . $(index i) $(index j) $(var last))"}}
""",
    "py": f"""
from launch import LaunchDescription
from launch.actions import *
from launch.substitutions import *
from launch_ros.actions import Node

def each(name="", id=0, opt="-"):
    last = SetLaunchConfiguration("last", name or "none")
    return [last, Node(package="p", executable="x", name="n_" + name, arguments=[str(id), opt])]

def count(i):
    last = LaunchConfiguration("last")
    return [
        Node(package="p", executable="x", name="m", arguments=[
            StringJoinSubstitution([str(i), ["", str(j)], last], delimiter=".")])
        for j in range(2)]

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("robots", default_value="{ROBOTS}"),
        ForEach(LaunchConfiguration("robots"), function=each),
        ForLoop(["", "2"], function=count),
    ])
""",
}


@pytest.mark.parametrize("kind", LOOPS)
def test_loops_run_once_for_each_value(root: Path, kind: str) -> None:
    (root / f"x.launch.{kind}").write_text(LOOPS[kind])
    found, wrong = nodes(root, f"x.launch.{kind}")
    assert wrong == []
    assert [(node.remap["__node"], node.arguments) for node in found] == [
        ("n_a", ("1", "-")),
        ("n_b", ("2.5", "-")),
        ("n_c", ("0", "*")),
        ("n_", ("0", "-")),
        *(("m", (f"{i}.{j}.none",)) for i in range(2) for j in range(2)),
    ]


@pytest.mark.parametrize(
    ("inside", "expected"),
    [
        ("<for len='x' name='i'/>", "for: 'len' is 'x', but must be an integer"),
        ("<for len='1000000' name='i'/>", "for: 'len' is 1000000, but may be 1000 at most"),
        ("<for_each values='a;b'/>", "for_each: 'a' is not a mapping such as {name: a, id: 1}"),
        (
            "<for len='1' name='i'><let name='a' value='$(index j)'/></for>",
            "let: index 'j' of the loop is not set",
        ),
        (
            "<for_each values='{a: 1}'/><let name='a' value='$(for-var a)'/>",
            "let: variable 'a' of the loop is not set",
        ),
        ("<push_env/>", "push_env: only launch files in Python contain 'push_env'"),
    ],
)
def test_what_is_wrong_with_a_loop(root: Path, inside: str, expected: str) -> None:
    (root / "x.launch.xml").write_text(f"<launch>\n{inside}\n</launch>")
    assert nodes(root, "x.launch.xml")[1] == [f"x.launch.xml:2: {expected}"]


def test_a_function_of_a_loop_that_fails_is_told_with_its_line(root: Path) -> None:
    (root / "x.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch.actions import ForEach\n"
        "def each(name):\n    return []\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([ForEach('{nmae: a}', function=each)])\n"
    )
    [wrong] = nodes(root, "x.launch.py")[1]
    assert wrong.startswith("x.launch.py:6: launch: TypeError: each() got an unexpected keyword")


def test_paths_are_joined_as_python_joins_them(root: Path) -> None:
    (root / "x.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch.substitutions import *\n"
        "from launch_ros.actions import Node, SetParameter\n"
        "from launch_ros.substitutions import Parameter\n"
        "def generate_launch_description():\n"
        "    paths = [['a', '/b'], ['a', ['b', 'c']], ['a/', 'b']]\n"
        "    words = [PathJoinSubstitution(path) for path in paths]\n"
        "    words += [Parameter('speed'), Parameter('other', default=[1, 'm'])]\n"
        "    return LaunchDescription([SetParameter('speed', 2.5),\n"
        "        Node(package='p', executable='x', arguments=words)])\n"
    )
    [node], wrong = nodes(root, "x.launch.py")
    assert wrong == []
    assert node.arguments == ("/b", "a/bc", "a/b", "2.5", "1m")
