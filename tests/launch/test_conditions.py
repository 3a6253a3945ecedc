"""Substitutions that compare and combine values, in each kind of launch file.

The values are those of launch 3.7.1, which has `any` and `all` in Python files only.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import nodes

from sitegen import rclyaml

# The substitution in XML and YAML, the same in Python, and its value.
FACTS = [
    ("$(not true)", "NotSubstitution('true')", "false"),
    ("$(not $(var zero))", "NotSubstitution(LaunchConfiguration('zero'))", "true"),
    ("$(and $(var one) yes)", "AndSubstitution(LaunchConfiguration('one'), 'yes')", "true"),
    ("$(and true $(not on))", "AndSubstitution('true', NotSubstitution('on'))", "false"),
    ("$(or 0 off)", "OrSubstitution('0', 'off')", "false"),
    ("$(or $(var zero) True)", "OrSubstitution(LaunchConfiguration('zero'), 'True')", "true"),
    ("$(any 0 false TRUE)", "AnySubstitution('0', 'false', 'TRUE')", "true"),
    (
        "$(all 1 true $(var zero))",
        "AllSubstitution('1', 'true', LaunchConfiguration('zero'))",
        "false",
    ),
    ("$(equals 1 true)", "EqualsSubstitution('1', True)", "true"),
    ("$(equals 1.0 1)", "EqualsSubstitution(1.0, '1')", "true"),
    (
        "$(equals $(var word) 'a b')",
        "EqualsSubstitution(LaunchConfiguration('word'), 'a b')",
        "true",
    ),
    ("$(equals a A)", "EqualsSubstitution('a', 'A')", "false"),
    ("$(equals yes true)", "EqualsSubstitution('yes', 'true')", "false"),
    ("$(not-equals 0.1 0.10000000001)", "NotEqualsSubstitution(0.1, 0.10000000001)", "false"),
    ("$(not-equals mini maxi)", "NotEqualsSubstitution('mini', 'maxi')", "true"),
    (
        "$(if $(var one) 1.5 0.5)",
        "IfElseSubstitution(LaunchConfiguration('one'), '1.5', '0.5')",
        "1.5",
    ),
    ("$(if off 'a, b' 'c = d')", "IfElseSubstitution('off', 'a, b', 'c = d')", "c = d"),
    ("x$(if no 1)", "['x', IfElseSubstitution('no', '1')]", "x"),
]
XML = """<launch><let name="one" value="1"/><let name="zero" value="false"/>
<let name="word" value="a b"/>
<node pkg="p" exec="x">{}</node></launch>
"""
YAML = """launch:
- let: {{name: one, value: '1'}}
- let: {{name: zero, value: 'false'}}
- let: {{name: word, value: a b}}
- node:
    pkg: p
    exec: x
    param:
{}
"""
PYTHON = """from launch import LaunchDescription
from launch.actions import SetLaunchConfiguration
from launch.substitutions import *
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    return LaunchDescription([
        SetLaunchConfiguration("one", "1"),
        SetLaunchConfiguration("zero", "false"),
        SetLaunchConfiguration("word", "a b"),
        Node(package="p", executable="x", parameters=[{{
{}        }}]),
    ])
"""


def of_xml(name: str, text: str, _: str) -> str:
    return f'<param name="{name}" type="str" value="{text}"/>'


def of_yaml(name: str, text: str, _: str) -> str:
    quoted = text.replace("'", "''")
    return f"    - {{name: {name}, type: str, value: '{quoted}'}}\n"


def of_python(name: str, _: str, text: str) -> str:
    return f"            {name!r}: ParameterValue({text}, value_type=str),\n"


KINDS = {"xml": (XML, of_xml), "yaml": (YAML, of_yaml), "py": (PYTHON, of_python)}


@pytest.mark.parametrize("kind", KINDS)
def test_a_substitution_has_the_value_that_launch_gives_it(root: Path, kind: str) -> None:
    form, written = KINDS[kind]
    inside = "".join(written(f"n{i}", xml, py) for i, (xml, py, _) in enumerate(FACTS))
    (root / f"x.launch.{kind}").write_text(form.format(inside))
    [node], wrong = nodes(root, f"x.launch.{kind}")
    assert wrong == []
    found = {name: rclyaml.value(text) for name, text in node.parameters.items()}
    assert found == {f"n{i}": value for i, (*_, value) in enumerate(FACTS)}


def test_an_anonymous_name_is_valid_and_the_same_each_time(root: Path) -> None:
    node = '<node pkg="p" exec="x" name="$(anon g)"/>'
    text = f"<launch>{node}{node}</launch>"
    (root / "x.launch.xml").write_text(text)
    found, wrong = nodes(root, "x.launch.xml")
    assert wrong == []
    names = {node.remap["__node"] for node in found}
    assert len(names) == 1
    assert names.pop().startswith("g_")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("$(not perhaps)", "$(not …): 'perhaps' is not of type 'bool'"),
        ("$(and true)", "$(and …) has the wrong number of arguments"),
        ("$(if true)", "$(if …) has the wrong number of arguments"),
    ],
)
def test_what_is_no_condition_is_told(root: Path, text: str, expected: str) -> None:
    (root / "x.launch.xml").write_text(f'<launch><let name="x" value="{text}"/></launch>')
    _, wrong = nodes(root, "x.launch.xml")
    assert wrong == [f"x.launch.xml:1: let: {expected}"]
