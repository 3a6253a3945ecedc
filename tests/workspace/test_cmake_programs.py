"""Python programs that ament_python_install_package() installs."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen.model import Package
from sitegen.workspace import scan

CFG = "[options.entry_points]\nconsole_scripts =\n  talk = yard.talk:main\n  hear=yard.hear:main\n"


def package(folder: Path, command: str, config: str = CFG, name: str = "setup.cfg") -> Package:
    texts = {
        "package.xml": "<package format='3'><name>yard</name></package>",
        "CMakeLists.txt": f"cmake_minimum_required(VERSION 3.8)\nproject(yard)\n{command}\n",
        name: config,
        "yard/__init__.py": "",
        "yard/talk.py": "def main(): pass\n",
        "yard/hear.py": "def main(): pass\n",
        "extra.py": "",
    }
    for path, text in texts.items():
        file = folder / "yard" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return scan(folder)["yard"]


@pytest.mark.parametrize(
    ("options", "name"),
    [
        ("SCRIPTS_DESTINATION lib/${PROJECT_NAME}", "setup.cfg"),
        ("SCRIPTS_DESTINATION lib/yard SETUP_CFG python/yard.cfg", "python/yard.cfg"),
        ("PACKAGE_DIR yard SCRIPTS_DESTINATION lib/yard", "setup.cfg"),
    ],
)
def test_entry_points_are_programs(tmp_path: Path, options: str, name: str) -> None:
    found = package(tmp_path, f"ament_python_install_package(yard {options})", name=name)
    assert found.executables == ("talk", "hear")
    assert found.sources["talk"] == ("yard/talk.py",)
    assert found.setup
    assert found.setup.scripts == {"talk": "yard.talk:main", "hear": "yard.hear:main"}
    assert "python/yard/hear.py" in found.setup.files
    assert found.setup.faults == ()


@pytest.mark.parametrize("options", ["", "SCRIPTS_DESTINATION bin"])
def test_scripts_that_ros2_run_does_not_find(tmp_path: Path, options: str) -> None:
    found = package(tmp_path, f"ament_python_install_package(yard {options})")
    assert found.executables == ()


@pytest.mark.parametrize(
    ("options", "config", "expected"),
    [
        ("SETUP_CFG gone.cfg", CFG, "no file 'gone.cfg'; add it, or remove SETUP_CFG"),
        ("", CFG.replace("talk:main", "talk"), "'talk = yard.talk' is not a valid entry point"),
        ("", "talk = yard\n", "cannot be read"),
    ],
)
def test_what_is_wrong_is_told(tmp_path: Path, options: str, config: str, expected: str) -> None:
    command = f"ament_python_install_package(yard SCRIPTS_DESTINATION lib/yard {options})"
    found = package(tmp_path, command, config)
    assert found.setup
    (fault,) = found.setup.faults
    assert expected in fault.message


def test_modules(tmp_path: Path) -> None:
    found = package(
        tmp_path,
        "ament_python_install_module(extra.py)\n"
        "ament_python_install_module(extra.py DESTINATION_SUFFIX yard)",
    )
    assert found.setup
    assert {"python/extra.py", "python/yard/extra.py"} <= set(found.setup.files)


def test_sources_in_a_folder(tmp_path: Path) -> None:
    (tmp_path / "yard" / "src" / "deep").mkdir(parents=True)
    for name in ("src/main.cpp", "src/deep/part.cpp"):
        (tmp_path / "yard" / name).touch()
    found = package(tmp_path, "ament_auto_add_executable(walk DIRECTORY src)")
    assert found.sources["walk"] == ("src/deep/part.cpp", "src/main.cpp")
