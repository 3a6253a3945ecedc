"""Sources that several libraries with components have, each of which is linked as a whole."""

from __future__ import annotations

from configuring import Configuring
from packages import Workspace

COMPONENT = """\
    #include "base.hpp"
    #include "rclcpp_components/register_node_macro.hpp"
    struct {name} : Base
    {{
      explicit {name}(const rclcpp::NodeOptions & options) : Base("{name}", options) {{}}
    }};
    RCLCPP_COMPONENTS_REGISTER_NODE({name})
    """
BASE = """\
    #pragma once
    #include "rclcpp/rclcpp.hpp"
    struct Base : rclcpp::Node
    {
      Base(const std::string & name, const rclcpp::NodeOptions & options);
    };
    """


def test_libraries_that_link_nothing_have_some_too(packages: Configuring) -> None:
    packages.package(
        "plain",
        """\
add_library(one SHARED src/one.cpp src/both.cpp)
add_library(two SHARED src/two.cpp src/both.cpp)
sitegen_keep(one)
sitegen_keep(two)
add_executable(main src/main.cpp)
target_link_libraries(main one two)
""",
    )
    for name in ("one", "two", "both"):
        packages.write(f"plain/src/{name}.cpp", f"int {name}() {{return 0;}}\n")
    assert packages.configure("plain") == ""
    built = (packages.tree("plain") / "build.ninja").read_text()
    assert "libsitegen_shared_" in built
    assert "NOTFOUND" not in built


def test_they_are_compiled_once(workspace: Workspace) -> None:
    workspace.package(
        "tools",
        """\
        find_package(ament_cmake_auto REQUIRED)
        ament_auto_find_build_dependencies()
        ament_auto_add_library(relay_node SHARED src/relay.cpp src/base.cpp)
        rclcpp_components_register_nodes(relay_node "Relay")
        ament_auto_add_library(drop_node SHARED src/drop.cpp src/base.cpp)
        rclcpp_components_register_nodes(drop_node "Drop")
        add_library(both_node SHARED src/base.cpp)
        target_link_libraries(both_node rclcpp::rclcpp)
        ament_auto_add_executable(drop src/main.cpp src/base.cpp)
        target_link_libraries(drop drop_node both_node)
        """,
        depends="rclcpp rclcpp_components",
    )
    workspace.write("src/tools/src/base.hpp", BASE)
    workspace.write(
        "src/tools/src/base.cpp",
        """\
        #include "base.hpp"
        Base::Base(const std::string & name, const rclcpp::NodeOptions & options)
        : Node(name, options) {}
        """,
    )
    for name in ("Relay", "Drop"):
        workspace.write(f"src/tools/src/{name.lower()}.cpp", COMPONENT.format(name=name))
    workspace.write(
        "src/tools/src/main.cpp",
        """\
        #include "base.hpp"
        int main() {Base base("main", rclcpp::NodeOptions());}
        """,
    )
    workspace.site("tools/drop")
    assert workspace.build() == ["tools/drop"]
