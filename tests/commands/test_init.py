"""A site.yaml for a workspace that is there already."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from paths import ROOT

from sitegen import config
from sitegen.__main__ import main


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Two packages of demos, which both have a talker, and one with interfaces alone."""
    for source in ("demo03/src/cpp_pubsub", "demo05/src/cpp_chatter"):
        shutil.copytree(ROOT / "demos" / source, tmp_path / "src" / Path(source).name)
    shutil.copytree(
        ROOT / "tests/sites/services/src/calc_interfaces", tmp_path / "src/calc_interfaces"
    )
    return tmp_path


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


def test_a_workspace_becomes_a_site(workspace: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["init", str(workspace)]) == 0
    assert "/cpp_pubsub/  talker and listener" in capsys.readouterr().out
    site = config.load(workspace / "site.yaml")
    assert [page.path for page in site.pages] == ["", "cpp_chatter/", "cpp_pubsub/"]
    pubsub = site.pages[2]
    assert {name: node.executable for name, node in pubsub.nodes.items()} == {
        "talker": "talker",
        "listener": "listener",
    }
    assert site.notes == ()
    text = (workspace / "site.yaml").read_text()
    assert "# The nodes that the page runs." in text
    assert "# url: https://me.github.io/my-robot/" in text


def test_a_site_that_is_there_stays(workspace: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (workspace / "site.yaml").write_text("mine")
    assert main(["init", str(workspace)]) == 1
    assert "site.yaml already exists; remove or edit it" in capsys.readouterr().err
    assert (workspace / "site.yaml").read_text() == "mine"


def test_a_folder_with_nothing_to_run_is_told(
    tmp_path: Path, workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    assert main(["init", str(empty)]) == 1
    assert "no ROS package found in this folder" in capsys.readouterr().err
    assert main(["init", str(workspace / "src/calc_interfaces")]) == 1
    assert "no package has an executable that can run in the browser: calc_interfaces" in (
        capsys.readouterr().err
    )
    assert not (empty / "site.yaml").exists()
    old = "<package><name>old</name><buildtool_depend>catkin</buildtool_depend></package>"
    (empty / "package.xml").write_text(old)
    assert main(["init", str(empty)]) == 1
    said = capsys.readouterr().err.splitlines()
    assert "old: is for ROS 1 (catkin); use its version for ROS 2" in said


def test_launch_files_are_pages_as_far_as_they_run(
    workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = "<package><name>bringup</name></package>"
    python = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='cpp_pubsub', executable='%s')])\n"
    )
    files = {
        "src/bringup/package.xml": package,
        "src/bringup/launch/all.launch.py": python % "talker",
        "src/bringup/launch/all_launch.xml": '<launch><include file="all.launch.py"/></launch>',
        "src/bringup/launch/Sim/other_launch.py": python % "swimmer",
        "src/bringup/launch/look.launch.xml": '<launch><node pkg="rviz2" exec="rviz2"/></launch>',
        "src/bringup/launch/notes.txt": "",
        "src/cpp_pubsub/launch/on.launch.yaml": """\
launch:
  - node: {pkg: cpp_pubsub, exec: talker, name: left}
  - node: {pkg: cpp_pubsub, exec: listener}
""",
        "src/bringup/urdf/fox.urdf.xacro": "",
        "src/bringup/urdf/fox.urdf": "",
    }
    write(workspace, files)
    assert main(["init", str(workspace)]) == 0
    said = capsys.readouterr().out
    faults = [
        "src/bringup/launch/Sim/other_launch.py:4: node: package 'cpp_pubsub' has no executable "
        "'swimmer'; known: listener, talker",
        "src/bringup/launch/all_launch.xml:1: include: 'all.launch.py' is outside the folder of "
        "site.yaml",
        "src/bringup/launch/look.launch.xml: opens windows, but starts no node that can run in the "
        "browser",
    ]
    assert "  /cpp_pubsub/on/  src/cpp_pubsub/launch/on.launch.yaml\n" in said
    for fault in faults:
        assert f"  skipped: {fault}\n" in said
    site = config.load(workspace / "site.yaml")
    assert {page.path: list(page.nodes) for page in site.pages[3:]} == {
        "bringup/all/": ["talker"],
        "cpp_pubsub/on/": ["left", "listener"],
    }
    text = (workspace / "site.yaml").read_text()
    assert text[text.index("# Skipped, because it cannot run") :].splitlines() == [
        "# Skipped, because it cannot run in the browser as it is:",
        *(f"#   {fault}" for fault in faults),
        "",
        "# Robot descriptions, for nodes such as robot_state_publisher:",
        "#   bringup: urdf/fox.urdf, urdf/fox.urdf.xacro",
        "",
        "# Messages, services and actions that all nodes can use:",
        "#   calc_interfaces: srv/Divide.srv",
    ]


