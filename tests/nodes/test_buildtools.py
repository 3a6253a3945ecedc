"""Programs of Python packages that CMake runs, as the generators of code on a robot."""

from __future__ import annotations

import sys

from configuring import Configuring

USE = """\
find_program(MAKE_HEADER make_header REQUIRED)
add_custom_command(
  OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/speed.hpp
  COMMAND ${MAKE_HEADER} "two words" ${CMAKE_CURRENT_BINARY_DIR}/speed.hpp)
add_executable(drive src/main.cpp ${CMAKE_CURRENT_BINARY_DIR}/speed.hpp)
target_include_directories(drive PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
"""
SETUP = """\
from setuptools import setup
setup(name="generators", packages=["generators"],
      entry_points={"console_scripts": ["make_header = generators.header:main"]})
"""
HEADER = """\
import sys
import words
def main():
    with open(sys.argv[2], "w") as file:
        file.write(f"#define SPEED {words.speed}\\n#define SAID \\"{sys.argv[1]}\\"\\n")
"""
MAIN = """\
#include <string_view>
#include "speed.hpp"
static_assert(SPEED == 3 && std::string_view(SAID) == "two words");
int main() {}
"""


def python_package(packages: Configuring, name: str, setup: str, modules: dict[str, str]) -> None:
    export = "<export><build_type>ament_python</build_type></export>"
    packages.write(f"{name}/package.xml", f"<package><name>{name}</name>{export}</package>")
    packages.write(f"{name}/setup.py", setup)
    for module, text in modules.items():
        packages.write(f"{name}/{module}.py", text)


def test_a_program_of_a_package_generates_a_header(packages: Configuring) -> None:
    modules = {"generators/__init__": "", "generators/header": HEADER}
    python_package(packages, "generators", SETUP, modules)
    words = "from setuptools import setup\nsetup(name='words', py_modules=['words'])\n"
    python_package(packages, "words", words, {"words": "speed = 3\n"})
    packages.package("robot", USE, main=MAIN)
    assert packages.configure("robot", needs=["words", "generators"]) == ""
    assert packages.compile("robot", "drive") == ""


def test_a_module_that_a_program_lacks_is_told(packages: Configuring) -> None:
    modules = {"generators/__init__": "", "generators/header": "import acme_words\n"}
    python_package(packages, "generators", SETUP, modules)
    packages.package("robot", USE, main=MAIN)
    assert packages.configure("robot", needs=["generators"]) == ""
    assert packages.explain("robot", "drive") == [
        "robot/CMakeLists.txt: a program that the build of 'robot' runs needs the Python module "
        f"'acme_words': {sys.executable} -m pip install acme_words"
    ]
