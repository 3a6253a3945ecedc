"""The commands of ament that packages call in their CMakeLists.txt."""

from __future__ import annotations

import pytest
from configuring import Configuring

INCLUDES = """\
#include "other/other.hpp"
int main() { std_msgs::msg::String text; rclcpp::init(0, nullptr); return other(); }
"""
LIBRARY = """\
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)
add_library(other src/other.cpp)
target_include_directories(other PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:include/${PROJECT_NAME}>)
"""
TARGETS = f"""\
{LIBRARY}
target_link_libraries(other PUBLIC rclcpp::rclcpp ${{std_msgs_TARGETS}})
install(TARGETS other EXPORT export_other LIBRARY DESTINATION lib)
ament_export_targets(export_other HAS_LIBRARY_TARGET)
"""
VARIABLES = f"""\
{LIBRARY}
ament_target_dependencies(other rclcpp std_msgs)
ament_export_include_directories(include)
ament_export_libraries(other)
ament_export_dependencies(rclcpp std_msgs)
ament_export_definitions(-DOTHER=1)
"""
HEADERS = """\
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)
add_library(other INTERFACE)
target_include_directories(other INTERFACE $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>)
ament_target_dependencies(other INTERFACE rclcpp std_msgs)
install(TARGETS other EXPORT other)
ament_export_targets(other)
"""


def write_other(packages: Configuring, body: str) -> None:
    packages.package("other", body, tags="<depend>rclcpp</depend><depend>std_msgs</depend>")
    packages.write("other/src/other.cpp", "int other() { return 1; }\n")
    packages.write(
        "other/include/other/other.hpp",
        "#include <rclcpp/rclcpp.hpp>\n#include <std_msgs/msg/string.hpp>\nint other();\n",
    )


@pytest.mark.parametrize("body", [TARGETS, VARIABLES, HEADERS], ids=["targets", "old", "headers"])
@pytest.mark.parametrize(
    "link",
    [
        "target_link_libraries(user other::other)",
        "target_link_libraries(user ${other_TARGETS})",
        "ament_target_dependencies(user other)",
    ],
)
def test_exported_libraries_bring_their_dependencies(
    packages: Configuring, body: str, link: str
) -> None:
    write_other(packages, body)
    packages.package(
        "user",
        f"find_package(other REQUIRED)\nadd_executable(user src/main.cpp)\n{link}",
        main=INCLUDES,
    )
    assert packages.configure("other", "user") == ""
    assert packages.compile("user", "user") == ""


def test_definitions_are_exported(packages: Configuring) -> None:
    write_other(packages, VARIABLES)
    packages.package(
        "user",
        "find_package(other REQUIRED)\nadd_executable(user src/main.cpp)\n"
        "ament_target_dependencies(user other)",
        main="#if OTHER != 1\n#error no definition\n#endif\nint main() {}\n",
    )
    assert packages.configure("other", "user") == ""
    assert packages.compile("user", "user") == ""


@pytest.mark.parametrize("name", ["rosidl_default_generators", "rosidl_cmake"])
def test_generators_bring_ament_cmake(packages: Configuring, name: str) -> None:
    packages.package(
        "msgs",
        "cmake_minimum_required(VERSION 3.8)\nproject(msgs)\n"
        f"find_package({name} REQUIRED)\n"
        'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Count.msg")\nament_package()\n',
    )
    packages.write("msgs/msg/Count.msg", "int32 value\n")
    packages.package(
        "user",
        "find_package(msgs REQUIRED)\nadd_executable(user src/main.cpp)\n"
        "target_link_libraries(user ${msgs_TARGETS})",
        main="#include <msgs/msg/count.hpp>\nint main() { msgs::msg::Count count; }\n",
    )
    assert packages.configure("msgs", "user") == ""
    assert packages.compile("user", "user") == ""


def test_the_sizes_of_types_are_those_of_the_page(packages: Configuring) -> None:
    packages.package(
        "one",
        "include(CheckTypeSize)\ncheck_type_size(int SIZE_INT)\n"
        'check_type_size("void *" SIZE_POINTER LANGUAGE CXX)\ncheck_type_size(lacking SIZE_OTHER)\n'
        'message(STATUS "sizes ${SIZE_INT} ${SIZE_POINTER} ${HAVE_SIZE_OTHER}.")\n'
        "add_executable(one src/main.cpp)",
    )
    assert "sizes 4 4 FALSE." in packages.output("one")


def test_a_version_header(packages: Configuring) -> None:
    packages.package(
        "other",
        "find_package(ament_cmake_gen_version_h REQUIRED)\nadd_library(other src/main.cpp)\n"
        "ament_generate_version_header(other)\nament_export_targets(other)",
    )
    main = """\
        #include <other/version.h>
        #include <user/my_version.hpp>
        #define IS OTHER_VERSION_GTE
        static_assert(OTHER_VERSION_MAJOR == 1 && OTHER_VERSION_MINOR == 2);
        static_assert(OTHER_VERSION_PATCH == 3);
        static_assert(sizeof(OTHER_VERSION_STR) == sizeof("1.2.3"));
        static_assert(IS(1, 2, 3) && IS(1, 1, 9) && IS(0, 9, 9));
        static_assert(!IS(1, 2, 4) && !IS(2, 0, 0) && !IS(1, 3, 0));
        static_assert(USER_VERSION_MAJOR == 7 && USER_VERSION_MINOR == 2);
        int main() {}
        """
    packages.package(
        "user",
        "find_package(ament_cmake_gen_version_h REQUIRED)\nfind_package(other REQUIRED)\n"
        "ament_cmake_gen_version_h(VERSION_FILE_NAME my_version.hpp VERSION_MAJOR 7)\n"
        "add_executable(user src/main.cpp)\ntarget_link_libraries(user other::other)",
        main=main,
    )
    assert packages.configure("other", "user") == ""
    assert packages.compile("user", "user") == ""


