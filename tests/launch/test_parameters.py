"""The parameters of nodes in launch files, with the types that ROS gives them.

parameters.json has what launch 3.7.1, launch_ros 0.28.0 and rclpy 9.1.2 made of each value: the
kind of launch file, the value and its `type` as they stand there, the argument `v`, and the
parameter that the node had. It is null where one of them refused the value, or the node had none.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import pytest
from launching import nodes

from sitegen import rclyaml
from sitegen.model import Container

FACTS: list[tuple[str, str, str, str, Any]] = json.loads(
    Path(__file__).with_name("parameters.json").read_text(encoding="utf-8")
)
PYTHON = """\
from typing import List

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, TextSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("v", default_value="7"),
"""


ENDS = {"xml": ("<launch>", "</launch>"), "yaml": ("launch:\n", ""), "py": (PYTHON, "    ])\n")}


def node(kind: str, value: str, named: str, default: str, name: str) -> str:
    """A node with a parameter, as it stands in a launch file of this kind."""
    if kind == "py":
        values = f"[{{'a': {value}}}]"
        return f"Node(package='p', executable='x', name={name!r}, parameters={values}),\n"
    if kind == "yaml":
        type_ = f"      type: {named}\n" if named else ""
        return (
            f"- let: {{name: v, value: {json.dumps(default)}}}\n"
            f"- node:\n    pkg: p\n    exec: x\n    name: {name}\n"
            f"    param:\n    - name: a\n      value: {value}\n{type_}"
        )
    type_ = f' type="{named}"' if named else ""
    separator = ' value-sep=";"' if kind == "xml-sep" else ""
    inside = f'<param name="a" value={quoteattr(value)}{type_}{separator}/>'
    let = f'<let name="v" value={quoteattr(default)}/>'
    return f'{let}<node pkg="p" exec="x" name="{name}">{inside}</node>'


def written(root: Path, kind: str, inside: str) -> str:
    """Write a launch file and return its name."""
    form = kind.partition("-")[0]
    begin, end = ENDS[form]
    (root / f"x.launch.{form}").write_text(f"{begin}{inside}{end}")
    return f"x.launch.{form}"


@pytest.mark.parametrize("kind", ["xml", "xml-sep", "yaml", "py"])
def test_a_value_has_the_type_that_ros_gives_it(root: Path, kind: str) -> None:
    facts = {
        f"n{i}": fact for i, fact in enumerate(FACTS) if fact[0] == kind and fact[4] is not None
    }
    name = written(root, kind, "".join(node(*fact[:4], name) for name, fact in facts.items()))
    found, wrong = nodes(root, name)
    assert wrong == []
    values = {one.name: rclyaml.value(one.parameters["a"]) for one in found}
    assert {n: repr(v) for n, v in values.items()} == {n: repr(f[4]) for n, f in facts.items()}


@pytest.mark.parametrize("fact", [fact for fact in FACTS if fact[4] is None], ids=lambda f: f[1])
def test_a_value_that_ros_refuses_is_a_problem(
    root: Path, fact: tuple[str, str, str, str, None]
) -> None:
    found, wrong = nodes(root, written(root, fact[0], node(*fact[:4], "n")))
    not_set = [one for one in found if one.parameters.get("a") == "[]"]
    assert (len(wrong) == 1) or not_set


SHARED = {
    "common.launch.xml": """<launch>
      <arg name="rate" default="4"/><let name="frame" value="odom_b"/>
      <push_ros_namespace namespace="yard"/>
      <group><set_parameter name="ended" value="1"/></group>
      <set_parameter name="gain" value="3"/><set_remap from="out" to="elsewhere"/>
    </launch>""",
    "main.launch.xml": """<launch>
      <include file="$(dirname)/common.launch.xml"/>
      <node pkg="p" exec="x" name="first"><param name="rate" value="$(var rate)"/></node>
      <group>
        <push_ros_namespace namespace="deep"/><let name="frame" value="other"/>
        <set_parameter name="deep" value="7"/>
        <node pkg="p" exec="x" name="inner"><param name="frame" value="$(var frame)"/></node>
      </group>
      <arg name="rate" default="9"/>
      <node pkg="p" exec="x" name="last">
        <remap from="out" to="mine"/><remap from="in" to="a"/><remap from="in" to="b"/>
        <param name="frame" value="$(var frame)"/><param name="rate" value="$(var rate)"/>
      </node>
    </launch>""",
}


def test_an_included_file_shares_the_scope_and_a_group_has_its_own(root: Path) -> None:
    for name, text in SHARED.items():
        (root / name).write_text(text)
    found, wrong = nodes(root, "main.launch.xml")
    assert wrong == []
    assert {node.name: " ".join(node.command_line()[1:]) for node in found} == {
        "first": "-r __node:=first -r out:=elsewhere -r __ns:=/yard -p gain:=3 -p rate:=4",
        "inner": "-r __node:=inner -r out:=elsewhere -r __ns:=/yard/deep -p gain:=3 -p deep:=7 "
        "-p frame:='other'",
        # Of two rules for one name, the first counts. launch_ros adds to the list of parameters
        # that was there before the group.
        "last": "-r __node:=last -r out:=elsewhere -r in:=a -r __ns:=/yard -p gain:=3 -p deep:=7 "
        "-p frame:='odom_b' -p rate:=4",
    }


FILE = """/**:
  ros__parameters: {side: $(var side), lane: $(eval '3 * 2'), late: 1}
"""
WITH_FILE = {
    "xml": """<launch><arg name="side" default="left"/>
      <node pkg="p" exec="x" name="n" namespace="q">
        <param name="late" value="2"/><param from="$(dirname)/p.yaml" allow_substs="true"/>
      </node>
      <node pkg="p" exec="x" name="raw"><param from="$(dirname)/p.yaml"/></node>
      <node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">
        <composable_node pkg="p" plugin="p::X" name="c">
          <param from="$(dirname)/p.yaml" allow_substs="1"/><param name="word" value="1e3"/>
        </composable_node>
      </node_container></launch>""",
    "yaml": """
launch:
- arg: {name: side, default: left}
- node:
    pkg: p
    exec: x
    name: n
    namespace: q
    param: [{name: late, value: 2}, {from: $(dirname)/p.yaml, allow_substs: true}]
- node: {pkg: p, exec: x, name: raw, param: [{from: $(dirname)/p.yaml}]}
- node_container:
    pkg: rclcpp_components
    exec: component_container
    name: box
    namespace: ''
    composable_node:
    - pkg: p
      plugin: p::X
      name: c
      param: [{from: $(dirname)/p.yaml, allow_substs: 'true'}, {name: word, value: 1e3}]
""",
    "py": """
import os
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode, ParameterFile

def generate_launch_description():
    path = os.path.join(os.path.dirname(__file__), "p.yaml")
    file = ParameterFile(param_file=path, allow_substs=True)
    return LaunchDescription([
        DeclareLaunchArgument("side", default_value="left"),
        Node(package="p", executable="x", name="n", namespace="q",
             parameters=[{"late": 2}, file]),
        Node(package="p", executable="x", name="raw", parameters=[ParameterFile(path)]),
        ComposableNodeContainer(
            name="box", namespace="", package="rclcpp_components",
            executable="component_container", composable_node_descriptions=[ComposableNode(
                package="p", plugin="p::X", name="c", parameters=[file, {"word": "1e3"}])])])
""",
}


@pytest.mark.parametrize("kind", WITH_FILE)
def test_a_parameter_file_may_have_substitutions(root: Path, kind: str) -> None:
    (root / "p.yaml").write_text(FILE)
    (root / f"x.launch.{kind}").write_text(WITH_FILE[kind])
    (first, raw, box), wrong = nodes(root, f"x.launch.{kind}")
    assert wrong == []
    assert first.parameters == {"late": "1", "side": "'left'", "lane": "6"}
    assert raw.parameters == {"side": "'$(var side)'", "lane": "'$(eval ''3 * 2'')'", "late": "1"}
    assert isinstance(box.kind, Container)
    [component] = box.kind.components
    # Components get values as launch_ros reads them, which does not take 1e3 for a number.
    rules = [word for word in component.arguments if ":=" in word and "__" not in word]
    assert rules == ["side:='left'", "lane:=6", "late:=1", "word:='1e3'"]
