"""Launch files that are wrong: each problem is reported with its line."""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import nodes

from sitegen.config import load
from sitegen.errors import SiteError


def fault(root: Path, name: str, text: str) -> str:
    """Return the first problem of a launch file that starts nothing, without the file's name."""
    (root / name).write_text(text)
    found, [line, *_] = nodes(root, name)
    assert found == []
    assert line.startswith(f"{name}:")
    return line.removeprefix(f"{name}:")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<launch><node pkg='a'></launch>", "launch: mismatched tag; check the tags here"),
        ("<robot/>", "launch: expected <launch>, found <robot>"),
        ("<!DOCTYPE x><launch/>", "launch: a document type declaration is not allowed"),
        ("<launch><node pkg='a'/></launch>", "node: 'exec' is missing"),
        (
            "<launch><nod pkg='a'/></launch>",
            "nod: this action is not supported in the browser; did you mean",
        ),
        ("<launch><let name='x' value='$(eval 1/0)'/></launch>", "let: '1/0' is not a valid"),
        ("<launch><let name='x' value='$(eval open)'/></launch>", "let: 'open' is not a valid"),
        ("<launch><let name='x' value='$(eval 9**9**9)'/></launch>", "let: '9**9**9': the value"),
        (
            "<launch><let name='x' value='$(env HOME)'/></launch>",
            "let: environment variable 'HOME' is not read, because the page would publish",
        ),
        (
            "<launch><let name='x' value='$(file-content /etc/hostname)'/></launch>",
            "let: '/etc/hostname' is outside the workspace",
        ),
        (
            "<launch><let name='x' value='$(command &quot;cat /etc/hostname&quot;)'/></launch>",
            "let: '/etc/hostname' is outside the workspace",
        ),
        (
            "<launch><include file='$(filename)'/><include file='$(filename)'/></launch>",
            "include: launch files include each other",
        ),
        ("<launch><arg name='x'/></launch>", "arg: 'x' has no value; give one in 'launch_arg"),
        ("<launch><let name='x' value='$(var y)'/></launch>", "let: argument 'y' is not set"),
        ("<launch><let name='x' value='$(var y'/></launch>", "let: '$(var y' has an unclosed"),
        (
            "<launch><let name='x' value='$(command ls)'/></launch>",
            "let: $(command …) runs",
        ),
        (
            "<launch><node pkg='a' exec='b' if='perhaps'/></launch>",
            "node: 'perhaps' is not a boolean",
        ),
        (
            "<launch><include file='$(find-pkg-share other)/x.xml'/></launch>",
            "include: no package 'other' in the workspace; ",
        ),
        ("<launch><include file='/etc/x.xml'/></launch>", "include: '/etc/x.xml' is outside"),
        ("<launch><include file='$(dirname)/no.xml'/></launch>", "include: 'no.xml': No such"),
        ("<launch><include file='$(filename)'/></launch>", "include: launch files include each"),
        ("<launch><include file='$(dirname)/x.sh'/></launch>", "include: 'x.sh' is not a"),
        (
            "<launch><node pkg='a' exec='b'><param from='$(dirname)/no.yaml'/></node></launch>",
            "node: no file '",
        ),
    ],
)
def test_what_is_wrong_is_said_with_its_line(root: Path, text: str, expected: str) -> None:
    assert fault(root, "x.launch.xml", f"<?xml version='1.0'?>\n{text}\n").startswith(
        f"2: {expected}"
    )


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("launch: {node: {}}", "1: launch: expected a list"),
        ("- node:", "1: launch: expected one key, 'launch', with a list of actions"),
        ("launch:\n- node: {pkg: a}", "2: node: 'exec' is missing"),
        ("launch:\n- node: {pkg: a, exec: [b]}", "2: launch: 'exec' of 'node' must be a string"),
        ("launch: [", "2: launch: "),
    ],
)
def test_the_same_of_yaml(root: Path, text: str, expected: str) -> None:
    assert fault(root, "x.launch.yaml", f"{text}\n").startswith(expected)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "def generate(): pass",
            "1: launch: LookupError: no function generate_launch_description() found",
        ),
        ("import nowhere", "1: launch: ModuleNotFoundError: No module named 'nowhere'"),
        ("x = (\n", "1: launch: SyntaxError: '(' was never closed"),
        (
            "import os\nos._exit(0)",
            "1: launch: the launch file exited before it described anything",
        ),
        (
            "from launch import LaunchDescription\nfrom launch.actions import OpaqueFunction\n"
            "def generate_launch_description():\n"
            "  return LaunchDescription([OpaqueFunction(function=lambda _: 1 / 0)])\n",
            "4: launch: ZeroDivisionError: division by zero",
        ),
        (
            "from ament_index_python import get_package_share_directory as share\n"
            "def generate_launch_description():\n    return share('other')\n",
            "3: launch: PackageNotFoundError: no package 'other' in the workspace",
        ),
    ],
)
def test_the_same_of_python(root: Path, text: str, expected: str) -> None:
    assert fault(root, "x.launch.py", text).startswith(expected)


def test_the_workspace_has_to_have_what_is_launched(root: Path) -> None:
    (root / "x.launch.xml").write_text("<launch>\n<node pkg='mine' exec='twice'/>\n</launch>")
    (root / "site.yaml").write_text(
        "site: {title: A}\nnodes: {twice: {package: mine, executable: x}}\n"
        "pages: [{path: /, title: A, launch: x.launch.xml}]\n"
    )
    with pytest.raises(SiteError) as caught:
        load(root / "site.yaml")
    text = "\n".join(caught.value.lines)
    assert "launch: 'twice', which 'x.launch.xml' starts, is also a node in site.yaml" in text
    assert "x.launch.xml:2: node: package 'mine' is for ROS 1 (catkin)" in text
