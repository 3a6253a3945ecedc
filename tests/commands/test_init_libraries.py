"""The panels that `sitegen init` writes for nodes whose classes are in libraries."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from sitegen import config
from sitegen.__main__ import main
from sitegen.model import Page, Widget

MANIFEST = (
    "<package><name>robot</name><export><build_type>ament_cmake</build_type></export></package>"
)
NODE = """#include "robot/{name}.hpp"
{name}::{name}() : Node("{name}") {{
  create_service<std_srvs::srv::Empty>("{name}/reset", reset);
  declare_parameter("speed", 1.0);
}}
"""
HEADER = '#include "robot/shared.hpp"\nclass {0} : public rclcpp::Node {{}};\n'
MAIN = '#include "robot/{0}.hpp"\nint main() {{spin(std::make_shared<{0}>());}}\n'
COMPONENT = """Camera::Camera(options) : Node("camera", options) {
  create_publisher<sensor_msgs::msg::Image>("image", 1);
  create_subscription<std_msgs::msg::String>("say", 1, hear);
}
RCLCPP_COMPONENTS_REGISTER_NODE(robot::Camera)
"""


def write(root: Path, cmake: str, files: Mapping[str, str]) -> None:
    package = {"package.xml": MANIFEST, "CMakeLists.txt": f"project(robot)\n{cmake}"}
    for name, text in {**package, **files}.items():
        file = root / "src/robot" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def written(root: Path, cmake: str, files: Mapping[str, str]) -> dict[str, Page]:
    """The pages of the site that init writes for a package, by path."""
    write(root, cmake, files)
    assert main(["init", str(root)]) == 0
    return {page.path: page for page in config.load(root / "site.yaml").pages}


def panels(page: Page) -> dict[str, Widget]:
    return {each.kind: each for each in page.leaves if isinstance(each, Widget)}


def classes(*names: str) -> dict[str, str]:
    """Nodes whose classes are in sources of their own, with headers and programs."""
    files = {"include/robot/shared.hpp": "", "src/shared.cpp": '#include "robot/shared.hpp"\n'}
    for name in names:
        files[f"include/robot/{name}.hpp"] = HEADER.format(name)
        files[f"src/{name}.cpp"] = NODE.format(name=name)
        files[f"src/main_{name}.cpp"] = MAIN.format(name)
    return files


@pytest.mark.parametrize(
    "cmake",
    [
        "add_library(core SHARED src/drive.cpp)\nadd_executable(go src/main_drive.cpp)\n"
        "target_link_libraries(go PUBLIC core rclcpp::rclcpp)\n",
        # By another name, through another library, with the sources given later.
        "add_library(core)\ntarget_sources(core PRIVATE src/drive.cpp)\n"
        "add_library(robot::core ALIAS core)\nadd_library(outer src/shared.cpp)\n"
        "target_link_libraries(outer PUBLIC robot::core)\nset(NAMES outer)\n"
        "add_executable(target src/main_drive.cpp)\ntarget_link_libraries(target ${NAMES})\n"
        "set_target_properties(target PROPERTIES OUTPUT_NAME go)\n",
        "ament_auto_add_library(core SHARED DIRECTORY src)\n"
        "ament_auto_add_executable(go src/main_drive.cpp)\n",
        "add_subdirectory(src)\nadd_executable(go src/main_drive.cpp)\n"
        "target_link_libraries(go core)\n",
    ],
)
def test_a_program_has_what_its_library_offers(tmp_path: Path, cmake: str) -> None:
    subfolder = {"src/CMakeLists.txt": "add_library(core drive.cpp)\n"}
    page = written(tmp_path, cmake, {**classes("drive"), **subfolder})[""]
    assert [*page.nodes] == ["go"]
    assert panels(page)["services"].options["show"] == ["/drive/reset"]
    assert "parameters" in panels(page)


def test_of_a_common_library_a_program_has_what_it_includes(tmp_path: Path) -> None:
    cmake = (
        "add_library(core src/drive.cpp src/lift.cpp src/shared.cpp)\n"
        "add_executable(driver src/main_drive.cpp)\nadd_executable(lifter src/main_lift.cpp)\n"
        "foreach(name driver lifter)\n  target_link_libraries(${name} core)\nendforeach()\n"
        + "".join(f"add_executable(other{n} src/other{n}.cpp)\n" for n in range(5))
    )
    pages = written(tmp_path, cmake, classes("drive", "lift"))
    assert panels(pages["robot/driver/"])["services"].options["show"] == ["/drive/reset"]
    assert panels(pages["robot/lifter/"])["services"].options["show"] == ["/lift/reset"]
    # A program that is not linked to it has nothing of it.
    assert "services" not in panels(pages["robot/other0/"])


def test_a_program_without_the_library_has_no_panels_of_it(tmp_path: Path) -> None:
    cmake = "add_library(core src/drive.cpp)\nadd_executable(go src/main_drive.cpp)\n"
    page = written(tmp_path, cmake, classes("drive"))[""]
    assert "services" not in panels(page)


def test_a_component_has_what_the_rest_of_its_library_offers(tmp_path: Path) -> None:
    cmake = (
        "add_library(core SHARED src/register.cpp src/camera.cpp)\n"
        'rclcpp_components_register_node(core PLUGIN "robot::Camera" EXECUTABLE camera)\n'
    )
    macro = "RCLCPP_COMPONENTS_REGISTER_NODE(robot::Camera)\n"
    files = {"src/register.cpp": macro, "src/camera.cpp": COMPONENT.replace(macro, "")}
    page = written(tmp_path, cmake, files)[""]
    assert panels(page)["image"].options["topic"] == "/image"


def test_components_of_a_launch_file_have_panels_under_their_names(tmp_path: Path) -> None:
    cmake = (
        "add_library(core SHARED src/camera.cpp)\n"
        'rclcpp_components_register_nodes(core "robot::Camera")\n'
    )
    launch = """<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="all" namespace="">
    <composable_node pkg="robot" plugin="robot::Camera" name="left" namespace="left">
      <remap from="say" to="/words"/>
    </composable_node>
  </node_container>
</launch>"""
    files = {"src/camera.cpp": COMPONENT, "launch/all.launch.xml": launch}
    shown = panels(written(tmp_path, cmake, files)[""])
    assert shown["image"].options["topic"] == "/left/image"
    assert shown["publish"].options["topic"] == "/words"
    # On the home page of a larger site, the container is called by its components.
    write(
        tmp_path / "two",
        cmake,
        {**files, "launch/other.launch.xml": launch.replace("left", "right")},
    )
    assert main(["init", str(tmp_path / "two")]) == 0
    home = (tmp_path / "two/site.yaml").read_text(encoding="utf-8")
    assert "- [All](robot/all/) Camera\n" in home
