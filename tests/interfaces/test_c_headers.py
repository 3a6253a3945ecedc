"""The C headers of interfaces, compiled; `tests/browser/cpp` runs what they define."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from sitegen.interfaces import generator
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.shipped import CLIENTS, ROS


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The headers of the packages of ROS."""
    folder = tmp_path_factory.mktemp("prefix")
    generator.write_ros(folder)
    return folder


@pytest.mark.parametrize(("suffix", "standard"), [("c", "c11"), ("cpp", "c++17"), ("cpp", "c++20")])
def test_all_headers_of_ros_compile_without_warnings(
    prefix: Path, tmp_path: Path, suffix: str, standard: str
) -> None:
    folders = [*(prefix / "include").iterdir(), *(ROS / "include").iterdir()]
    headers = sorted(
        file.relative_to(folder).as_posix()
        for folder in (prefix / "include").iterdir()
        for file in folder.glob("*/*/*.h")
    )
    assert {"geometry_msgs/msg/twist.h", "test_msgs/action/fibonacci.h"} <= set(headers)
    source = tmp_path / f"all.{suffix}"
    source.write_text("".join(f'#include "{name}"\n' for name in headers))
    compiler = Toolchain.find().compiler
    done = subprocess.run(
        [
            *(compiler.with_name("emcc") if suffix == "c" else compiler, source),
            *("-fsyntax-only", f"-std={standard}", "-Wall", "-Wextra", "-Werror"),
            *(f"-I{folder}" for folder in [*folders, CLIENTS / "cpp" / "include"]),
        ],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    assert (done.returncode, done.stdout) == (0, "")
