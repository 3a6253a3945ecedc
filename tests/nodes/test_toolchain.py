"""The identity of the tools, by which compiled programs are cached."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from sitegen.nodes.cpp import libraries
from sitegen.nodes.cpp.toolchain import Toolchain


def test_eigen_installed_again_is_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = Toolchain.find()
    assert before.eigen
    again = tmp_path / "eigen"
    shutil.copytree(before.eigen, again, copy_function=shutil.copy)
    monkeypatch.setattr(libraries, "find_eigen", lambda: again)
    assert Toolchain.find().identity == before.identity
    version = again / "Eigen3ConfigVersion.cmake"
    version.write_text(version.read_text().replace("3.4.1", "3.4.2"))
    assert Toolchain.find().identity != before.identity
