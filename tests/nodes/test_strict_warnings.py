"""What is said about -Werror."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from sitegen.model import Package
from sitegen.nodes.cpp.cmake import CMake
from sitegen.nodes.cpp.compiler import Compiler
from sitegen.nodes.cpp.jobs import Job
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.options import PUBLISH
from sitegen.report import Report


def test_packages_with_errors_for_warnings_are_named_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(CMake, "has_strict_warnings", lambda _, package: package.name != "relaxed")
    said = io.StringIO()
    compiler = Compiler(Toolchain.find(), {tmp_path}, tmp_path, tmp_path, Report(said), PUBLISH)
    packages = [
        Package(name, tmp_path / name, "ament_cmake", (), (), ())
        for name in ("strict", "relaxed", "also")
    ]
    jobs = [(Job(one, (), ()), engine) for one in packages for engine in ("jspi", "asyncify")]
    compiler._tell_of_warnings(jobs)
    assert said.getvalue() == (
        "-Werror has no effect in builds for the browser: 'also', 'strict'\n"
    )
