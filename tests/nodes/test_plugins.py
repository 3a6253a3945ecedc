"""Packages with plugins that cannot be built, beside others."""

from __future__ import annotations

import io
from pathlib import Path

from packages import Workspace

from sitegen.build import make
from sitegen.model import Programs
from sitegen.options import Options
from sitegen.report import Report

LEFT_OUT = (
    "src/solver/CMakeLists.txt: 'solver' needs 'Ceres', which has no build for the page "
    "(left out: the library 'solver')"
)
NO_OPENCV = "src/parts/CMakeLists.txt: 'parts' needs 'OpenCV', which has no build for the page"
SHAPE = "namespace base { class Shape { public: virtual ~Shape() = default; }; }\n"
LOADER = """\
    #include <pluginlib/class_loader.hpp>
    #include "base/shape.hpp"
    int main() { pluginlib::ClassLoader<base::Shape> loader("base", "base::Shape"); }
    """
PLUGINS = """\
    find_package(pluginlib REQUIRED)
    find_package(base REQUIRED)
    {}
    add_library({} SHARED src/plugin.cpp)
    ament_target_dependencies({} pluginlib base)
    pluginlib_export_plugin_description_file(base plugins.xml)
    """
XML = """\
    <library path="{0}">
      <class type="{0}::{1}" base_class_type="base::Shape"/>
    </library>
    """
SOURCE = """\
    {2}
    #include <pluginlib/class_list_macros.hpp>
    #include "base/shape.hpp"
    namespace {0} {{ class {1} : public base::Shape {{}}; }}
    PLUGINLIB_EXPORT_CLASS({0}::{1}, base::Shape)
    """
COMPONENT = """\
    {1}
    #include <rclcpp/rclcpp.hpp>
    #include <rclcpp_components/register_node_macro.hpp>
    namespace parts {{
    struct {0} : rclcpp::Node {{
      explicit {0}(const rclcpp::NodeOptions & options) : Node("part", options) {{}}
    }};
    }}
    RCLCPP_COMPONENTS_REGISTER_NODE(parts::{0})
    """
LAUNCHED = """\
    site: {title: Test, asyncify: false}
    pages: [{path: /, title: Test, launch: parts.launch.xml, content: [console: container]}]
    """
CONTAINER = """\
    <launch>
      <node_container pkg="rclcpp_components" exec="component_container" name="container"
          namespace="">
        <composable_node pkg="parts" plugin="parts::{}" name="part"/>
      </node_container>
    </launch>
    """


def plugins(
    workspace: Workspace, name: str, kind: str, *, finds: str = "", begin: str = ""
) -> None:
    body = PLUGINS.format(finds, name, name)
    workspace.package(name, body, depends="base pluginlib")
    workspace.write(f"src/{name}/plugins.xml", XML.format(name, kind))
    workspace.write(f"src/{name}/src/plugin.cpp", SOURCE.format(name, kind, begin))


def base(workspace: Workspace) -> None:
    workspace.package(
        "base",
        """\
        find_package(pluginlib REQUIRED)
        add_executable(shapes src/main.cpp)
        target_include_directories(shapes PRIVATE include)
        ament_target_dependencies(shapes pluginlib)
        install(DIRECTORY include/ DESTINATION include)
        ament_export_include_directories(include)
        """,
        depends="pluginlib",
        main=LOADER,
    )
    workspace.write("src/base/include/base/shape.hpp", SHAPE)
    workspace.site("base/shapes")


def made(workspace: Workspace, *, keep_going: bool = False) -> tuple[Programs, list[str]]:
    """Return all programs, and what was said."""
    out = io.StringIO()
    programs = make(workspace.folder, Report(out), options=Options(keep_going=keep_going)).programs
    return programs, [line for line in out.getvalue().splitlines() if "compiling" not in line]


def built(workspace: Workspace, *, keep_going: bool = False) -> tuple[bytes, list[str]]:
    """Return the program of `base`, and what was said."""
    programs, said = made(workspace, keep_going=keep_going)
    found = (file.source for file in programs["base", "shapes"].files)
    [file] = (each for each in found if isinstance(each, Path) and each.suffix == ".wasm")
    return file.read_bytes(), said


