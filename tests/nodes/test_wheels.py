"""What Python nodes need beside ROS: found by what they import, had by version and hash."""

from __future__ import annotations

import io
import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.nodes.programs import nodes_of
from sitegen.nodes.python import archives, dependencies, imports
from sitegen.nodes.python.pyodide import DOWNLOADS
from sitegen.report import Report

SHA256 = "a163dcaede0f1c021485e957a39245190e74249897e2ae4b2aa38595db237ee0"
REQUIREMENT = f"sortedcontainers==2.4.0 --hash=sha256:{SHA256}\n"
SITE = """
site: {title: Test}
nodes: {x: {package: mine, executable: run.py}}
pages:
  - {path: /, title: Test, content: [{buttons: x}, {console: x}]}
"""
PACKAGE = """<package format="3"><name>mine</name><version>1.0.0</version>
  <depend>rclpy</depend><export><build_type>ament_cmake</build_type></export>
</package>
"""
CMAKE = """
project(mine)
ament_python_install_package(${PROJECT_NAME})
install(PROGRAMS run.py DESTINATION lib/${PROJECT_NAME})
"""


@pytest.fixture
def site(tmp_path: Path) -> Path:
    package = tmp_path / "src" / "mine"
    (package / "mine" / "deep").mkdir(parents=True)
    for name in ("mine/__init__.py", "mine/deep/__init__.py", "run.py"):
        (package / name).write_text("")
    (package / "package.xml").write_text(PACKAGE)
    (package / "CMakeLists.txt").write_text(CMAKE)
    (tmp_path / "site.yaml").write_text(SITE)
    return tmp_path


def write(site: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (site / "src" / "mine" / name).write_text(text)


def problems(site: Path, tmp_path: Path) -> list[str]:
    loaded = load(site / "site.yaml")
    with pytest.raises(SiteError) as caught:
        archives.bundle(loaded, nodes_of(loaded), cache=tmp_path / "cache", report=Report())
    return caught.value.lines


def test_a_program_needs_what_its_modules_import_and_cannot_do_without(site: Path) -> None:
    write(
        site,
        {
            "run.py": "import json, mine.first\nfrom one.part import x\n",
            "mine/first.py": "from .deep import second\nfrom . import third as t, CONSTANT\n",
            "mine/deep/second.py": "from ..fourth import f\nfrom ... import beyond\n",
            "mine/third.py": "def later():\n    import two\n",
            "mine/fourth.py": (
                "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import types_only\n"
                "try:\n    import maybe\nexcept ImportError:\n    import instead\n"
                "try:\n    import three\nexcept KeyError:\n    pass\n"
            ),
            "mine/never.py": "import unused\n",
            "mine/broken.py": "import (\n",
        },
    )
    loaded = load(site / "site.yaml")
    setup = loaded.packages["mine"].setup
    assert setup
    found = imports.outside(setup.files, setup.scripts["run.py"])
    places = {name: one.location for name, one in found.items() if one.sure}
    assert {name: (place.file.name, place.line) for name, place in places.items()} == {
        "json": ("run.py", 1),
        "one": ("run.py", 2),
        "typing": ("fourth.py", 1),
        "two": ("third.py", 2),
        "instead": ("fourth.py", 7),
        "three": ("fourth.py", 9),
    }


def test_what_is_missing_is_named_when_the_site_is_built(site: Path, tmp_path: Path) -> None:
    program = "import rclpy, numpy\nimport nowhere\nimport cachetools, yaml\nnumpy.cross"
    write(site, {"run.py": program})
    advice = "add its package to the file given by 'pyodide: {requirements: requirements.txt}'"
    assert problems(site, tmp_path) == [
        "src/mine/run.py:1: import numpy: 'numpy' needs a build for Pyodide; "
        f"write 'pyodide: {{packages: {DOWNLOADS}}}' in site.yaml, "
        "or give a folder with numpy-2.4.6-cp314-cp314-pyemscripten_2026_0_wasm32.whl from there",
        "src/mine/run.py:2: import nowhere: module 'nowhere' is not available in the browser; "
        f"{advice}, or remove the import",
        "src/mine/run.py:3: import cachetools: "
        "module 'cachetools' is not available in the browser; "
        f"{advice}, or remove the import",
    ]


def test_what_only_some_runs_import_is_left_out_with_a_note(site: Path, tmp_path: Path) -> None:
    text = "def main(show):\n    if show:\n        import matplotlib.pyplot as plt\n"
    write(site, {"run.py": text})
    loaded = load(site / "site.yaml")
    report = Report(io.StringIO())
    archives.bundle(loaded, nodes_of(loaded), cache=tmp_path / "cache", report=report)
    [line] = report.said
    assert line.startswith("src/mine/run.py:3: import matplotlib: 'matplotlib' needs a build for ")
    assert line.endswith(" from there (skipped: imported only conditionally)")
    write(site, {"run.py": f"{text}\nimport matplotlib\n"})
    [line] = problems(site, tmp_path)
    assert line.startswith("src/mine/run.py:5: import matplotlib: ")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("sortedcontainers", "all requirements must have their versions pinned"),
        (REQUIREMENT.replace("a163", "0000"), "THESE PACKAGES DO NOT MATCH"),
    ],
)
def test_requirements_have_versions_and_hashes(
    site: Path, tmp_path: Path, text: str, expected: str
) -> None:
    write(site, {"run.py": "import sortedcontainers\n"})
    (site / "requirements.txt").write_text(text)
    (site / "site.yaml").write_text(SITE + "pyodide: {requirements: requirements.txt}\n")
    [line] = problems(site, tmp_path)
    assert line.startswith("requirements.txt: pip: ")
    assert expected in line


def test_compiled_packages_come_from_where_the_author_says(
    site: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The list of the distribution is replaced: its own files are in no registry."""
    shelf = tmp_path / "shelf"
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps"]
    subprocess.run([*pip, f"--dest={shelf}", "sortedcontainers==2.4.0"], check=True)
    [wheel] = shelf.iterdir()
    entry = {"file_name": wheel.name, "depends": [], "imports": ["sortedcontainers"]}
    entry["sha256"] = SHA256
    lock = tmp_path / "lock.json"
    lock.write_text(json.dumps({"packages": {"sortedcontainers": entry}}))
    monkeypatch.setattr(dependencies, "DISTRIBUTION", lock)
    write(site, {"run.py": "import sortedcontainers\n"})
    (site / "site.yaml").write_text(SITE + "pyodide: {packages: shelf}\n")
    loaded = load(site / "site.yaml")
    bundles = archives.bundle(loaded, nodes_of(loaded), cache=tmp_path / "cache", report=Report())
    path = f"nodes/wheels/{wheel.name}.zip"
    assert bundles.needed["mine", "run.py"] == (
        "nodes/ros.zip",
        path,
        "nodes/mine/python.zip",
    )
    # Of another content it is not taken, and what was taken before needs it no more.
    wheel.write_bytes(b"something else")
    assert archives.bundle(loaded, nodes_of(loaded), cache=tmp_path / "cache", report=Report())
    shutil.rmtree(tmp_path / "cache")
    [line] = problems(site, tmp_path)
    assert "import sortedcontainers: " in line
    assert "does not have the expected hash" in line
