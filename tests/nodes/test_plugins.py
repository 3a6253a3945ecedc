"""Packages with plugins that cannot be built, beside others."""

from __future__ import annotations

import io
from pathlib import Path

from packages import Workspace

from sitegen.build import make
from sitegen.options import Options
from sitegen.report import Report

LEFT_OUT = (
    "src/solver/CMakeLists.txt: 'solver' needs 'Ceres', which has no build for the page "
    "(left out: the plugins of 'solver')"
)
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
        main="""\
        #include <pluginlib/class_loader.hpp>
        #include "base/shape.hpp"
        int main() {pluginlib::ClassLoader<base::Shape> loader("base", "base::Shape");}
        """,
    )
    workspace.write(
        "src/base/include/base/shape.hpp",
        "namespace base { class Shape { public: virtual ~Shape() = default; }; }\n",
    )
    workspace.site("base/shapes")


def built(workspace: Workspace, *, keep_going: bool = False) -> tuple[bytes, list[str]]:
    """Return the program, and what was said."""
    out = io.StringIO()
    made = make(workspace.folder, Report(out), options=Options(keep_going=keep_going))
    found = (file.source for file in made.programs["base", "shapes"].files)
    [file] = (each for each in found if isinstance(each, Path) and each.suffix == ".wasm")
    said = [line for line in out.getvalue().splitlines() if "compiling" not in line]
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
