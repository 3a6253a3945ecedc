"""The packages that a workspace lacks."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from sitegen.__main__ import main
from sitegen.commands.missing import vcs
from sitegen.workspace.repositories import TABLE, repository

FOUND = "".join(f"find_package({name} REQUIRED)\n" for name in ("rclcpp", "filters", "acme_base"))


def package(folder: Path, name: str, cmake: str, *depends: str) -> None:
    tags = "".join(f"<depend>{each}</depend>" for each in depends)
    place = folder / "src" / name
    place.mkdir(parents=True)
    (place / "package.xml").write_text(f"<package format='3'><name>{name}</name>{tags}</package>")
    (place / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.8)\nproject({name})\n{cmake}"
    )


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    package(tmp_path, "laser", FOUND, "rclcpp", "filters", "acme_base")
    package(tmp_path, "lidar", "find_package(filters REQUIRED)\n", "filters")
    return tmp_path


def test_packages_are_listed_with_what_to_do(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["missing", str(folder)]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "'filters', needed by 'laser', 'lidar': "
        "git clone -b ros2 https://github.com/ros/filters.git",
        "'acme_base', needed by 'laser': sitegen does not know where its sources are",
        "2 packages missing",
        "clone their sources with:  sitegen missing --vcs | vcs import src",
    ]


def test_packages_that_ament_cmake_auto_finds_are_listed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cmake = "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\n"
    names = ("rclcpp", "filters", "libncurses-dev", "launch_ros", "acme_base")
    package(tmp_path, "laser", cmake, *names)
    assert main(["missing", str(tmp_path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line for line in lines if "needed by" in line] == [
        "'filters', needed by 'laser': git clone -b ros2 https://github.com/ros/filters.git"
    ]


def test_packages_of_ros_1_are_named_and_need_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package(tmp_path, "old", "find_package(catkin REQUIRED)\n", "catkin")
    file = tmp_path / "src/old/package.xml"
    kind = "<export><build_type>catkin</build_type></export></package>"
    file.write_text(file.read_text().replace("</package>", kind))
    assert main(["missing", str(tmp_path)]) == 0
    assert capsys.readouterr().out.splitlines() == ["no package is missing"]
    package(
        tmp_path, "new", "add_executable(new new.cpp)\ninstall(TARGETS new DESTINATION lib/new)\n"
    )
    (tmp_path / "src/new/new.cpp").write_text("int main() {}\n")
    assert main(["init", str(tmp_path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "  old: is for ROS 1 (catkin); use its version for ROS 2" in lines


def test_a_file_for_vcs_has_each_repository_once(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package(
        folder,
        "bonds",
        "find_package(bond REQUIRED)\nfind_package(smclib REQUIRED)\n",
        "bond",
        "smclib",
    )
    assert main(["missing", "--vcs", str(folder)]) == 0
    out = capsys.readouterr().out
    assert yaml.safe_load(out) == {
        "repositories": {
            f"ros/{name}": {
                "type": "git",
                "url": f"https://github.com/ros/{name}.git",
                "version": "ros2",
            }
            for name in ("bond_core", "filters")
        }
    }
    assert "# 'acme_base', needed by 'laser': sitegen does not know" in out


def test_nothing_is_missing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["missing", str(tmp_path)]) == 1
    assert "no ROS package found; give the folder of a workspace" in capsys.readouterr().err
    package(tmp_path, "base", "find_package(urdf REQUIRED)\n", "urdf")
    assert main(["missing", str(tmp_path)]) == 0
    assert capsys.readouterr().out == "no package is missing\n"
    assert main(["missing", "--vcs", str(tmp_path)]) == 0
    assert capsys.readouterr().out == "repositories: {}\n"


def test_settings_of_builds_decide_what_is_needed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cmake = 'option(LASER "" OFF)\nif(LASER)\n  find_package(filters REQUIRED)\nendif()\n'
    package(tmp_path, "laser", cmake, "filters")
    assert main(["missing", str(tmp_path)]) == 0
    assert capsys.readouterr().out == "no package is missing\n"
    (tmp_path / "site.yaml").write_text("build: {laser: {cmake: [-DLASER=ON]}}\n")
    assert main(["missing", str(tmp_path)]) == 0
    assert capsys.readouterr().out.startswith("'filters', needed by 'laser': ")


@pytest.mark.parametrize("command", [["missing"], ["compile", "laser/laser", "--workspace"]])
@pytest.mark.parametrize(
    ("build", "said"),
    [
        ("{lasr: {}}", "build.lasr: no package 'lasr' in the workspace; did you mean 'laser'?"),
        ("{laser: {cmake: [LASER]}}", "'LASER' is not a definition; write it like '-DLASER=ON'"),
        ("[laser]", "build: expected packages with keys and values each, found a list"),
    ],
)
def test_settings_are_checked_by_commands_that_read_nothing_else_of_site_yaml(
    tmp_path: Path, command: list[str], build: str, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    package(tmp_path, "laser", "add_executable(laser laser.cpp)\n")
    (tmp_path / "site.yaml").write_text(f"build: {build}\n")
    assert main([*command, str(tmp_path)]) == 1
    assert said in capsys.readouterr().err


def test_each_line_of_the_table_is_a_repository() -> None:
    lines = [each for each in TABLE.read_text().splitlines() if not each.startswith("#")]
    assert lines == sorted(lines)
    names = [name for line in lines for name in line.split(" ")[2:]]
    assert len(names) == len(set(names)) > 2000
    assert all(line.startswith("https://") for line in lines)
    found = repository("nav2_msgs")
    assert found
    assert found.name == "ros-planning/navigation2"


def test_two_branches_of_a_repository_are_cloned_side_by_side() -> None:
    # The older branch has a package that the newer one lacks.
    names = ("velodyne_description", "velodyne_gazebo_plugins")
    one, other = map(repository, names)
    assert one and other and one.name == other.name and one.branch != other.branch
    cloned = yaml.safe_load(vcs({name: ["arm"] for name in names}))["repositories"]
    assert list(cloned) == [one.name, f"{other.name}-{other.branch}"]
    assert {each["version"] for each in cloned.values()} == {one.branch, other.branch}
