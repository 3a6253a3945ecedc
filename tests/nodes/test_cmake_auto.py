"""ament_cmake_auto: the same as upstream, and errors of dependencies are told."""

from __future__ import annotations

import pytest
from configuring import Configuring

FIND = "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies({})\n"


def test_a_failed_dependency_is_told(packages: Configuring) -> None:
    packages.package("broken", 'message(FATAL_ERROR "broken on purpose")')
    packages.package(
        "user",
        FIND.format(""),
        tags="<depend>libncurses-dev</depend><depend>broken</depend>",
    )
    assert "broken on purpose" in packages.configure("broken")
    said = packages.configure("user", needs=["broken"])
    assert 'package configuration file provided by "broken"' in said
    # What is no package of the workspace stays a key of rosdep.
    assert packages.configure("user") == ""


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ("REQUIRED rclcpp std_msgs", ""),
        ("REQUIRED tf2", "'tf2' is no <depend>, <build_depend> or <buildtool_depend>"),
        ("REQUIRED libncurses-dev", 'configuration file provided by "libncurses-dev"'),
        ("rclcpp", "unknown arguments 'rclcpp'; write REQUIRED before names of packages"),
    ],
)
def test_required_dependencies(packages: Configuring, arguments: str, expected: str) -> None:
    tags = "".join(
        f"<build_depend>{name}</build_depend>" for name in ("rclcpp", "libncurses-dev", "std_msgs")
    )
    packages.package("user", FIND.format(arguments), tags=tags)
    assert expected in packages.configure("user")
    assert bool(expected) == bool(packages.configure("user"))


def test_buildtool_dependencies_are_found(packages: Configuring) -> None:
    packages.package(
        "user",
        FIND.format("REQUIRED rosidl_default_generators")
        + 'rosidl_generate_interfaces(user "msg/Count.msg")\nament_auto_package()\nreturn()',
        tags="<buildtool_depend>rosidl_default_generators</buildtool_depend>",
    )
    packages.write("user/msg/Count.msg", "int32 value\n")
    assert packages.configure("user") == ""


def test_options_of_libraries_and_programs(packages: Configuring) -> None:
    packages.package(
        "user",
        FIND.format("")
        + """\
ament_auto_find_test_dependencies()
ament_auto_add_library(parts SHARED DIRECTORY src)
ament_auto_add_library(headers INTERFACE)
ament_auto_add_library(alone STATIC one.cpp NO_TARGET_LINK_LIBRARIES)
ament_auto_add_executable(linked one.cpp)
ament_auto_add_executable(single one.cpp NO_TARGET_LINK_LIBRARIES)
ament_auto_add_gtest(tested test/one.cpp)
get_target_property(sources parts SOURCES)
get_target_property(alone alone LINK_LIBRARIES)
get_target_property(linked linked LINK_LIBRARIES)
get_target_property(single single LINK_LIBRARIES)
file(WRITE "${CMAKE_BINARY_DIR}/said" "${sources}|${alone}|${linked}|${single}")
ament_auto_package(CONFIG_EXTRAS extra.cmake INSTALL_TO_PATH INSTALL_TO_SHARE config)
return()
""",
        tags="<depend>std_msgs</depend><test_depend>ament_lint_auto</test_depend>",
    )
    for name in ("src/deep/two.cpp", "one.cpp", "config/one.yaml", "extra.cmake"):
        packages.write(f"user/{name}", "")
    assert packages.configure("user") == ""
    sources, alone, linked, single = (packages.tree("user") / "said").read_text().split("|")
    assert sources.split(";") == ["src/deep/two.cpp", "src/main.cpp"]
    assert "parts" in linked
    assert "parts" not in alone.split(";")
    assert "parts" not in single.split(";")
    # The arguments of ament_package() reach it.
    exported = packages.tree("user") / "prefix/share/user/cmake/userLibraries.cmake"
    assert "extra.cmake" in exported.read_text()
