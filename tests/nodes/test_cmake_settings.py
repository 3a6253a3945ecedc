"""What `build` of site.yaml gives to CMake."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
from configuring import Configuring

from sitegen.config.builds import RESERVED
from sitegen.model import BuildSettings

BODY = """\
set(SPEED 1 CACHE STRING "")
option(FAST "" OFF)
message(STATUS "speed ${SPEED}, fast ${FAST}, robot $ENV{ROBOT}, tests ${BUILD_TESTING}")
add_executable(one src/main.cpp)
"""


def told(packages: Configuring, settings: BuildSettings) -> str:
    packages.settings = {"one": settings}
    output = packages.output("one")
    found = re.search(r"-- (speed .*)", output)
    assert found, output
    return found[1]


def test_a_package_gets_its_settings_as_long_as_it_has_them(packages: Configuring) -> None:
    packages.package("one", BODY)
    none = BuildSettings()
    assert told(packages, none) == "speed 1, fast OFF, robot , tests OFF"
    tree = packages.tree("one")
    given = BuildSettings(("-DSPEED:STRING=two words;3", "-DFAST=ON"), {"ROBOT": "arm"})
    assert told(packages, given) == "speed two words;3, fast ON, robot arm, tests OFF"
    assert packages.tree("one") != tree
    changed = replace(given, environment={"ROBOT": "leg"})
    assert told(packages, changed) == "speed two words;3, fast ON, robot leg, tests OFF"
    assert told(packages, none) == "speed 1, fast OFF, robot , tests OFF"
    assert packages.tree("one") == tree


def test_what_sitegen_sets_itself_is_refused(packages: Configuring) -> None:
    packages.package("one", "")
    packages.configure("one")
    cache = (packages.tree("one") / "CMakeCache.txt").read_text()
    # CMake records where a value comes from: its own variables are of other types.
    names = re.findall(r"^(\S+):UNINITIALIZED=", cache, re.MULTILINE)
    assert "SITEGEN_ENGINE" in names
    assert [name for name in names if not RESERVED.fullmatch(name)] == []


@pytest.mark.parametrize("name", ["WITH_CAMERA", "CMAKE_CXX_FLAGS", "MY_SITEGEN", "yaml-cpp_DIR"])
def test_everything_else_is_free(name: str) -> None:
    assert not RESERVED.fullmatch(name)
