"""Substitutions that a Python launch file, or a module of the workspace, defines itself."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from launching import PACKAGE, nodes

from sitegen.model import Node

MODULE = """
import tempfile
from typing import Text

import launch
import yaml
from launch.utilities import normalize_to_list_of_substitutions


class Changed(launch.Substitution):
    "The path of a copy of a parameter file with other values."

    def __init__(self, source: launch.SomeSubstitutionsType, changes: dict):
        super().__init__()
        self.__source = normalize_to_list_of_substitutions(source)
        self.text = {}
        for name, value in changes.items():
            self.text[name] = normalize_to_list_of_substitutions(value)

    @property
    def name(self):
        return self.__source

    def perform(self, context: launch.LaunchContext) -> Text:
        perform = launch.utilities.perform_substitutions
        with open(perform(context, self.name)) as file:
            data = yaml.safe_load(file)
        for name, value in self.text.items():
            data["/**"]["ros__parameters"][name] = perform(context, value)
        with tempfile.NamedTemporaryFile(mode="w", delete=False) as made:
            yaml.dump(data, made)
        return made.name


class Upper(launch.Substitution):
    def __init__(self, given):
        super().__init__()
        self.given = given

    def perform(self, context):
        return context.perform_substitution(self.given).upper()
"""
BEGIN = """
from launch import LaunchDescription, Substitution
from launch.actions import (
    DeclareLaunchArgument, GroupAction, OpaqueFunction, SetEnvironmentVariable,
    SetLaunchConfiguration,
)
from launch.conditions import IfCondition
from launch.substitutions import (
    EnvironmentVariable, LaunchConfiguration, PathJoinSubstitution, PythonExpression,
    TextSubstitution,
)
from launch_ros.actions import Node
from launch_ros.descriptions import ParameterFile
from launch_ros.substitutions import FindPackageShare
from mine_common.changes import Changed, Upper


def generate_launch_description():
    team = LaunchConfiguration("team")
    return LaunchDescription([
        DeclareLaunchArgument("team", default_value="red"),
        {}
    ])
"""
FILE = 'PathJoinSubstitution([FindPackageShare("mine"), "config", "robot.yaml"])'


@pytest.fixture
def workspace(root: Path) -> Path:
    package = root / "src" / "common"
    (package / "mine_common").mkdir(parents=True)
    (package / "package.xml").write_text(PACKAGE.format("common"))
    (package / "mine_common" / "__init__.py").touch()
    (package / "mine_common" / "changes.py").write_text(MODULE)
    (package / "setup.py").write_text(
        "from setuptools import setup\nsetup(name='common', packages=['mine_common'])\n"
    )
    config = root / "src" / "mine" / "config" / "robot.yaml"
    config.parent.mkdir()
    config.write_text("/**:\n  ros__parameters: {size: 1, team: none, place: $(var team)}\n")
    return root


def started(root: Path, text: str) -> tuple[list[Node], list[str]]:
    (root / "x.launch.py").write_text(text)
    return nodes(root, "x.launch.py")


def parameters(root: Path, text: str) -> list[dict[str, object]]:
    found, problems = started(root, text if "import" in text else BEGIN.format(text))
    assert problems == []
    return [
        {name: yaml.safe_load(value) for name, value in node.parameters.items()} for node in found
    ]


def test_a_parameter_file_with_other_values(workspace: Path) -> None:
    made = f'ParameterFile(Changed({FILE}, {{"team": team}}), allow_substs=True)'
    one, two = parameters(
        workspace,
        f'Node(package="p", executable="x", parameters=[{made}]),'
        'SetLaunchConfiguration("team", "blue"),'
        f'Node(package="p", executable="x", parameters=[{made}]),',
    )
    assert one == {"size": 1, "team": "red", "place": "red"}
    assert two == {"size": 1, "team": "blue", "place": "blue"}


@pytest.mark.parametrize(
    "given",
    [
        'parameters=[Changed({}, {{"team": Upper(team)}})]',
        'parameters=[Changed({}, {{"team": [TextSubstitution(text="RE"), Upper("d")]}})]',
        'arguments=["--ros-args", "--params-file", Changed({}, {{"team": "RED"}})]',
        'parameters=[{}, {{"team": Upper(team)}}]',
        'parameters=[{}, {{"team": PythonExpression(["\'", Upper(team), "\' + \'\'"])}}]',
    ],
)
def test_they_are_part_of_others(workspace: Path, given: str) -> None:
    found, problems = started(
        workspace, BEGIN.format(f'Node(package="p", executable="x", {given.format(FILE)})')
    )
    assert problems == []
    assert "team:='RED'" in " ".join(found[0].command_line())
    assert "size:=1" in " ".join(found[0].command_line())


def test_the_environment(workspace: Path) -> None:
    found = parameters(
        workspace,
        'SetEnvironmentVariable("COLOR", "green"),'
        'Node(package="p", executable="x",'
        '     parameters=[{"a": Upper(EnvironmentVariable("COLOR"))}])',
    )
    assert found == [{"a": "GREEN"}]


def test_functions_use_them(workspace: Path) -> None:
    text = BEGIN.format("OpaqueFunction(function=later)") + (
        "\n\ndef later(context):\n"
        '    now = Upper(LaunchConfiguration("team"))\n'
        '    return [Node(package="p", executable="x",\n'
        '                 parameters=[{"a": now, "b": now.perform(context)}])]\n'
    )
    assert parameters(workspace, text) == [{"a": "RED", "b": "RED"}]


def test_conditions_use_them(workspace: Path) -> None:
    condition = "IfCondition(PythonExpression([\"'\", Upper(team), \"' == 'RED'\"]))"
    actions = f'Node(package="p", executable="x", condition={condition}),'
    assert parameters(workspace, actions) == [{}]


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("return 3", "Own: perform() returned int, not str"),
        ("return {}['nothing']", "Own: KeyError: 'nothing'"),
        ("return context.perform_substitution(LaunchConfiguration('none'))", "argument 'none'"),
        ("return tempfile.nothing", "Own: NameError: name 'tempfile' is not defined"),
        (None, "Own: NotImplementedError: it has no method perform()"),
    ],
)
def test_what_fails_is_said_where_it_is_used(
    workspace: Path, body: str | None, expected: str
) -> None:
    own = f"\n\nclass Own(Substitution):\n    def perform(self, context):\n        {body}\n"
    actions = 'Node(package="p", executable="x", parameters=[{"a": Own()}]),'
    text = BEGIN.format(actions) + (own if body else "\n\nclass Own(Substitution):\n    pass\n")
    found, (problem,) = started(workspace, text)
    assert found == []
    assert f":{text[: text.index('Own()')].count(chr(10)) + 1}: node: " in problem
    assert expected in problem


@pytest.mark.parametrize(
    "given", ["arguments=[{}]", 'parameters=[{{"file": {}}}]', 'additional_env={{"FILE": {}}}']
)
def test_what_is_written_is_no_file_of_the_page(workspace: Path, given: str) -> None:
    made = f"Changed({FILE}, {{}})"
    text = BEGIN.format(f'Node(package="p", executable="x", {given.format(made)})')
    found, (problem,) = started(workspace, text)
    assert found == []
    expected = "node: the page has a file that a launch file writes only as parameters"
    assert problem.endswith(expected)


def test_no_files_remain(workspace: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    monkeypatch.setattr("tempfile.tempdir", None)
    made = f'Node(package="p", executable="x", parameters=[Changed({FILE}, {{"team": team}})])'
    assert parameters(workspace, made)[0]["team"] == "red"
    assert [*folder.iterdir()] == []
