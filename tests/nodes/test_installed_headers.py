"""Headers that a package installs from elsewhere than its include/."""

from __future__ import annotations

import pytest
from configuring import Configuring

LIBRARY = """\
add_library(other src/other.cpp)
{}
ament_export_include_directories({})
ament_export_libraries(other)
"""
CONFIGURED = """\
configure_file(config.h.in ${CMAKE_CURRENT_BINARY_DIR}/generated/other/config.h @ONLY)
"""
INSTALLS = {
    "a file that CMake makes": (
        f"{CONFIGURED}install(FILES ${{CMAKE_CURRENT_BINARY_DIR}}/generated/other/config.h\n"
        "  DESTINATION include/${PROJECT_NAME})",
        "include",
        "other/config.h",
    ),
    "a folder that CMake makes": (
        f"{CONFIGURED}install(DIRECTORY ${{CMAKE_CURRENT_BINARY_DIR}}/generated/\n"
        "  DESTINATION include)",
        "include",
        "other/config.h",
    ),
    "a folder of CMake for this package": (
        f"{CONFIGURED.replace('generated', 'include')}"
        "install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/include/\n"
        "  DESTINATION include/${PROJECT_NAME})",
        "include/${PROJECT_NAME}",
        "other/config.h",
    ),
    "the sources": (
        'install(DIRECTORY src/ DESTINATION include/other FILES_MATCHING PATTERN "*.hpp")',
        "include",
        "other/deep/of_source.hpp",
    ),
    "a folder of a package": (
        "install(DIRECTORY src/deep DESTINATION include/${PROJECT_NAME}/${PROJECT_NAME})",
        "include/${PROJECT_NAME}",
        "other/deep/of_source.hpp",
    ),
    "a file by another name": (
        "install(FILES src/deep/of_source.hpp TYPE INCLUDE RENAME renamed.hpp)",
        "include",
        "renamed.hpp",
    ),
    "a file beside the libraries of others": (
        "install(FILES src/deep/of_source.hpp DESTINATION include/other)",
        "include/other",
        "of_source.hpp",
    ),
}


def write(packages: Configuring, install: str, exported: str, header: str) -> None:
    packages.package("other", LIBRARY.format(install, exported))
    packages.write("other/config.h.in", "#define VALUE 1\n")
    packages.write("other/src/deep/of_source.hpp", '#pragma once\n#include "beside.hpp"\n')
    packages.write("other/src/deep/beside.hpp", "#define VALUE 1\n")
    packages.write("other/src/other.cpp", "int other() { return 1; }\n")
    packages.package(
        "user",
        "find_package(other REQUIRED)\nadd_executable(user src/main.cpp)\n"
        "ament_target_dependencies(user other)",
        main=f'#include "{header}"\nint main() {{ return VALUE - 1; }}\n',
    )


@pytest.mark.parametrize(("install", "exported", "header"), INSTALLS.values(), ids=INSTALLS)
def test_other_packages_find_them(
    packages: Configuring, install: str, exported: str, header: str
) -> None:
    write(packages, install, exported, header)
    assert packages.configure("other", "user") == ""
    assert packages.compile("user", "user") == ""


def test_messages_name_the_file_that_the_author_knows(packages: Configuring) -> None:
    write(packages, *INSTALLS["the sources"])
    packages.write("other/src/deep/of_source.hpp", "#error not yet\n")
    assert packages.configure("other", "user") == ""
    assert "of_source.hpp:1:2: error: not yet" in packages.compile("user", "user")


def test_configuring_again_compiles_nothing_again(packages: Configuring) -> None:
    write(packages, *INSTALLS["the sources"])
    assert packages.configure("other") == ""
    made = packages.tree("other") / "prefix/include/other/deep/of_source.hpp"
    before = made.stat().st_mtime_ns
    assert packages.configure("other") == ""
    assert made.stat().st_mtime_ns == before
