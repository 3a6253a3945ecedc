"""What CMake says, in the words of sitegen."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from sitegen.model import Package
from sitegen.nodes.cpp.diagnosis import Diagnosis


@pytest.fixture
def diagnosis(tmp_path: Path) -> Diagnosis:
    package = Package("arm", tmp_path / "src" / "arm", "ament_cmake", ("nav2_util",), (), ())
    return Diagnosis(tmp_path, package)


def test_headers_that_authors_install_are_told_with_how(diagnosis: Diagnosis) -> None:
    said = 'Could not find a package configuration file provided by "Eigen3" with any of'
    assert diagnosis.of_cmake(said) == [
        "src/arm/CMakeLists.txt: 'arm' needs 'Eigen3', which is not installed "
        "(pip install 'ros-sitegen[eigen]', or apt-get install libeigen3-dev)"
    ]


def test_packages_of_ros_are_added_to_the_workspace(diagnosis: Diagnosis) -> None:
    said = 'Could not find a package configuration file provided by "nav2_util" with any of'
    assert diagnosis.of_cmake(said) == [
        "src/arm/CMakeLists.txt: 'arm' needs 'nav2_util', which is not in the workspace; "
        "clone its sources there: git clone -b kilted https://github.com/ros-planning/navigation2.git"
    ]


def test_a_missing_header_is_told_once(diagnosis: Diagnosis) -> None:
    said = "{}/src/arm/src/{}.cpp:{}:10: fatal error: '{}' file not found"
    root = diagnosis.root
    outputs = {
        "one": "\n".join(
            [
                said.format(root, "one", 3, "grip/grip.hpp"),
                said.format(root, "part", 7, "grip/grip.hpp"),
                said.format(root, "part", 8, "local.hpp"),
            ]
        ),
        "two": said.format(root, "two", 4, "grip/grip.hpp"),
    }
    grip = "src/arm/src/one.cpp:3: 'arm' includes 'grip/grip.hpp', which was not found"
    local = "src/arm/src/part.cpp:8: 'arm' includes 'local.hpp', which was not found"
    assert diagnosis.of_builds(outputs, root, {}) == [
        f"{grip} (and 2 other files); is package 'grip' in the workspace?",
        local,
    ]
    assert diagnosis.of_builds(outputs, root, {"grip": ["src/grip/CMakeLists.txt: why"]}) == [
        f"{grip}, because package 'grip' failed (and 2 other files)",
        "src/grip/CMakeLists.txt: why",
        local,
    ]


def test_headers_of_eigen_are_in_a_folder_that_cmake_adds(diagnosis: Diagnosis) -> None:
    said = f"{diagnosis.root}/src/arm/src/arm.cpp:3:10: fatal error: '{{}}' file not found"
    assert diagnosis.of_builds({"arm": said.format("Eigen/Core")}, diagnosis.root, {}) == [
        "src/arm/src/arm.cpp:3: 'arm' includes 'Eigen/Core', which was not found; "
        "add find_package(Eigen3 REQUIRED) to CMakeLists.txt"
    ]
    assert diagnosis.of_builds({"arm": said.format("eigen3/Eigen/Core")}, diagnosis.root, {}) == [
        "src/arm/CMakeLists.txt: 'arm' needs 'Eigen', which is not installed "
        "(pip install 'ros-sitegen[eigen]', or apt-get install libeigen3-dev)"
    ]


def test_what_libraries_lack_is_told_with_how_to_get_it(diagnosis: Diagnosis) -> None:
    said = "{}/src/arm/src/{}.cpp:3:10: fatal error: '{}' file not found"
    headers = ("boost/asio.hpp", "boost/bind.hpp", "zmq.hpp", "QApplication", "qapplication.h")
    outputs = {
        f"n{n}": said.format(diagnosis.root, f"n{n}", name) for n, name in enumerate(headers)
    }
    boost = "src/arm/CMakeLists.txt: 'arm' needs 'Boost', which is not installed "
    assert list(dict.fromkeys(diagnosis.of_builds(outputs, diagnosis.root, {}))) == [
        f"{boost}(apt-get install libboost-dev)",
        "src/arm/CMakeLists.txt: 'arm' needs 'ZeroMQ', which has no build for the page",
        "src/arm/CMakeLists.txt: 'arm' needs 'Qt5', which has no build for the page",
        "src/arm/src/n4.cpp:3: 'arm' includes 'qapplication.h', which was not found",
    ]
    line = (
        "wasm-ld: error: CMakeFiles/a.dir/a.cpp.o: undefined symbol: "
        "boost::filesystem::detail::status(boost::filesystem::path const&)"
    )
    first = diagnosis.of_build("a", line, diagnosis.root)[0].splitlines()[0]
    assert first == (
        "src/arm/CMakeLists.txt: could not link 'a': undefined symbol: "
        "boost::filesystem::detail::status(boost::filesystem::path const&); "
        "pages have only the headers of Boost (package 'arm')"
    )


def test_libraries_that_are_compiled_must_be_found(diagnosis: Diagnosis) -> None:
    said = f"{diagnosis.root}/src/arm/n.cpp:3:10: fatal error: 'kdl/chain.hpp' file not found"
    problem = "src/arm/n.cpp:3: 'arm' includes 'kdl/chain.hpp', which was not found"
    assert diagnosis.of_builds({"n": said}, diagnosis.root, {}) == [
        f"{problem}; add find_package(orocos_kdl REQUIRED) to CMakeLists.txt"
    ]
    why = "the source of 'orocos_kdl' is missing: this computer is offline"
    assert diagnosis.of_builds({"n": said}, diagnosis.root, {"orocos_kdl": [why]}) == [
        f"{problem}, because package 'orocos_kdl' failed",
        why,
    ]


def test_a_package_of_the_workspace_comes_before_a_library(diagnosis: Diagnosis) -> None:
    header = "cv_bridge/cv_bridge.hpp"
    outputs = {"n": f"{diagnosis.root}/src/arm/n.cpp:3:10: fatal error: '{header}' file not found"}
    why = "src/cv_bridge/CMakeLists.txt: why"
    assert diagnosis.of_builds(outputs, diagnosis.root, {"cv_bridge": [why]}) == [
        f"src/arm/n.cpp:3: 'arm' includes '{header}', which was not found, "
        "because package 'cv_bridge' failed",
        why,
    ]
    theirs = Package("cv_bridge", diagnosis.root / "src/cv_bridge", "ament_cmake", (), (), ())
    needing = replace(diagnosis, needs=[theirs])
    assert needing.of_builds(outputs, diagnosis.root, {}) == [
        f"src/arm/n.cpp:3: 'arm' includes '{header}', which was not found; "
        "package 'cv_bridge' has no such header"
    ]


def test_libraries_that_the_compiler_would_download_are_named(tmp_path: Path) -> None:
    said = (
        "FAILED: CMakeFiles/joy.dir/src/joy.cpp.o \nTraceback (most recent call last):\n"
        '  File "/usr/share/emscripten/em++.py", line 14, in <module>\n'
        '  File "/usr/share/emscripten/tools/ports/__init__.py", line 364, in add_cflags\n'
        "    port.get(Ports, settings, shared)\n"
        '  File "/usr/share/emscripten/tools/ports/sdl2.py", line 23, in get\n'
        "Exception: Attempt to lock the cache but FROZEN_CACHE is set\n"
    )
    package = Package("joy", tmp_path / "joy", "ament_cmake", (), None, ())
    lines = Diagnosis(tmp_path, package).of_builds({"joy": said}, tmp_path, {})
    assert lines == ["joy/CMakeLists.txt: 'joy' needs 'sdl2', which has no build for the page"]