def test_a_program_does_without_those_that_no_page_can_have(workspace: Workspace) -> None:
    base(workspace)
    plugins(workspace, "round", "Circle")
    plugins(
        workspace,
        "solver",
        "Sphere",
        finds="find_package(Ceres REQUIRED)",
        begin="#include <ceres/ceres.h>",
    )
    program, said = built(workspace)
    assert b"round::Circle" in program
    assert b"solver::Sphere" not in program
    assert LEFT_OUT in said
    # It is said again, although nothing is compiled.
    assert built(workspace) == (program, [LEFT_OUT])


def test_a_program_does_without_libraries_of_its_package(workspace: Workspace) -> None:
    """Other packages use the rest of it."""
    workspace.package(
        "base",
        """\
        find_package(pluginlib REQUIRED)
        find_package(OpenCV REQUIRED)
        include_directories(include)
        add_executable(shapes src/main.cpp)
        add_library(round SHARED src/round.cpp)
        add_library(photo SHARED src/photo.cpp src/camera.cpp)
        foreach(target shapes round photo)
          ament_target_dependencies(${target} pluginlib OpenCV)
        endforeach()
        pluginlib_export_plugin_description_file(base plugins.xml)
        install(DIRECTORY include/ DESTINATION include)
        ament_export_include_directories(include)
        ament_export_libraries(round photo)
        """,
        depends="pluginlib",
        main=LOADER,
    )
    workspace.write("src/base/include/base/shape.hpp", SHAPE)
    libraries = (XML.format(name, kind) for name, kind in (("round", "Circle"), ("photo", "Plate")))
    workspace.write(
        "src/base/plugins.xml", f"<class_libraries>{''.join(libraries)}</class_libraries>"
    )
    workspace.write("src/base/src/round.cpp", SOURCE.format("round", "Circle", ""))
    lacking = "#include <opencv2/core.hpp>"
    workspace.write("src/base/src/photo.cpp", SOURCE.format("photo", "Plate", lacking))
    workspace.write("src/base/src/camera.cpp", lacking)
    workspace.package(
        "user",
        "find_package(base REQUIRED)\n"
        "add_executable(used src/main.cpp)\nament_target_dependencies(used base)",
        depends="base",
        main='#include "base/shape.hpp"\nint main() { base::Shape shape; }',
    )
    workspace.site("base/shapes", "user/used")
    program, said = built(workspace)
    assert b"round::Circle" in program
    assert b"photo::Plate" not in program
    left_out = "src/base/CMakeLists.txt: 'base' needs 'OpenCV', which has no build for the page "
    assert said[-1] == f"{left_out}(left out: the library 'photo')"
    assert built(workspace) == (program, said[-1:])
    # A package that links it needs it; a name that is wrong is another error.
    user = workspace.folder / "src/user/CMakeLists.txt"
    text = user.read_text()
    linked = text.replace("(used base)", "(used base)\ntarget_link_libraries(used base::{})")
    user.write_text(linked.replace("{}", "photo"))
    assert workspace.problems() == [left_out.strip()]
    user.write_text(linked.replace("{}", "phto"))
    [problem] = workspace.problems()
    assert problem.startswith("src/user/CMakeLists.txt: CMake failed")


