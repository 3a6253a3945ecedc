"""What CMake finds of libraries that no page can have, or whose headers are on this computer."""

from __future__ import annotations

import os

import pytest
from configuring import Configuring


@pytest.mark.parametrize(
    ("found", "variable"),
    [
        ("Ceres REQUIRED COMPONENTS SuiteSparse", "CERES_VERSION"),
        ("Ceres REQUIRED", "Ceres_VERSION"),
        ("CHOLMOD REQUIRED", "CHOLMOD_VERSION"),
    ],
)
def test_versions_are_compared(packages: Configuring, found: str, variable: str) -> None:
    packages.package(
        "one",
        f"find_package({found})\n"
        f"if(${{{variable}}} VERSION_LESS 1.0)\nmessage(FATAL_ERROR old)\nendif()\n"
        "add_executable(one src/main.cpp)",
    )
    assert packages.configure("one") == ""


def test_they_come_before_what_a_package_finds_itself(packages: Configuring) -> None:
    packages.package(
        "one",
        "list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_SOURCE_DIR}/cmake)\n"
        "find_package(G2O REQUIRED)\nadd_executable(one src/main.cpp)",
    )
    packages.write("one/cmake/FindG2O.cmake", "message(FATAL_ERROR absent)\n")
    assert packages.configure("one") == ""


def test_configuring_again_in_a_build_has_the_same_environment(packages: Configuring) -> None:
    packages.package(
        "one",
        "if(NOT DEFINED ENV{ROS_DISTRO})\n  message(FATAL_ERROR no)\nendif()\n"
        "add_executable(one src/main.cpp)",
    )
    assert packages.configure("one") == ""
    lists = packages.folder / "one" / "CMakeLists.txt"
    later = (packages.tree("one") / "build.ninja").stat().st_mtime + 10
    os.utime(lists, (later, later))
    assert packages.compile("one", "one") == ""


def test_xtensor_uses_the_vectors_of_webassembly_and_not_xsimd(packages: Configuring) -> None:
    packages.package(
        "one",
        "add_definitions(-DXTENSOR_USE_XSIMD)\nadd_compile_options(-mavx2 -mfma)\n"
        "find_package(xtensor REQUIRED)\nfind_package(xsimd REQUIRED)\n"
        "add_executable(one src/main.cpp)\n"
        "target_link_libraries(one xtensor xtensor::use_xsimd)",
        main="#ifdef XTENSOR_USE_XSIMD\n#error with xsimd\n#endif\n"
        "#if !defined(__wasm_simd128__) || defined(__SSE__)\n#error other vectors\n#endif\n"
        "int main() {}\n",
    )
    assert packages.configure("one") == ""
    assert packages.compile("one", "one") == ""
