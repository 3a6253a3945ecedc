"""Parameters of nodes in site.yaml."""

from __future__ import annotations

from pathlib import Path

from sitegen.config import parameters
from sitegen.config.document import Value, parse
from sitegen.errors import Location, Problems


def value(text: str, problems: Problems) -> Value:
    found = parse(text, Location(Path("site.yaml"), 1), problems, key="parameters")
    assert found
    return found


def read(text: str) -> tuple[dict[str, str], list[str]]:
    problems = Problems(Path())
    found = parameters.read(value(text, problems), problems)
    return found, problems.lines


def test_values_are_what_ros_reads_from_a_command_line() -> None:
    found, wrong = read(
        """\
        speed: 2.5
        count: -3
        small: 1e-3
        fast: true
        name: it's r2
        quoted: "4"
        list: [1, 2]
        words: [a, "b"]
        arm: {joints: 6, limits: {upper: 1.5}}
        """
    )
    assert wrong == []
    assert found == {
        "speed": "2.5",
        "count": "-3",
        "small": "0.001",
        "fast": "true",
        "name": "'it''s r2'",
        "quoted": "'4'",
        "list": "[1, 2]",
        "words": "['a', 'b']",
        "arm.joints": "6",
        "arm.limits.upper": "1.5",
    }


def test_what_is_no_parameter_is_told_with_its_line() -> None:
    _, wrong = read("a b: 1\nnone:\nmixed: [1, two]\nempty: []\nnested: [[1]]\n")
    assert wrong == [
        "site.yaml:1: parameters.a b: "
        "'a b' is not a valid parameter name; use letters, digits, '_' and '.'",
        "site.yaml:2: parameters.none: "
        "expected a boolean, a number, a string or a list of these, found nothing",
        "site.yaml:3: parameters.mixed: "
        "all values of a list must have the same type, found integer and string",
        "site.yaml:4: parameters.empty: an empty list has no type; remove it",
        "site.yaml:5: parameters.nested[0]: "
        "expected a boolean, a number, a string or a list of these, found a list",
    ]


def test_files_of_parameters_come_in_their_order(tmp_path: Path) -> None:
    (tmp_path / "robot.yaml").write_text(
        "/**:\n  ros__parameters: {speed: 1.0, name: 'on'}\n"
        "arm:\n  left:\n    ros__parameters: {joints: {count: 6}}\n"
    )
    problems = Problems(tmp_path)
    listed = parse(
        "[robot.yaml, {speed: 2.0}, robot.yaml]", Location(Path("x"), 1), problems, key="p"
    )
    assert listed
    assert list(parameters.read(listed, problems).items()) == [
        ("speed", "1.0"),
        ("name", "'on'"),
        ("/arm/left:joints.count", "6"),
    ]
    words = parse(
        "[-v, --ros-args, --params-file, robot.yaml, -r, a:=b]", Location(Path("x"), 1), problems
    )
    assert words
    assert parameters.arguments(words, problems) == (
        *("-v", "--ros-args", "-p", "speed:=1.0", "-p", "name:='on'"),
        *("-p", "/arm/left:joints.count:=6", "-r", "a:=b"),
    )
    assert problems.lines == []


def test_files_that_are_none_are_told(tmp_path: Path) -> None:
    (tmp_path / "list.yaml").write_text("[1]\n")
    problems = Problems(tmp_path)
    listed = parse("- no.yaml\n- list.yaml\n- 3\n", Location(Path("x"), 1), problems, key="p")
    assert listed
    parameters.read(listed, problems)
    assert [line.split(": ", 1)[1] for line in problems.lines] == [
        "p[0]: no file 'no.yaml'; did you mean 'list.yaml'?",
        "p[1]: 'list.yaml' (line 1): expected names of nodes, like '/**:'",
        "p[2]: expected a file or a mapping of names to values, found the number 3",
    ]
