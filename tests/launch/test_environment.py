"""Environment variables that launch files set, as launch 3.7.1 and launch_ros 0.28.0 set them."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from launching import nodes
from paths import ROOT

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.launch import launched
from sitegen.workspace.manifest import ENVIRONMENT

XML = r"""<launch>
  <set_env name="TEAM" value="blue"/>
  <node pkg="p" exec="x" name="one"><env name="LANE" value="$(env TEAM)4"/></node>
  <group>
    <set_env name="TEAM" value="red"/><append_env name="WAY" value="a"/>
    <node pkg="p" exec="x" name="two"/>
  </group>
  <group scoped="false">
    <append_env name="WAY" value="b"/>
    <append_env name="WAY" value="c" prepend="true" separator=","/>
  </group>
  <node pkg="p" exec="x" name="three_$(env TEAM)"/>
  <group forwarding="false"><node pkg="p" exec="x" name="four_$(env TEAM none)"/></group>
  <unset_env name="TEAM"/>
  <node pkg="p" exec="x" name="five_$(env TEAM none)"/>
  <reset_env/>
  <node pkg="p" exec="x" name="six"><env name="A" value="1"/><env name="A" value="2"/></node>
</launch>
"""
PYTHON = """
from launch import LaunchDescription
from launch.actions import *
from launch.substitutions import EnvironmentVariable
from launch_ros.actions import Node

def opaque(context):
    context.environment["SEEN"] = context.environment["TEAM"] + "!"
    return [Node(package="p", executable="x", name="opaque")]

def generate_launch_description():
    own = {"LANE": "5", "X": EnvironmentVariable("TEAM")}
    return LaunchDescription([
        SetEnvironmentVariable("TEAM", "blue"),
        Node(package="p", executable="x", name="alone", env={"LANE": "4"}, additional_env=own),
        ExecuteProcess(cmd=["ros2", "run", "p", "x"], additional_env={"LANE": "6"}),
        OpaqueFunction(function=opaque),
        PushEnvironment(),
        SetEnvironmentVariable("TEAM", "red"),
        Node(package="p", executable="x", name="two"),
        PopEnvironment(),
        AppendEnvironmentVariable("TEAM", "green", separator="_", prepend=True),
        Node(package="p", executable="x", name=["of_", EnvironmentVariable("TEAM")]),
        UnsetEnvironmentVariable("TEAM"),
        Node(package="p", executable="x", name="three"),
        ReplaceEnvironmentVariables({"ONLY": "this"}),
        Node(package="p", executable="x", name="four"),
    ])
"""


def test_variables_have_the_scope_of_groups(root: Path) -> None:
    (root / "x.launch.xml").write_text(XML)
    found, wrong = nodes(root, "x.launch.xml")
    assert wrong == []
    assert {node.name: node.environment for node in found} == {
        "one": {"TEAM": "blue", "LANE": "blue4"},
        "two": {"TEAM": "red", "WAY": "a"},
        "three_blue": {"TEAM": "blue", "WAY": "c,b"},
        "four_none": {},
        "five_none": {"WAY": "c,b"},
        "six": {"A": "2"},
    }


def test_the_same_in_python(root: Path) -> None:
    (root / "x.launch.py").write_text(PYTHON)
    found, wrong = nodes(root, "x.launch.py")
    assert wrong == []
    assert {node.name: node.environment for node in found} == {
        "alone": {"LANE": "5", "X": "blue"},
        "x": {"TEAM": "blue", "LANE": "6"},
        "opaque": {"TEAM": "blue", "SEEN": "blue!"},
        "two": {"TEAM": "red", "SEEN": "blue!"},
        "of_green_blue": {"TEAM": "green_blue", "SEEN": "blue!"},
        "three": {"SEEN": "blue!"},
        "four": {"ONLY": "this"},
    }


def test_variables_of_the_author_stay_private(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SECRET", "mine")
    monkeypatch.setenv("ROS_DOMAIN_ID", "7")
    (root / "x.launch.xml").write_text(
        '<launch>\n<append_env name="SECRET" value="a"/>\n<unset_env name="ROS_DOMAIN_ID"/>\n'
        '<node pkg="p" exec="x" name="n_$(env ROS_DOMAIN_ID none)"/>\n'
        "<group><reset_env/>\n"
        '<node pkg="p" exec="x" name="n_$(env ROS_DOMAIN_ID none)_$(env SECRET none)"/>\n'
        '<node pkg="p" exec="x" name="$(env SECRET)"/></group></launch>\n'
    )
    found, wrong = nodes(root, "x.launch.xml")
    assert [node.name for node in found] == ["n_none", "n_7_none"]
    assert found[0].environment == {"SECRET": "a"}
    assert wrong == [
        "x.launch.xml:7: node: environment variable 'SECRET' is not read, because the page would "
        "publish its value; set it in 'environment' of the page, or use a default: "
        "$(env SECRET …)"
    ]


def test_nodes_and_the_build_are_of_one_distribution() -> None:
    program = ROOT / "sitegen/clients/python/rclpy_backend/program.py"
    [given] = (
        node.value
        for node in ast.parse(program.read_bytes()).body
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "ROS"
    )
    assert ast.literal_eval(given) == ENVIRONMENT


def test_a_domain_of_its_own_is_noted(root: Path) -> None:
    file = root / "x.launch.xml"
    file.write_text(
        '<launch>\n<node pkg="p" exec="x"><env name="ROS_DOMAIN_ID" value="3"/></node>\n</launch>\n'
    )
    problems, notes = Problems(root), Problems(root)
    launched(file, {}, workspace.scan(root), problems, notes)
    assert notes.lines == [
        "x.launch.xml:2: node: 'ROS_DOMAIN_ID' has no effect: all nodes of a page are in one domain"
    ]