def test_libraries_that_the_workspace_has_are_not_missing(
    workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {
        "copies/package.xml": "<package><name>copies</name></package>",
        "copies/CMakeLists.txt": "project(copies)\nadd_executable(own own.cpp)\n",
        "copies/own.cpp": '#include "zmq.hpp"\n#include "cv_bridge/part.hpp"\nint main() {}\n',
        "copies/3rdparty/zmq/include/zmq.hpp": "",
        "cv_bridge/package.xml": "<package><name>cv_bridge</name></package>",
        "cv_bridge/CMakeLists.txt": "project(cv_bridge)\n",
        "cv_bridge/include/cv_bridge/part.hpp": "",
    }
    write(workspace / "src", files)
    assert main(["init", str(workspace)]) == 0
    assert "copies" not in "".join(
        line for line in capsys.readouterr().out.splitlines() if "skipped" in line
    )
    pages = {page.path: list(page.nodes) for page in config.load(workspace / "site.yaml").pages}
    assert ["own"] in pages.values()


def test_programs_that_need_what_no_page_has_are_left_out(
    workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {
        "package.xml": "<package><name>eyes</name></package>",
        "CMakeLists.txt": """\
project(eyes)
find_package(OpenCV REQUIRED)
add_executable(seer src/seer.cpp)
add_executable(blind src/blind.cpp)
add_library(parts src/camera.cpp)
rclcpp_components_register_node(parts PLUGIN "eyes::Camera" EXECUTABLE camera)
""",
        "include/eyes/lens.hpp": "#include <opencv2/core.hpp>\n",
        "src/seer.cpp": '#include "eyes/lens.hpp"\nint main() {}\n',
        "src/blind.cpp": "int main() {}\n",
        "src/camera.cpp": '#include "cv_bridge/cv_bridge.hpp"\n',
        "launch/see.launch.xml": '<launch><node pkg="eyes" exec="seer"/></launch>',
        "launch/rest.launch.xml": '<launch><node pkg="eyes" exec="blind"/></launch>',
        "launch/all.launch.xml": '<launch><node pkg="eyes" exec="blind" name="dim"/>'
        '<node pkg="eyes" exec="seer"/></launch>',
    }
    write(workspace / "src/eyes", files)
    assert main(["init", str(workspace)]) == 0
    said = capsys.readouterr().out
    assert "  /eyes/  blind\n" in said
    for fault in (
        "src/eyes: 'seer' needs 'OpenCV', which has no build for the page",
        "src/eyes: 'camera' needs 'cv_bridge', which has no build for the page",
        "src/eyes/launch/see.launch.xml: starts no node that can run in the browser",
    ):
        assert f"  skipped: {fault}\n" in said
    pages = {page.path: list(page.nodes) for page in config.load(workspace / "site.yaml").pages}
    assert pages["eyes/"] == pages["eyes/rest/"] == ["blind"]
    # The build leaves out what it cannot compile.
    assert pages["eyes/all/"] == ["dim", "seer"]
    assert "console: seer" not in (workspace / "site.yaml").read_text()
    assert "eyes/see/" not in pages


def test_nodes_that_lack_a_module_are_left_out(
    workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = workspace / "src/plots"
    files = {
        "package.xml": "<package><name>plots</name><export>"
        "<build_type>ament_python</build_type></export></package>",
        "setup.py": "from setuptools import setup\nsetup(packages=['plots'], entry_points={"
        "'console_scripts': ['draw = plots.draw:main', 'say = plots.say:main']})\n",
        "plots/__init__.py": "",
        "plots/draw.py": "import rclpy\nimport matplotlib\ndef main(): pass\n",
        "plots/say.py": "import rclpy\nfrom example_interfaces.msg import String\n",
        "launch/both.launch.xml": "<launch><node pkg='plots' exec='say'/>"
        "<node pkg='plots' exec='draw'/></launch>",
    }
    write(package, files)
    assert main(["init", str(workspace)]) == 0
    said = capsys.readouterr().out
    fault = "src/plots/plots/draw.py:2: import matplotlib: 'matplotlib' needs a build for Pyodide"
    assert "  /plots/  say\n" in said
    assert f"  skipped: {fault}" in said
    # The launch file keeps its page, without the node.
    assert "  /plots/both/  src/plots/launch/both.launch.xml\n" in said


def test_names_suit_nodes_and_pages(workspace: Path) -> None:
    shutil.copytree(ROOT / "tests/sites/python/src/mixed", workspace / "src/mixed")
    file = workspace / "src/cpp_pubsub/package.xml"
    file.write_text(file.read_text().replace("<name>cpp_pubsub", "<name>Robot"))
    assert main(["init", str(workspace)]) == 0
    pages = {page.path: page for page in config.load(workspace / "site.yaml").pages}
    assert list(pages) == ["", "cpp_chatter/", "robot/", "mixed/"]
    nodes = {name: node.executable for name, node in pages["mixed/"].nodes.items()}
    assert nodes == {executable.removesuffix(".py"): executable for executable in nodes.values()}
    assert nodes["greeter"] == "greeter.py"


def test_packages_that_cannot_run_are_left_out(
    workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = workspace / "src/cpp_chatter/package.xml"
    package.write_text(
        package.read_text().replace("ament_cmake</build_type>", "cmake</build_type>")
    )
    assert main(["init", str(workspace)]) == 0
    assert "skipped: src/cpp_chatter" in capsys.readouterr().out
    [page] = config.load(workspace / "site.yaml").pages
    assert (page.path, list(page.nodes)) == ("", ["talker", "listener"])
