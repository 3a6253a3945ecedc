"""Files that others wrote, whatever is in them: a line for each problem, and an end."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from sitegen import rclyaml, yamlnodes
from sitegen.build import make
from sitegen.commands.check import check
from sitegen.errors import SiteError
from sitegen.report import Report

PACKAGE = """<package format="3"><name>{}</name><version>1.0.0</version>
<description>d</description><maintainer email="a@b.c">a</maintainer><license>x</license>{}
<export><build_type>{}</build_type></export></package>"""
NODE = {
    "src/p/package.xml": PACKAGE.format("p", "", "ament_python"),
    "src/p/setup.py": "from setuptools import setup\n"
    "setup(name='p', packages=['p'], entry_points={'console_scripts': ['n = p.n:main']})\n",
    "src/p/p/__init__.py": "",
    "src/p/p/n.py": "def main():\n    print(1)\n",
    "site.yaml": "site: {title: A}\nnodes: {n: {package: p, executable: n}}\n"
    "pages: [{path: /, title: A, content: [console: n]}]\n",
}
WITH_FILE = {
    **NODE,
    "site.yaml": "site: {title: A}\n"
    "nodes: {n: {package: p, executable: n, parameters: [p.yaml]}}\n"
    "pages: [{path: /, title: A, content: [console: n]}]\n",
}
LAUNCH = {
    **NODE,
    "site.yaml": "site: {title: A}\npages: [{path: /, title: A, launch: l.launch.xml}]\n",
}
BOMB = "".join(
    f"  {name}: &{name} [{', '.join([f'*{before}' if before else 'x'] * 10)}]\n"
    for before, name in zip(["", *"abcdefghi"], "abcdefghij", strict=True)
)


def workspace(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return folder


def problems(folder: Path) -> list[str]:
    with pytest.raises(SiteError) as caught:
        check(folder, Report(io.StringIO()))
    return caught.value.lines


@pytest.mark.parametrize("text", ["*.png", "[", "@", "it's", "a\nb", "a: b", "", "# no", "\x07"])
def test_a_parameter_may_be_any_text(text: str) -> None:
    written = rclyaml.written(text)
    assert "\n" not in written
    assert rclyaml.value(written) == text


@pytest.mark.parametrize("text", ["[" * 101, "{a: " * 101, "- " * 101 + "a", "x" * 4_000_001])
def test_events_of_yaml_have_limits(text: str) -> None:
    with pytest.raises(yamlnodes.LimitError):
        yamlnodes.events(text)


@pytest.mark.parametrize("value", [["a\nb", "c, d", "[", "it's"], [1.0, 2.5], [True], None, 3])
def test_a_parameter_may_be_a_list(value: rclyaml.Value) -> None:
    written = rclyaml.written(value)
    assert "\n" not in written
    assert rclyaml.value(written) == value


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ("n: &a\n  ros__parameters: *a\n", " (line 2): ROS does not support aliases like '*a'"),
        (f"n:\n{BOMB}", " (line 2): 'a' has a value, but is not below 'ros__parameters'"),
        (f"n: {'[' * 1000}", " is not valid YAML: nested too deeply in line 1; flatten it"),
        ("n: {a: 2026-02-31}", " (line 1): 'a' has a value, but is not below 'ros__parameters'"),
        ("n: " + "x" * 5_000_000, " is not valid YAML: larger than 4 MB"),
    ],
)
def test_a_file_of_parameters(tmp_path: Path, values: str, expected: str) -> None:
    [line] = problems(workspace(tmp_path, {**WITH_FILE, "p.yaml": values}))
    assert line == f"site.yaml:2: nodes.n.parameters[0]: 'p.yaml'{expected}"


@pytest.mark.parametrize(
    ("site", "expected"),
    [
        (f"site:\n{BOMB}", "yaml: aliases repeat more than 100000 values"),
        ("site: &a {title: *a}\n", "site.yaml:1: yaml: an alias stands for itself"),
        ("site: " + "[" * 3000, "site.yaml:1: yaml: nested too deeply; flatten it"),
        ("site:\n" + "".join(" " * i + "- \n" for i in range(300)), "nested too deeply"),
    ],
)
def test_site_yaml(tmp_path: Path, site: str, expected: str) -> None:
    [line] = problems(workspace(tmp_path, {"site.yaml": site}))
    assert expected in line


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<?xml version='1.0' encoding='foo'?><launch/>", "unknown encoding: foo; save the file"),
        ("<launch>" * 1000, "nested too deeply"),
        (
            "<launch><function/></launch>",
            "function: only launch files in Python contain 'function'",
        ),
        ("<launch><function number='x'/></launch>", "function: only launch files in Python"),
    ],
)
def test_a_launch_file(tmp_path: Path, text: str, expected: str) -> None:
    [line] = problems(workspace(tmp_path, {**LAUNCH, "l.launch.xml": text}))
    assert line.startswith("l.launch.xml:1: ")
    assert expected in line


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ("packages=3", "packages: expected a list of names"),
        ("packages='p'", "packages: expected a list of names"),
        ("packages=['p'], package_dir=['src']", "package_dir: expected a mapping of packages"),
        ("packages=['p'], package_data={'p': ['/etc/*']}", "package_data: expected a mapping"),
        ("packages=['p'], data_files=['a']", "data_files: expected a list of pairs"),
        ("packages=['p'], scripts=['a\\0b']", "scripts: expected a list of relative paths"),
        ("packages=['p'], entry_points=['n']", "entry_points: expected a mapping of groups"),
        ("packages=['p'], entry_points='n = p'", "entry_points: File contains no section headers"),
        ("packages=" + "(" * 5000, "not valid Python: "),
    ],
)
def test_a_setup_file(tmp_path: Path, arguments: str, expected: str) -> None:
    setup = f"from setuptools import setup\nsetup(name='p', {arguments})\n"
    lines = problems(workspace(tmp_path, {**NODE, "src/p/setup.py": setup}))
    assert [line for line in lines if line.startswith("src/p/setup.py:") and expected in line]


@pytest.mark.parametrize("text", ["project = 3\n", "tool = 3\n", "[tool]\nsetuptools = 3\n"])
def test_a_project_file_without_tables(tmp_path: Path, text: str) -> None:
    check(workspace(tmp_path, {**NODE, "src/p/pyproject.toml": text}), Report(io.StringIO()))


def test_a_constant_with_a_lower_case_letter(tmp_path: Path) -> None:
    member = "<member_of_group>rosidl_interface_packages</member_of_group>"
    files = {
        "src/q/package.xml": PACKAGE.format("q", member, "ament_cmake"),
        "src/q/CMakeLists.txt": "cmake_minimum_required(VERSION 3.8)\nproject(q)\n"
        "find_package(rosidl_default_generators REQUIRED)\n"
        "rosidl_generate_interfaces(q msg/A.msg)\nament_package()\n",
        "src/q/msg/A.msg": f"uint8 {'A' * 60}a=1\n",
        "src/p/package.xml": PACKAGE.format("p", "<depend>q</depend>", "ament_python"),
        "src/p/p/n.py": "from q.msg import A\n\n\ndef main():\n    print(A)\n",
    }
    [line] = problems(workspace(tmp_path, {**NODE, **files}))
    assert line.startswith(f"src/q/msg/A.msg:1: '{'A' * 60}a' is an invalid constant name")


FLOW = "```mermaid\nflowchart LR\n{}\n```\n"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("$" + "(" * 50 + "$", "formula: too complex, or a brace or a parenthesis is not closed"),
        ("$$" + "x^{" * 5000 + "$$", "formula: too complex, or a brace or a parenthesis"),
        ("- " * 1000 + "a", "markdown: nested too deeply; flatten it"),
        (FLOW.format(" & ".join(f"a{i}" for i in range(300))), "at most 200 boxes and 500 arrows"),
        (
            FLOW.format(" --> ".join(" & ".join(f"{k}{i}" for i in range(99)) for k in "ab")),
            "too large; at most 200 boxes and 500 arrows are supported",
        ),
        (
            "```mermaid\nsequenceDiagram\n" + "a ->> b: x\n" * 600 + "```\n",
            "too large; at most 200 participants and 500 messages are supported",
        ),
    ],
)
def test_a_page_of_text(tmp_path: Path, text: str, expected: str) -> None:
    site = "site: {title: A}\npages: [{path: /, file: a.md}]\n"
    folder = workspace(tmp_path, {"site.yaml": site, "a.md": f"# A\n\n{text}\n"})
    with pytest.raises(SiteError) as caught:
        make(folder, Report(io.StringIO()))
    [line] = caught.value.lines
    assert line.startswith("a.md:")
    assert expected in line


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('<META http-equiv="refresh" content="0;url=https://e.vil/">', ["'<meta>' is not"]),
        ("<SCRIPT>alert(1)</SCRIPT>", ["'<script>' is not allowed"]),
        ('<img src="a.svg" alt="" OnError=alert(1)>', ["'OnError=' is not allowed"]),
        ("<p/onclick=alert(1)>", ["'onclick=' is not allowed"]),
        (
            '<svg><a xlink:href=" java&#x0a;script:alert(1)"><text>a</text></a></svg>',
            ["'href' cannot run a script"],
        ),
        ("<a href=javascript:alert(1)>x</a>", ["a link cannot run a script"]),
        ('<button formaction="https://e.vil">x</button>', ["'formaction=' is not allowed"]),
        ('<img src="a.svg" alt="" srcset="https://e.vil/a.png 1x">', ["is on another site"]),
        ("<body onload=alert(1)>", ["'<body>' is not allowed"]),
        ("Hello\n{: onclick='x()' }", ["'onclick=' is not allowed"]),
        ("<svg><style>a { color: red }</style></svg>", ["'<style>' is not allowed"]),
    ],
)
def test_html_that_the_policy_stops(tmp_path: Path, text: str, expected: list[str]) -> None:
    files = {
        "site.yaml": "site: {title: A}\npages: [{path: /, file: a.md}]\n",
        "a.md": f"# A\n\n{text}\n",
        "a.svg": '<svg xmlns="http://www.w3.org/2000/svg"/>',
    }
    lines = problems(workspace(tmp_path, files))
    assert [part for part in expected if not any(part in line for line in lines)] == []
    assert all(line.startswith("a.md:") for line in lines)


def test_html_that_harms_nobody(tmp_path: Path) -> None:
    text = """
`<script onclick="x">` and `std::vector<std::string>`

```html
<script>alert(1)</script>
```

<!-- <script>alert(1)</script> -->

<svg viewBox="0 0 1 1"><title>A dot</title><circle r="1"/></svg>

<details><summary>More</summary>Press <kbd>Ctrl</kbd>.</details>
"""
    files = {
        "site.yaml": "site: {title: A}\npages: [{path: /, file: a.md}]\n",
        "a.md": f"# A\n{text}",
    }
    assert check(workspace(tmp_path, files), Report(io.StringIO()))[1] == []
