"""Python nodes that import modules which a page lacks: they are left out, and the rest is built."""

from __future__ import annotations

import json
import re
import zipfile
from pathlib import Path

import pytest
from browser import Serve
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, expect

from sitegen.__main__ import main
from sitegen.nodes.python import dependencies
from sitegen.nodes.python.pyodide import DOWNLOADS, VERSION

MANIFEST = """<package format="3"><name>camtools</name><version>1.0.0</version>
  <depend>rclpy</depend><export><build_type>ament_python</build_type></export>
</package>
"""
SETUP = """from setuptools import setup
names = ["talker", "fit", "smooth", "grab"]
setup(name="camtools", packages=["camtools"],
      data_files=[("share/camtools/launch", ["launch/all.launch.py", "launch/bad.launch.py"])],
      entry_points={"console_scripts": [f"{name} = camtools.{name}:main" for name in names]})
"""
LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    return LaunchDescription([Node(package="camtools", executable=n) for n in %s])
"""
FIT = "import numpy as np\n\n\ndef main():\n    np.linalg.lstsq([], [])\n"
FILES = {
    "package.xml": MANIFEST,
    "setup.py": SETUP,
    "launch/all.launch.py": LAUNCH % '["talker", "fit", "smooth", "grab"]',
    "launch/bad.launch.py": LAUNCH % '["fit"]',
    "camtools/__init__.py": "",
    "camtools/talker.py": "def main():\n    print('works')\n",
    "camtools/fit.py": FIT,
    "camtools/smooth.py": f"\n{FIT}",
    "camtools/grab.py": "import serial\n\n\ndef main(): ...\n",
}
WHEEL = "numpy-2.4.6-cp314-cp314-pyemscripten_2026_0_wasm32.whl"
NUMPY = (
    "import numpy: 'numpy' needs a build for Pyodide; "
    f"write 'pyodide: {{packages: {DOWNLOADS}}}' in site.yaml, or give a folder with {WHEEL} "
    "from there"
)
SERIAL = (
    "import serial: module 'serial' is not available in the browser; add its package to the file "
    "given by 'pyodide: {requirements: requirements.txt}', or remove the import"
)
FIT_LINE = f"src/camtools/camtools/fit.py:1: {NUMPY}"
SAID = [
    f"{FIT_LINE} (left out: camtools/fit, camtools/smooth)",
    f"src/camtools/camtools/grab.py:1: {SERIAL} (left out: camtools/grab)",
]
SITE = """\
site: {title: Test}
pages: [{path: /, title: Test, launch: src/camtools/launch/all.launch.py}]
"""
NODES = """\
site: {title: Test}
nodes:
  one: {package: camtools, executable: talker}
  two: {package: camtools, executable: fit}
pages:
  - {path: /, title: Test, content: [{console: one}, {console: two}]}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        file = tmp_path / "src/camtools" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return tmp_path


def test_init_writes_the_page_of_a_launch_file_without_nodes_that_lack_modules(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["init", str(folder)]) == 0
    skipped = [
        line.removeprefix("  skipped: ")
        for line in capsys.readouterr().out.splitlines()
        if line.startswith("  skipped: ")
    ]
    nothing = "src/camtools/launch/bad.launch.py: starts no node that can run in the browser"
    assert skipped == [nothing, *SAID]
    text = (folder / "site.yaml").read_text()
    assert "launch: src/camtools/launch/all.launch.py" in text
    assert "talker: {package: camtools" in text and "fit: {" not in text
    assert all(f"#   {line}" in text for line in skipped)
    assert main(["build", str(folder)]) == 0


