"""What CMake installs of packages with Python programs, by variables, patterns and folders."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen import config
from sitegen.errors import SiteError
from sitegen.model import Package
from sitegen.nodes.python import imports
from sitegen.workspace import scan

MANIFEST = """<package format="3"><name>yard</name><version>1.0.0</version><depend>rclpy</depend>
<export><build_type>ament_cmake</build_type></export></package>
"""
FILES = (
    *("scripts/one.py", "scripts/helper.py", "nodes/two.py", "nodes/three.py", "tools/four.py"),
    *("config/yard.yaml", "config/deep/more.yaml", "maps/a.pgm", "yard/__init__.py", "yard/a.py"),
    *("msg/Num.msg", "msg/More.msg", "srv/Add.srv"),
)
SHARE = {"share/yard/package.xml", "share/ament_index/resource_index/packages/yard"}
ONE = "install(PROGRAMS scripts/one.py DESTINATION lib/${PROJECT_NAME})\n"
# By commands: the files that they install besides those of every package.
INSTALLS = {
    "install(PROGRAMS ${CMAKE_CURRENT_SOURCE_DIR}/scripts/one.py DESTINATION lib/yard)": {
        "lib/yard/one.py"
    },
    "install(PROGRAMS ${yard_SOURCE_DIR}/scripts/one.py RENAME one DESTINATION lib/yard)": {
        "lib/yard/one"
    },
    'include(GNUInstallDirs)\nfile(GLOB NODES "${PROJECT_SOURCE_DIR}/nodes/*.py")\n'
    "install(PROGRAMS ${NODES} DESTINATION ${CMAKE_INSTALL_LIBDIR}/${PROJECT_NAME})": {
        "lib/yard/two.py",
        "lib/yard/three.py",
    },
    "file(GLOB NODES RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS nodes/t*.py)\n"
    "foreach(node IN LISTS NODES)\ninstall(PROGRAMS ${node} DESTINATION lib/yard)\nendforeach()": {
        "lib/yard/two.py",
        "lib/yard/three.py",
    },
    "add_subdirectory(tools)": {"lib/yard/four.py"},
    "set(FOLDERS tools)\nforeach(f ${FOLDERS})\nadd_subdirectory(${f})\nendforeach()": {
        "lib/yard/four.py"
    },
    "install(PROGRAMS scripts/one.py COMPONENT all DESTINATION "
    '"${CMAKE_INSTALL_PREFIX}/lib/${PROJECT_NAME}" RENAME uno)': {"lib/yard/uno"},
    ONE + "install(DIRECTORY ${PROJECT_SOURCE_DIR}/maps DESTINATION share/${PROJECT_NAME})": {
        "lib/yard/one.py",
        "share/yard/maps/a.pgm",
    },
    ONE + "file(GLOB_RECURSE CONFIGS config/*.yaml)\n"
    "install(FILES ${CONFIGS} DESTINATION ${CMAKE_INSTALL_DATADIR}/yard)": {
        "lib/yard/one.py",
        "share/yard/yard.yaml",
        "share/yard/more.yaml",
    },
    ONE + "ament_auto_package(INSTALL_TO_SHARE config maps)": {
        "lib/yard/one.py",
        "share/yard/config/yard.yaml",
        "share/yard/config/deep/more.yaml",
        "share/yard/maps/a.pgm",
    },
    ONE + "install(FILES yard/a.py DESTINATION ${PYTHON_INSTALL_DIR}/yard)": {
        "lib/yard/one.py",
        "python/yard/a.py",
    },
    ONE + "install(FILES ${CMAKE_CURRENT_BINARY_DIR}/version.h DESTINATION include)": {
        "lib/yard/one.py"
    },
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    top = tmp_path / "src/yard"
    for name in FILES:
        (top / name).parent.mkdir(parents=True, exist_ok=True)
        (top / name).write_text("#!/usr/bin/env python3\nimport helper\n")
    (top / "package.xml").write_text(MANIFEST)
    (top / "tools/CMakeLists.txt").write_text(
        "install(PROGRAMS four.py DESTINATION lib/${PROJECT_NAME})\n"
    )
    return top


def read(folder: Path, cmake: str) -> Package:
    text = f"cmake_minimum_required(VERSION 3.8)\nproject(yard)\n{cmake}\n"
    (folder / "CMakeLists.txt").write_text(text)
    return scan(folder.parent)["yard"]


@pytest.mark.parametrize("cmake", INSTALLS)
def test_what_is_installed(folder: Path, cmake: str) -> None:
    package = read(folder, cmake)
    assert package.setup
    assert not package.setup.faults
    assert set(package.setup.files) - SHARE == INSTALLS[cmake]
    programs = {Path(path).name for path in INSTALLS[cmake] if path.startswith("lib/")}
    assert set(package.executables or ()) == programs


def test_messages_are_found_by_patterns(folder: Path) -> None:
    cmake = """set(MSGS_DIR "${CMAKE_CURRENT_SOURCE_DIR}/msg")
