"""The pages that `sitegen init` writes for robots that nothing starts."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from sitegen import config
from sitegen.__main__ import main
from sitegen.model import Page, Site, Widget

MANIFEST = (
    "<package><name>fox</name><description>{0}</description>"
    "<export><build_type>ament_cmake</build_type></export></package>"
)
XACRO = '<robot name="{0}" xmlns:xacro="http://www.ros.org/wiki/xacro">{1}</robot>'
LINK = '<link name="base"/>'
ARGUMENT, LEG = '<xacro:arg name="leg" default="1"/>', '<link name="leg$(arg leg)"/>'


def urdf(name: str, joint: str = "") -> str:
    """The description of a robot, with a joint of this type or without one."""
    ends = '<parent link="base"/><child link="tail"/>'
    limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    more = f'<link name="tail"/><joint name="wag" type="{joint}">{ends}{limit}</joint>'
    return f'<robot name="{name}">{LINK}{more if joint else ""}</robot>'


def write(root: Path, files: Mapping[str, str], description: str = "A fox. It wags.") -> None:
    manifest = {"package.xml": MANIFEST.format(description), "CMakeLists.txt": "project(fox)\n"}
    for name, text in {**manifest, **files}.items():
        file = root / "src/fox" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def written(root: Path, files: Mapping[str, str]) -> Site:
    """The site that init writes for a package with these files."""
    write(root, files)
    assert main(["init", str(root)]) == 0
    site = config.load(root / "site.yaml")
    assert site.notes == ()
    return site


def widgets(page: Page) -> dict[str, Widget]:
    return {each.kind: each for each in page.leaves if isinstance(each, Widget)}


def test_a_robot_that_nothing_starts_is_shown_and_moved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    [page] = written(tmp_path, {"urdf/fox.urdf": urdf("fox", "revolute")}).pages
    assert (page.path, page.title) == ("", "A fox")
    [node] = page.nodes.values()
    assert (node.package, node.executable) == ("robot_state_publisher",) * 2
    assert '<joint name="wag" type="revolute">' in node.parameters["robot_description"]
    shown = widgets(page)
    assert {"3d", "joints", "tf"} <= shown.keys()
    assert shown["topics"].options["echo"] == "/joint_states"
    assert shown["buttons"].options["autostart"] is True
    assert "  /  fox.urdf\n" in capsys.readouterr().out
    assert "urdf: src/fox/urdf/fox.urdf" in (tmp_path / "site.yaml").read_text(encoding="utf-8")


def test_a_robot_without_moving_joints_has_no_sliders(tmp_path: Path) -> None:
    [page] = written(tmp_path, {"fox.urdf": urdf("fox", "fixed")}).pages
    assert "3d" in widgets(page)
    assert not {"joints", "topics"} & widgets(page).keys()


def test_each_robot_of_a_package_has_a_page_and_only_one(tmp_path: Path) -> None:
    files = {
        "urdf/big.urdf": urdf("big_fox"),
        "urdf/small.urdf.xacro": XACRO.format("small_fox", LINK),
        # The same robot in two files, of which the one without xacro needs less.
        "robots/big.urdf.xacro": XACRO.format("big_fox", LINK),
        "test/other.urdf": urdf("other"),
    }
    site = written(tmp_path, files)
    assert {page.path: page.title for page in site.pages[1:]} == {
        "fox/big/": "big_fox",
        "fox/small/": "small_fox",
    }
    home = (tmp_path / "site.yaml").read_text(encoding="utf-8")
    assert "- [big\\_fox](fox/big/) big.urdf" in home or "- [big_fox](fox/big/) big.urdf" in home


def test_a_package_has_pages_for_its_nodes_and_its_robot(tmp_path: Path) -> None:
    files = {
        "urdf/fox.urdf": urdf("fox"),
        "CMakeLists.txt": "project(fox)\nadd_executable(run src/run.cpp)\n",
        "src/run.cpp": "int main() {}\n",
    }
    site = written(tmp_path, files)
    assert {page.path: [*page.nodes] for page in site.pages[1:]} == {
        "fox/": ["run"],
        "fox/fox/": ["robot_state_publisher"],
    }


def test_the_page_of_a_robot_runs_the_programs_that_move_it(tmp_path: Path) -> None:
    source = (
        '#include "rclcpp/rclcpp.hpp"\n#include "sensor_msgs/msg/joint_state.hpp"\n'
        "int main() {{\n"
        '  auto node = std::make_shared<rclcpp::Node>("{0}");\n'
        '  auto joints = node->create_publisher<sensor_msgs::msg::JointState>("{1}", 10);\n}}\n'
    )
    files = {
        "urdf/fox.urdf": urdf("fox", "revolute"),
        "CMakeLists.txt": "project(fox)\nadd_executable(wag src/wag.cpp)\n"
        "add_executable(other src/other.cpp)\n",
        "src/wag.cpp": source.format("wag", "joint_states"),
        "src/other.cpp": source.format("other", "commands"),
    }
    # One page for both programs, and one for the robot.
    site = written(tmp_path / "both", files)
    page = site.pages[-1]
    assert [*page.nodes] == ["robot_state_publisher", "wag"]
    shown = widgets(page)
    # Sliders would work against the program.
    assert "3d" in shown
    assert "joints" not in shown
    assert shown["topics"].options["echo"] == "/joint_states"
    assert [*site.pages[1].nodes] == ["wag", "other"]
    # A program that is on the page of the robot has no other page.
    del files["src/other.cpp"]
    files["CMakeLists.txt"] = "project(fox)\nadd_executable(wag src/wag.cpp)\n"
    [page] = written(tmp_path / "one", files).pages
    assert [*page.nodes] == ["robot_state_publisher", "wag"]


def test_parts_of_robots_have_no_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    macro = '<xacro:macro name="leg" params="n"><link name="leg${n}"/></xacro:macro>'
    include = '<xacro:include filename="$(find fox)/urdf/leg.xacro"/>'
    whole = include + '<xacro:include filename="body.xacro"/><xacro:leg n="1"/>'
    joint = '<joint name="hip" type="fixed"><parent link="base"/><child link="leg1"/></joint>'
    files = {
        "urdf/fox.urdf.xacro": XACRO.format("fox", whole + joint),
        "urdf/leg.xacro": XACRO.format("leg", macro),
        # A robot by itself, but another file shows it.
        "urdf/body.xacro": XACRO.format("body", LINK),
        # Nobody includes these: macros, half of a robot, and what is no robot.
        "urdf/unused.xacro": XACRO.format("unused", macro),
        "urdf/half.urdf": urdf("half", "fixed").replace(LINK, ""),
        "urdf/broken.urdf": "<robot name='broken'>",
        "urdf/world.xacro": "<sdf/>",
    }
    [page] = written(tmp_path, files).pages
    assert "urdf: src/fox/urdf/fox.urdf.xacro" in (tmp_path / "site.yaml").read_text()
    assert '<link name="leg1"/>' in page.nodes["robot_state_publisher"].parameters[
        "robot_description"
    ].replace("\\", "")
    assert "skipped" not in capsys.readouterr().out


def test_xacro_that_needs_arguments_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {
        "urdf/any.urdf.xacro": XACRO.format("any", LEG),
        "urdf/fox.urdf.xacro": XACRO.format("fox", ARGUMENT + LEG),
    }
    [page] = written(tmp_path, files).pages
    assert page.title == "A fox"
    said = capsys.readouterr().out
    [line] = [line for line in said.splitlines() if "any.urdf" in line]
    assert line.startswith("  skipped: src/fox/urdf/any.urdf.xacro: xacro: any.urdf.xacro: Undef")
    assert line.endswith("; a launch file can give it what it needs")


def test_a_robot_that_a_launch_file_starts_has_no_other_page(tmp_path: Path) -> None:
    description = "$(command 'xacro $(find-pkg-share fox)/urdf/fox.urdf.xacro')"
    files = {
        "urdf/fox.urdf.xacro": XACRO.format("fox", LINK),
        "urdf/den.urdf": urdf("den"),
        "launch/fox.launch.xml": '<launch><node pkg="robot_state_publisher" '
        'exec="robot_state_publisher"><param name="robot_description" type="str" '
        f'value="{description}"/></node></launch>',
    }
    site = written(tmp_path, files)
    assert [page.path for page in site.pages[1:]] == ["fox/fox/", "fox/den/"]


def test_a_package_of_very_many_robots_has_some_pages(tmp_path: Path) -> None:
    site = written(tmp_path, {f"urdf/fox{n}.urdf": urdf(f"fox{n}") for n in range(9)})
    assert len(site.pages) == 7
    assert "urdf/fox8.urdf" in (tmp_path / "site.yaml").read_text(encoding="utf-8")
