"""Python packages as the generator reads them: their setup, and the archives made of them."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path

import pytest
from paths import SITES

from sitegen import config, workspace
from sitegen.commands.build import build
from sitegen.errors import SiteError
from sitegen.nodes.programs import nodes_of
from sitegen.nodes.python import archives
from sitegen.report import Report
from sitegen.workspace import setupfiles

PACKAGE = """<package format="3"><name>{name}</name><version>1.0.0</version>
  <exec_depend>rclpy</exec_depend>{more}
  <export><build_type>ament_python</build_type></export>
</package>
"""
SETUP_PY = """
import os
from glob import glob
from setuptools import find_packages, setup
package_name = "py_pubsub"
setup(
    name=package_name,
    packages=find_packages(exclude=["test"]),
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),
        (os.path.join("share", package_name), ["package.xml", *glob("launch/*.py")]),
        ("/etc", ["package.xml"]),
        ("share/../../elsewhere", ["package.xml"]),
    ],
    entry_points={"console_scripts": [f"talker = {package_name}.talker:main"]},
)
"""
SETUP_CFG = """
[options]
packages = find:
[options.entry_points]
console_scripts =
    talker = py_pubsub.talker:main
    listener=py_pubsub.listener:Listener.main
"""
PYPROJECT = """
[project]
name = "py_pubsub"
[project.scripts]
talker = "py_pubsub.talker:main"
[tool.setuptools.package-data]
py_pubsub = ["*.txt"]
"""
SITE = """
site: {title: Test}
nodes: {talker: {package: py_pubsub, executable: EXECUTABLE}}
pages:
  - {path: /, title: Test, content: [{buttons: talker}, {console: talker}]}
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package without a setup, in a workspace with a site."""
    folder = tmp_path / "src" / "py_pubsub"
    files = {
        "package.xml": PACKAGE.format(name="py_pubsub", more=""),
        "resource/py_pubsub": "",
        "launch/talk.launch.py": "",
        "py_pubsub/__init__.py": "",
        "py_pubsub/talker.py": "from geometry_msgs.msg import Pose\n",
        "py_pubsub/parts/__init__.py": "",
        "py_pubsub/words.txt": "",
        "test/__init__.py": "",
        "test/test_talker.py": "",
    }
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    (tmp_path / "site.yaml").write_text(SITE.replace("EXECUTABLE", "talker"))
    return folder


MODULES = {"python/py_pubsub/__init__.py", "python/py_pubsub/parts/__init__.py"}


def test_setup_py_is_read_without_running_it(package: Path) -> None:
    (package / "setup.py").write_text(SETUP_PY)
    listing = setupfiles.read(package)
    assert listing.fault is None
    assert listing.scripts == {"talker": "py_pubsub.talker:main"}
    assert set(listing.files) == MODULES | {
        "python/py_pubsub/talker.py",
        "share/ament_index/resource_index/packages/py_pubsub",
        "share/py_pubsub/package.xml",
        "share/py_pubsub/talk.launch.py",
    }


def test_scripts_of_a_setup_py_are_programs(package: Path) -> None:
    (package / "setup.py").write_text(
        "from setuptools import setup\nsetup(packages=[], scripts=['py_pubsub/talker.py'])\n"
    )
    listing = setupfiles.read(package)
    assert listing.scripts == {"talker.py": "lib/programs/talker.py"}
    assert listing.files == {"lib/programs/talker.py": "py_pubsub/talker.py"}


def test_setup_cfg_is_read(package: Path) -> None:
    (package / "setup.cfg").write_text(SETUP_CFG)
    (package / "setup.py").write_text("from setuptools import setup\nsetup()\n")
    listing = setupfiles.read(package)
    assert listing.scripts == {
        "talker": "py_pubsub.talker:main",
        "listener": "py_pubsub.listener:Listener.main",
    }
    tests = {"python/test/__init__.py", "python/test/test_talker.py"}
    assert set(listing.files) == MODULES | tests | {"python/py_pubsub/talker.py"}


def test_pyproject_is_read(package: Path) -> None:
    (package / "pyproject.toml").write_text(PYPROJECT)
    listing = setupfiles.read(package)
    assert listing.scripts == {"talker": "py_pubsub.talker:main"}
    assert "python/py_pubsub/words.txt" in listing.files


@pytest.mark.parametrize(
    ("setup", "executable", "expected"),
    [
        (
            SETUP_PY,
            "taker",
            "site.yaml:3: nodes.talker.executable: package 'py_pubsub' has no executable 'taker'; "
            "did you mean 'talker'?",
        ),
        (
            "from setuptools import setup\nsetup(packages=['py_pubsub'])\n",
            "talker",
            "site.yaml:3: nodes.talker.package: package 'py_pubsub' has no entry points; "
            "declare them in its setup.py: entry_points={'console_scripts': "
            "['talker = my_package.talker:main']}",
        ),
        (
            "from setuptools import setup\n\nsetup(entry_points=make())\n",
            "talker",
            "src/py_pubsub/setup.py:3: setup: entry_points: sitegen does not evaluate 'make()'; "
            "write the values out, or move them to setup.cfg",
        ),
        (
            "setup(\n",
            "talker",
            "src/py_pubsub/setup.py:1: setup: not valid Python: '(' was never closed "
            "(<unknown>, line 1)",
        ),
        (
            "setup(entry_points={'console_scripts': ['talker']})\n",
            "talker",
            "src/py_pubsub/setup.py:1: setup: 'talker' is not a valid entry point; "
            "write it like 'talker = "
            "my_package.talker:main'",
        ),
    ],
)
def test_what_is_wrong_with_a_package_is_said(
    package: Path, setup: str, executable: str, expected: str
) -> None:
    (package / "setup.py").write_text(setup)
    site = package.parents[1]
    (site / "site.yaml").write_text(SITE.replace("EXECUTABLE", executable))
    with pytest.raises(SiteError) as caught:
        config.load(site / "site.yaml")
    assert caught.value.lines == [expected]


def names(data: bytes) -> set[str]:
    return set(zipfile.ZipFile(io.BytesIO(data)).namelist())


def test_archives_hold_what_a_package_uses(package: Path, tmp_path: Path) -> None:
    (package / "setup.py").write_text(SETUP_PY)
    site = config.load(package.parents[1] / "site.yaml")
    bundles = archives.bundle(site, nodes_of(site), cache=tmp_path / "cache", report=Report())
    common = names(bundles.archives["nodes/ros.zip"])
    assert {"python/rclpy/_rclpy_pybind11.py", "python/rclpy/action/client.py"} <= common
    # Imported though package.xml does not name it, with what it nests; nothing else.
    assert {"python/geometry_msgs/msg/_pose.pyc", "python/std_msgs/msg/_header.pyc"} <= common
    # All that others made is compiled; what is sitegen's own may have been changed since.
    modules = {name for name in common if name.startswith(("python/rclpy/", "python/yaml/"))}
    modules = {name for name in modules if name.endswith(".py") and "_pybind11" not in name}
    folders = (name.rpartition("/") for name in modules)
    assert {f"{f}/__pycache__/{name[:-3]}.cpython-314.pyc" for f, _, name in folders} <= common
    assert not any(name.startswith("python/sensor_msgs/") for name in common)
    assert not any(name.endswith((".so", ".c", ".pyi")) for name in common)
    assert "geometry_msgs/msg/Quaternion" in bundles.types["py_pubsub"]
    assert "python/py_pubsub/talker.py" in names(bundles.archives["nodes/py_pubsub/python.zip"])


def test_archives_hold_the_files_of_packages_without_python(package: Path, tmp_path: Path) -> None:
    """Of those that the package needs, and of those that an argument names; but no meshes."""
    (package / "setup.py").write_text(SETUP_PY)
    more = "<exec_depend>robot</exec_depend>"
    (package / "package.xml").write_text(PACKAGE.format(name="py_pubsub", more=more))
    cmake = "cmake_minimum_required(VERSION 3.16)\nproject({})\n{}ament_package()\n"
    for name in ("robot", "rooms", "others"):
        folder = package.parent / name
        folder.mkdir()
        made = PACKAGE.format(name=name, more="").replace("ament_python", "ament_cmake")
        (folder / "package.xml").write_text(made)
        install = "install(FILES hall.yaml wall.STL DESTINATION share/${PROJECT_NAME}/maps)\n"
        (folder / "CMakeLists.txt").write_text(cmake.format(name, install))
        (folder / "hall.yaml").write_text(name)
        (folder / "wall.STL").write_text("solid")
    site_yaml = package.parents[1] / "site.yaml"
    given = "talker, parameters: {map: /ros/share/rooms/maps/hall.yaml}"
    site_yaml.write_text(SITE.replace("EXECUTABLE", given))
    site = config.load(site_yaml)
    bundles = archives.bundle(site, nodes_of(site), cache=tmp_path / "cache", report=Report())
    found = {
        name
        for name in names(bundles.archives["nodes/py_pubsub/python.zip"])
        if name.startswith("share/") and "py_pubsub" not in name
    }
    index = "share/ament_index/resource_index/packages"
    assert found == {
        *(f"{index}/robot", "share/robot/package.xml", "share/robot/maps/hall.yaml"),
        *(f"{index}/rooms", "share/rooms/package.xml", "share/rooms/maps/hall.yaml"),
    }


def test_a_site_of_python_nodes_needs_no_compiler(
    package: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (package / "setup.py").write_text(SETUP_PY)
    monkeypatch.setenv("PATH", str(tmp_path))
    for number in (1, 2):
        build(package.parents[1], output=tmp_path / f"dist{number}", report=Report())
    dist = tmp_path / "dist1"
    assert (dist / "runtime" / "vendor" / "pyodide" / "pyodide.asm.wasm").exists()
    assert not (dist / "runtime" / "workers" / "cpp").exists()
    for name in ("nodes/ros.zip", "nodes/py_pubsub/python.zip", "page.json"):
        assert (dist / name).read_bytes() == (tmp_path / "dist2" / name).read_bytes()


def test_a_cmake_package_may_have_programs_and_modules_of_python() -> None:
    packages = workspace.scan(SITES / "python" / "src")
    package = packages["mixed"]
    programs = ("greeter.py", "plain", "sorting.py", "packing.py", "keys.py", "outside.py")
    assert package.executables == programs
    assert package.sources["greeter.py"] == ("scripts/greeter.py",)
    assert package.setup
    files = {p: f.relative_to(package.path).as_posix() for p, f in package.setup.files.items()}
    assert files == {
        "python/mixed/__init__.py": "mixed/__init__.py",
        "python/mixed/words.py": "mixed/words.py",
        **{f"lib/mixed/{name}": f"scripts/{name}" for name in programs},
        "lib/mixed/helper": "scripts/helper.sh",
        "share/mixed/config/name.txt": "config/name.txt",
        "share/mixed/copy/package.xml": "package.xml",
        "share/mixed/package.xml": "package.xml",
        "share/ament_index/resource_index/packages/mixed": "package.xml",
    }