file(GLOB MSGS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} "${MSGS_DIR}/*.msg")
file(GLOB SRVS ${CMAKE_CURRENT_SOURCE_DIR}/srv/*.srv)
rosidl_generate_interfaces(${PROJECT_NAME} ${MSGS} ${SRVS})
"""
    assert read(folder, cmake).interfaces == ("msg/More.msg", "msg/Num.msg", "srv/Add.srv")


def test_modules_beside_a_program_are_its_own(folder: Path) -> None:
    cmake = "install(PROGRAMS scripts/one.py scripts/helper.py DESTINATION lib/yard)"
    setup = read(folder, cmake).setup
    assert setup
    assert imports.outside(setup.files, "lib/yard/one.py") == {}
    alone = {path: file for path, file in setup.files.items() if "helper" not in path}
    assert set(imports.outside(alone, "lib/yard/one.py")) == {"helper"}


SITE = """site: {title: Yard}
nodes: {one: {package: yard, executable: one.py}}
pages: [{path: /, title: Yard, content: [{console: one}]}]
"""


@pytest.mark.parametrize(
    ("cmake", "expected"),
    [
        (
            f"{ONE}install(FILES ${{CMAKE_CURRENT_BINARY_DIR}}/a.yaml DESTINATION share/yard)",
            "4: install: 'a.yaml' is made by the build, which is not run for Python programs; "
            "install a file of the package",
        ),
        (
            "execute_process(COMMAND ls OUTPUT_VARIABLE NODES)\n"
            "install(PROGRAMS ${NODES} DESTINATION lib/yard)",
            "4: install: sitegen does not know the value of '${NODES}'; write it out",
        ),
    ],
)
def test_what_only_cmake_knows_is_said(folder: Path, cmake: str, expected: str) -> None:
    read(folder, cmake)
    site = folder.parents[1] / "site.yaml"
    site.write_text(SITE)
    with pytest.raises(SiteError) as caught:
        config.load(site)
    assert caught.value.lines == [f"src/yard/CMakeLists.txt:{expected}"]


def problems(folder: Path, cmake: str, executable: str = "one.py") -> list[str]:
    read(folder, cmake)
    site = folder.parents[1] / "site.yaml"
    site.write_text(SITE.replace("one.py", executable))
    try:
        return list(config.load(site).notes)
    except SiteError as error:
        return error.lines


CMAKE = "src/yard/CMakeLists.txt"
GONE = "install(FILES gone.yaml DESTINATION share/yard)\n"
GONE_LINE = "install: no file 'gone.yaml'; add it, or remove it from this command"


def test_all_faults_of_the_package_of_a_node_are_said(folder: Path) -> None:
    cmake = f"{ONE}{GONE}add_subdirectory(${{WHERE}}/nodes)"
    unknown = "add_subdirectory: sitegen does not know the value of '${WHERE}/nodes'; write it out"
    assert problems(folder, cmake) == [f"{CMAKE}:4: {GONE_LINE}", f"{CMAKE}:5: {unknown}"]
    # This program may be in the folder.
    assert problems(folder, cmake, "six.py") == [f"{CMAKE}:5: {unknown}"]


def test_a_program_that_is_not_installed_is_not_hidden_by_other_files(folder: Path) -> None:
    assert problems(folder, ONE + GONE, "six.py") == [
        "site.yaml:2: nodes.one.executable: package 'yard' has no executable 'six.py'; "
        "known: one.py"
    ]


def test_cplusplus_programs_are_left_to_cmake(folder: Path) -> None:
    cmake = f"add_executable(talker a.cpp)\n{GONE}add_subdirectory(${{WHERE}})"
    assert problems(folder, cmake, "talker") == []
    assert problems(folder, cmake, "other") == []


def test_what_is_doubtful_in_needed_packages_is_noted(folder: Path) -> None:
    other = folder.parent / "fence"
    (other / "fence").mkdir(parents=True)
    (other / "fence/__init__.py").write_text("")
    (other / "package.xml").write_text(MANIFEST.replace("yard", "fence"))
    (other / "CMakeLists.txt").write_text(
        f"project(fence)\nament_python_install_package(fence)\n{GONE}install(SCRIPT a.cmake)\n"
    )
    assert problems(folder, ONE) == []
    text = (folder / "package.xml").read_text()
    (folder / "package.xml").write_text(text.replace("rclpy</", "rclpy</depend><depend>fence</"))
    run = "install: SCRIPT is not run for Python programs; a page lacks the files that it installs"
    assert problems(folder, ONE) == [
        f"src/fence/CMakeLists.txt:3: {GONE_LINE}",
        f"src/fence/CMakeLists.txt:4: {run}",
    ]