def test_nodes_of_launch_files_are_left_out_with_one_line_for_each_module(
    folder: Path, capsys: pytest.CaptureFixture[str], browser: Browser, serve: Serve
) -> None:
    (folder / "site.yaml").write_text(SITE)
    assert main(["check", str(folder)]) == 0
    assert capsys.readouterr().err.splitlines() == SAID
    assert main(["check", "--strict", str(folder)]) == 1
    capsys.readouterr()

    assert main(["build", str(folder)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line for line in lines if "left out" in line] == SAID
    assert "  camtools/fit: did not build" in lines
    page = browser.new_page()
    page.goto(serve(folder / "dist"))
    talker, fit = Panel(page, "talker"), Panel(page, "fit")
    expect(talker.console).to_contain_text("works")
    fit.expect_state("failed")
    expect(fit.console).to_contain_text(f"fit: did not build: {FIT_LINE}")


def test_a_node_of_site_yaml_that_lacks_a_module_is_an_error_unless_the_build_keeps_going(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "site.yaml").write_text(NODES)
    assert main(["build", str(folder)]) == 1
    assert FIT_LINE in capsys.readouterr().err.splitlines()
    assert not (folder / "dist").exists()

    assert main(["build", "--keep-going", str(folder)]) == 0
    assert f"{FIT_LINE} (left out: camtools/fit)" in capsys.readouterr().out.splitlines()
    nodes = json.loads((folder / "dist/page.json").read_text())["nodes"]
    assert nodes["two"]["fault"] == FIT_LINE and "python" not in nodes["two"]
    assert "python" in nodes["one"]

    # A launch file on another page does not make it optional.
    more = "  - {path: b/, title: B, launch: src/camtools/launch/all.launch.py}\n"
    (folder / "site.yaml").write_text(NODES + more)
    assert main(["build", str(folder)]) == 1
    assert FIT_LINE in capsys.readouterr().err.splitlines()


def test_a_folder_without_the_file_of_a_package_is_told_which_to_add(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "vendor").mkdir()
    (folder / "site.yaml").write_text(f"{SITE}pyodide: {{packages: vendor}}\n")
    assert main(["check", str(folder)]) == 0
    assert capsys.readouterr().err.splitlines()[0] == (
        "src/camtools/camtools/fit.py:1: import numpy: 'numpy' is not in the folder of "
        f"'pyodide: packages'; add {WHEEL} from {DOWNLOADS} "
        "(left out: camtools/fit, camtools/smooth)"
    )
    # One that is there is used, so a wrong one is an error.
    (folder / "vendor" / WHEEL).write_bytes(b"another")
    assert main(["check", str(folder)]) == 1
    assert WHEEL in capsys.readouterr().err


def test_messages_name_the_release_of_pyodide_that_pages_load() -> None:
    assert json.loads((ROOT / "package.json").read_text())["dependencies"]["pyodide"] == VERSION
    loader = (ROOT / "sitegen/runtime/vendor/pyodide/pyodide.mjs").read_text()
    assert f'"{VERSION}"' in loader
    assert DOWNLOADS.replace(VERSION, "${U}") in loader


def test_interfaces_that_are_missing_are_cloned() -> None:
    assert dependencies.unavailable("nav2_msgs") == (
        "needs package 'nav2_msgs', which is not in the workspace; clone its sources there: "
        "git clone -b kilted https://github.com/ros-planning/navigation2.git"
    )
    assert "requirements.txt" in dependencies.unavailable("acme_msgs")


def test_packages_of_ros_are_cloned_if_they_are_its_own_or_the_workspace_names_them() -> None:
    clone = "clone its sources there: git clone -b "
    for name in ("nav2_simple_commander", "interactive_markers", "rosidl_runtime_py"):
        assert clone in dependencies.unavailable(name)
    name = "dynamixel_sdk"
    assert clone in dependencies.unavailable(name, {name})
    assert "requirements.txt" in dependencies.unavailable(name)
    assert "requirements.txt" in dependencies.unavailable("acme_tools", {"acme_tools"})
    # pyserial on PyPI has the name of a package of ROS.
    assert "requirements.txt" in dependencies.unavailable("serial", {"python3-serial"})


@pytest.mark.parametrize(
    "module", ["cv_bridge", "PyQt5", "python_qt_binding", "rosbag2_py", "tkinter"]
)
def test_packages_that_no_page_can_have_are_not_cloned(module: str) -> None:
    said = f"needs '{module}', which has no build for the page"
    assert dependencies.unavailable(module, {module}) == said


def test_a_clone_is_advised_for_a_module_that_package_xml_names(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = folder / "src/camtools"
    (package / "package.xml").write_text(
        MANIFEST.replace("<depend>rclpy", "<depend>rosidl_runtime_py</depend><depend>rclpy")
    )
    (package / "camtools/grab.py").write_text("import rosidl_runtime_py\n\n\ndef main(): ...\n")
    line = (
        "src/camtools/camtools/grab.py:1: import rosidl_runtime_py: needs package "
        "'rosidl_runtime_py', which is not in the workspace; clone its sources there: "
        "git clone -b kilted https://github.com/ros2/rosidl_runtime_py.git "
        "(left out: camtools/grab)"
    )
    assert main(["init", str(folder)]) == 0
    assert f"  skipped: {line}" in capsys.readouterr().out.splitlines()
    assert main(["build", str(folder)]) == 0
    assert line in capsys.readouterr().out.splitlines()


def test_programs_whose_modules_of_python_no_page_has_are_left_out(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = folder / "src/camtools/camtools"
    (package / "grab.py").write_text("import tkinter\n\n\ndef main(): ...\n")
    (package / "talker.py").write_text("import termios, tty, select\n\n\ndef main(): ...\n")
    (package / "smooth.py").write_text(
        "import sys\nif sys.platform == 'win32':\n    import msvcrt\n\n\ndef main(): ...\n"
    )
    assert main(["init", str(folder)]) == 0
    lines = [line for line in capsys.readouterr().out.splitlines() if "skipped: " in line]
    assert (
        "  skipped: src/camtools/camtools/grab.py:1: import tkinter: needs 'tkinter', which has "
        "no build for the page (left out: camtools/grab)"
    ) in lines
    assert not any("talker.py" in line or "smooth.py" in line for line in lines)


def test_pyodide_has_none_of_the_modules_of_python_that_are_absent() -> None:
    with zipfile.ZipFile(ROOT / "sitegen/runtime/vendor/pyodide/python_stdlib.zip") as archive:
        there = {name.partition("/")[0].partition(".")[0] for name in archive.namelist()}
    assert {"argparse", "json", "tty"} <= there
    assert dependencies.ABSENT.isdisjoint(there)


def test_packaging_comes_with_the_programs_that_import_it(
    folder: Path, capsys: pytest.CaptureFixture[str], browser: Browser, serve: Serve
) -> None:
    talker = folder / "src/camtools/camtools/talker.py"
    talker.write_text(
        "import packaging.version\n\n\ndef main():\n"
        "    print(packaging.version.parse('3.10') > packaging.version.parse('3.9'))\n"
    )
    assert main(["init", str(folder)]) == 0
    (folder / "site.yaml").write_text(SITE)
    assert main(["build", str(folder)]) == 0
    assert "import packaging" not in capsys.readouterr().out
    page = browser.new_page()
    page.goto(serve(folder / "dist"))
    expect(Panel(page, "talker").console).to_contain_text("True")
    with zipfile.ZipFile(folder / "dist/nodes/packaging.zip") as archive:
        assert any("LICENSE.BSD" in name for name in archive.namelist())


def test_every_package_of_the_distribution_has_a_message() -> None:
    lock = json.loads(dependencies.DISTRIBUTION.read_text())["packages"]
    modules = {module for one in lock.values() for module in one["imports"]}
    assert len(modules) > 300
    for module in modules:
        assert re.search(r"requirements\.txt|\.whl from there$", dependencies.unavailable(module))
