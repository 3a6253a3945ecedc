"""Compiled packages for Python nodes, from PyPI and from a folder of the Pyodide distribution."""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from browser import Serve
from playwright.sync_api import Browser

from sitegen.commands.build import build
from sitegen.errors import SiteError
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.nodes.python import dependencies
from sitegen.report import Report
from tests.native.test_rclpy import printed, run

CONTOURPY = "fa1b787362a3856e63dd2b89449f6c384d55ee1beb8f94f4bcc871b40f02462c"
TAG = "cp314-cp314-pyemscripten_2026_0_wasm32"
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
CMAKE = "project(mine)\ninstall(PROGRAMS run.py DESTINATION lib/${PROJECT_NAME})\n"
PROGRAM = """
import ctypes
import msgpack

print(msgpack.Packer.__module__, msgpack.unpackb(msgpack.packb([1, "two"])))
print(ctypes.CDLL("libtwice.so").twice(21))
"""


@pytest.fixture
def site(tmp_path: Path) -> Path:
    package = tmp_path / "src" / "mine"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(PACKAGE)
    (package / "CMakeLists.txt").write_text(CMAKE)
    (package / "run.py").write_text(PROGRAM)
    (tmp_path / "site.yaml").write_text(SITE)
    return tmp_path


def require(site: Path, *lines: str, more: str = "") -> None:
    (site / "requirements.txt").write_text("".join(f"{line}\n" for line in lines))
    keys = f"pyodide: {{requirements: requirements.txt{more}}}\n"
    (site / "site.yaml").write_text(SITE + keys)


def problems(site: Path) -> list[str]:
    with pytest.raises(SiteError) as caught:
        build(site, output=site / "dist", report=Report())
    return caught.value.lines


def shelved(shelf: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Put a wheel and a shared library on a shelf; the distribution's own are in no registry."""
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps"]
    command += ["--only-binary=:all:", "--implementation=cp", "--abi=cp314"]
    command += ["--python-version=314", f"--platform={TAG.rpartition('-')[2]}"]
    subprocess.run([*command, f"--dest={shelf}", "msgpack==1.2.4"], check=True)
    source, library = shelf / "twice.c", shelf / "libtwice.so"
    source.write_text("int twice(int x) { return 2 * x; }")
    tools = Toolchain.find()
    words = ("-O1", "-fPIC", "-sSIDE_MODULE=1")
    done = tools.run(tools.compiler, "-x", "c", source, *words, "-o", library)
    assert done.returncode == 0, done.stdout
    with zipfile.ZipFile(shelf / "libtwice-1.0.zip", "w") as archive:
        archive.write(library, "libtwice.so")
    packages = {
        "msgpack": (f"msgpack-1.2.4-{TAG}.whl", ["libtwice"], ["msgpack"]),
        "libtwice": ("libtwice-1.0.zip", [], []),
    }
    lock = shelf / "lock.json"
    entries = {
        name: {
            "file_name": file,
            "depends": depends,
            "imports": imports,
            "sha256": hashlib.sha256((shelf / file).read_bytes()).hexdigest(),
        }
        for name, (file, depends, imports) in packages.items()
    }
    lock.write_text(json.dumps({"packages": entries}))
    monkeypatch.setattr(dependencies, "DISTRIBUTION", lock)


def test_packages_of_the_distribution_run_with_the_libraries_that_they_need(
    site: Path, browser: Browser, serve: Serve, monkeypatch: pytest.MonkeyPatch
) -> None:
    shelved(site / "shelf", monkeypatch)
    (site / "site.yaml").write_text(SITE + "pyodide: {packages: shelf}\n")
    build(site, output=site / "dist", report=Report())
    page = browser.new_page()
    page.goto(serve(site / "dist"))
    state, lines = run(page, "x")
    assert printed(lines) == ["msgpack._cmsgpack [1, 'two']", "42"], lines
    assert state == "stopped"


def test_what_pinned_packages_need_is_pinned_too_or_of_the_distribution(
    site: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (site / "src" / "mine" / "run.py").write_text("import contourpy\n")
    require(site, f"contourpy==1.4.0 --hash=sha256:{CONTOURPY}")
    assert problems(site) == [
        "requirements.txt:1: contourpy: it needs 'numpy'; 'numpy' needs a build for Pyodide; "
        f"{dependencies.unavailable('numpy').partition('; ')[2]}"
    ]
    shelved(site / "shelf", monkeypatch)
    lock = json.loads((site / "shelf" / "lock.json").read_text())
    lock["packages"]["numpy"] = lock["packages"].pop("msgpack")
    (site / "shelf" / "lock.json").write_text(json.dumps(lock))
    require(site, f"contourpy==1.4.0 --hash=sha256:{CONTOURPY}", more=", packages: shelf")
    build(site, output=site / "dist", report=Report())
    assert sorted(file.name for file in (site / "dist" / "nodes" / "wheels").iterdir()) == [
        f"contourpy-1.4.0-{TAG}.whl.zip",
        "libtwice-1.0.zip.zip",
        f"msgpack-1.2.4-{TAG}.whl.zip",
    ]


def test_it_is_told_what_a_package_without_a_wheel_would_need(site: Path) -> None:
    require(site, f"numpy==2.4.6 --hash=sha256:{CONTOURPY}")
    assert problems(site) == [
        "requirements.txt: numpy==2.4.6: no compatible wheel found; use a pure Python package, "
        f"or one compiled for Pyodide ({TAG})"
    ]


def test_a_compiled_wheel_of_another_hash_is_refused(site: Path) -> None:
    require(site, f"msgpack==1.2.4 --hash=sha256:{CONTOURPY}")
    [line] = problems(site)
    assert line.startswith("requirements.txt: pip: THESE PACKAGES DO NOT MATCH THE HASHES")