def test_several_descriptions_may_name_a_library(workspace: Workspace) -> None:
    workspace.package(
        "base",
        """\
        find_package(pluginlib REQUIRED)
        include_directories(include)
        add_executable(shapes src/main.cpp)
        ament_target_dependencies(shapes pluginlib)
        add_library(round SHARED src/circle.cpp src/ring.cpp src/disk.cpp)
        ament_target_dependencies(round pluginlib)
        pluginlib_export_plugin_description_file(base plugins.xml)
        pluginlib_export_plugin_description_file(base more.xml)
        """,
        depends="pluginlib",
        main=LOADER,
    )
    workspace.write("src/base/include/base/shape.hpp", SHAPE)
    for kind in ("Circle", "Ring", "Disk"):
        workspace.write(f"src/base/src/{kind.lower()}.cpp", SOURCE.format("round", kind, ""))
    described = {
        kind: XML.format("round", kind).replace(
            "/>", f"><description>The {kind}</description></class>"
        )
        for kind in ("Circle", "Ring", "Disk")
    }
    both = described["Circle"] + described["Ring"]
    workspace.write("src/base/plugins.xml", f"<class_libraries>{both}</class_libraries>")
    workspace.write("src/base/more.xml", described["Disk"])
    workspace.site("base/shapes")
    program, _ = built(workspace)
    for kind in described:
        assert f"The {kind}".encode() in program


def test_a_program_that_is_linked_to_such_a_library_is_not_built(workspace: Workspace) -> None:
    workspace.package(
        "parts",
        """\
        find_package(rclcpp_components REQUIRED)
        add_library(camera SHARED src/camera.cpp)
        ament_target_dependencies(camera rclcpp_components)
        rclcpp_components_register_node(camera PLUGIN "parts::Camera" EXECUTABLE camera_node)
        """,
        depends="rclcpp rclcpp_components",
    )
    workspace.write("src/parts/src/camera.cpp", "#include <opencv2/core.hpp>")
    workspace.site("parts/camera_node")
    assert workspace.problems() == [NO_OPENCV]


def test_a_container_does_without_components_that_it_does_not_load(workspace: Workspace) -> None:
    workspace.package(
        "parts",
        """\
        find_package(rclcpp_components REQUIRED)
        add_library(camera SHARED src/camera.cpp)
        add_library(arm SHARED src/arm.cpp)
        foreach(target camera arm)
          ament_target_dependencies(${target} rclcpp_components)
        endforeach()
        rclcpp_components_register_nodes(camera "parts::Camera")
        rclcpp_components_register_nodes(arm "parts::Arm")
        """,
        depends="rclcpp rclcpp_components",
    )
    for name, begin in ("Camera", "#include <opencv2/core.hpp>"), ("Arm", ""):
        workspace.write(f"src/parts/src/{name.lower()}.cpp", COMPONENT.format(name, begin))
    workspace.write("site.yaml", LAUNCHED)
    workspace.write("parts.launch.xml", CONTAINER.format("Arm"))
    assert made(workspace)[1] == []
    workspace.write("parts.launch.xml", CONTAINER.format("Camera"))
    [line] = made(workspace)[1]
    assert line.startswith(f"{NO_OPENCV} (left out: rclcpp_components/component_container-")


def test_a_description_may_name_libraries_that_are_not_built(workspace: Workspace) -> None:
    """dwb_plugins of Nav2 names one that became a part of another package."""
    base(workspace)
    plugins(workspace, "round", "Circle")
    other = XML.format("moved", "Moved")
    both = f"<class_libraries>{other}{XML.format('round', 'Circle')}</class_libraries>"
    workspace.write("src/round/plugins.xml", both)
    program, said = built(workspace)
    assert b"round::Circle" in program
    assert b"moved::Moved" not in program
    assert said == []
    workspace.write("src/round/plugins.xml", other)
    [problem] = workspace.problems()
    assert "names the library 'moved', which this package does not" in problem


def test_an_error_in_one_of_them_is_an_error(workspace: Workspace) -> None:
    base(workspace)
    plugins(workspace, "wrong", "Square", begin="int number = nothing;")
    [problem] = workspace.problems()
    expected = "src/wrong/src/plugin.cpp:1:14: could not compile: use of undeclared identifier"
    assert problem.startswith(expected)
    program, said = built(workspace, keep_going=True)
    assert b"wrong::Square" not in program
    left_out = next(line for line in said if line.startswith(expected))
    assert left_out.endswith("(left out: the plugins of 'wrong')")
    # What was built without it does not hide the error.
    [again] = workspace.problems()
    assert again == problem