def test_packages_that_download_a_library_are_refused(packages: Configuring) -> None:
    body = """\
        find_package(ament_cmake_vendor_package REQUIRED)
        ament_vendor(a_vendor SATISFIED {} VCS_URL https://example.org/a.git VCS_VERSION 1.0)
        """
    packages.package("a_vendor", body.format("FALSE"))
    packages.package("b_vendor", body.format("TRUE"))
    assert (
        "'a_vendor' downloads 'https://example.org/a.git' when it is built, which is not possible "
        "for pages; add the library to the workspace as a package"
    ) in packages.configure("a_vendor")
    assert packages.configure("b_vendor") == ""


INDEX = """\
ament_index_register_resource(tools CONTENT "hammer;saw")
ament_index_register_resource(plans CONTENT_FILE plan.in)
ament_index_has_resource(has_std_msgs packages std_msgs)
ament_index_has_resource(has_other packages other)
ament_index_has_resource(has_none packages none)
ament_index_get_resource(text tools other)
ament_index_get_resources(tools tools)
ament_index_get_resources(names packages)
ament_index_get_prefix_path(prefixes)
"""


def test_the_index_of_resources(packages: Configuring) -> None:
    packages.package("other", 'ament_index_register_resource(tools CONTENT "drill")')
    packages.package(
        "user",
        INDEX
        + """\
if(NOT has_std_msgs OR NOT has_other OR has_none)
  message(FATAL_ERROR "${has_std_msgs} ${has_other} ${has_none}")
endif()
foreach(name IN ITEMS std_msgs other)
  if(NOT name IN_LIST names)
    message(FATAL_ERROR "no ${name} in ${names}")
  endif()
endforeach()
list(SORT tools)
if(NOT text STREQUAL "drill" OR NOT tools STREQUAL "other;user" OR NOT prefixes)
  message(FATAL_ERROR "${text} ${tools}")
endif()
ament_index_get_resource(plan plans user)
if(NOT plan STREQUAL "plan of user\\n")
  message(FATAL_ERROR "${plan}")
endif()
""",
    )
    packages.write("user/plan.in", "plan of @PROJECT_NAME@\n")
    assert packages.configure("other", "user") == ""
    packages.package("wrong", "ament_index_get_resource(text tools none)")
    assert "no resource 'none' of type 'tools'" in packages.configure("wrong")


def test_extensions_run(packages: Configuring) -> None:
    packages.package("other", "ament_package(CONFIG_EXTRAS cmake/extra.cmake)\nreturn()")
    packages.write(
        "other/cmake/extra.cmake",
        "ament_register_extension(ament_package other hook.cmake)\n"
        "file(COPY ${CMAKE_CURRENT_LIST_DIR}/hook.cmake DESTINATION ${other_DIR})\n",
    )
    packages.write("other/cmake/hook.cmake", 'file(WRITE "${CMAKE_BINARY_DIR}/ran" "yes")\n')
    packages.package("user", "find_package(other REQUIRED)")
    assert packages.configure("other", "user") == ""
    assert (packages.tree("user") / "ran").read_text() == "yes"


def test_the_manifest(packages: Configuring) -> None:
    packages.package(
        "user",
        """\
ament_package_xml()
if(NOT "${user_VERSION} ${user_BUILD_DEPENDS} ${user_TEST_DEPENDS}" STREQUAL "1.2.3 a;b c")
  message(FATAL_ERROR "${user_VERSION} ${user_BUILD_DEPENDS} ${user_TEST_DEPENDS}")
endif()
""",
        tags="<depend>a</depend><build_depend> b </build_depend><test_depend>c</test_depend>"
        "<!-- <depend>d</depend> --><depend condition='$ROS_VERSION == 1'>e</depend>"
        "<exec_depend>f</exec_depend>",
    )
    assert packages.configure("user") == ""


def test_tests_linters_and_the_rest_are_left_out(packages: Configuring) -> None:
    linters = [
        *("clang_format", "clang_tidy", "copyright", "cppcheck", "cpplint", "flake8"),
        *("lint_cmake", "mypy", "pep257", "uncrustify", "xmllint"),
    ]
    lines = [f"find_package(ament_cmake_{name} REQUIRED)\nament_{name}()" for name in linters]
    lines += [
        "find_package(ament_lint_auto REQUIRED)",
        "ament_lint_auto_find_test_dependencies()",
        "find_package(ament_cmake_google_benchmark REQUIRED)",
        "ament_add_google_benchmark(bench bench.cpp)",
        "find_package(launch_testing_ament_cmake REQUIRED)",
        "add_launch_test(test/start.py)",
        "find_package(ament_cmake_ros REQUIRED)",
        "ament_add_ros_isolated_gtest(one test/one.cpp)",
        "ament_find_gtest()",
        'ament_environment_hooks("${CMAKE_CURRENT_SOURCE_DIR}/env/hook.sh.in")',
        'register_rviz_ogre_media_exports(DIRECTORIES "media")',
        "ament_add_default_options()",
        "ament_get_python_install_dir(folder)",
        'install(FILES a.py DESTINATION "${PYTHON_INSTALL_DIR}/user")',
    ]
    packages.package("user", "\n".join(lines))
    packages.write("user/a.py", "")
    assert packages.configure("user") == ""
