"""What a release consists of: the same bytes for everyone, which need no Node.js to install."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from hashlib import sha256
from pathlib import Path

import pytest
from distribution import RELEASE, environment
from paths import ROOT
from workflow import system, workflow


@pytest.mark.exhaustive
def test_the_steps_of_a_release_end_with_an_sdist_and_a_wheel(dist: Path) -> None:
    wheel, sdist = sorted(dist.iterdir())
    assert sdist.name.startswith("ros_sitegen-") and sdist.name.endswith(".tar.gz")
    assert wheel.name.startswith("ros_sitegen-") and wheel.name.endswith("-py3-none-any.whl")
    jobs = workflow(RELEASE)["jobs"]
    [upload] = [step for step in jobs["build"]["steps"] if "upload" in step.get("uses", "")]
    [download] = [step for step in jobs["publish"]["steps"] if "download" in step.get("uses", "")]
    assert upload["with"]["path"] == download["with"]["path"] == dist.name
    names = zipfile.ZipFile(wheel).namelist()
    for file in ("ros/bytecode.zip", "runtime/vendor/pyodide/pyodide.asm.wasm", "themes/default"):
        assert any(name.startswith(f"sitegen/{file}") for name in names), file
    assert not [name for name in names if "__pycache__" in name or "node_modules" in name]


@pytest.mark.exhaustive
def test_an_sdist_becomes_the_same_wheel_without_node(dist: Path, tmp_path: Path) -> None:
    wheel, sdist = sorted(dist.iterdir())
    time = subprocess.check_output(["git", "log", "-1", "--format=%ct"], cwd=dist, text=True)
    path = system(tmp_path / "bin", without=("node", "npm"))
    pip = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps"]
    subprocess.run(
        [*pip, "--wheel-dir", "made", str(sdist)],
        cwd=tmp_path,
        env=environment(tmp_path, PATH=str(path), SOURCE_DATE_EPOCH=time.strip()),
        check=True,
    )
    made = tmp_path / "made" / wheel.name
    assert sha256(made.read_bytes()).digest() == sha256(wheel.read_bytes()).digest()


def test_two_builds_that_differ_are_no_release(tmp_path: Path) -> None:
    script = tmp_path / ".ci" / "release"
    script.parent.mkdir()
    script.write_bytes((ROOT / ".ci" / "release").read_bytes())
    python = tmp_path / "bin" / "python"
    python.parent.mkdir()
    python.write_text('#!/bin/sh\nmkdir "$4" && pwd > "$4/a.whl" && echo "$4" >> "$4/a.whl"\n')
    python.chmod(0o755)
    who = ["-c", "user.name=A", "-c", "user.email=a@example.org"]
    for words in (["init", "-q"], ["add", "-A"], [*who, "commit", "-qm", "Begin"]):
        subprocess.run(["git", *words], cwd=tmp_path, check=True)
    env = {**os.environ, "PATH": f"{python.parent}{os.pathsep}{os.environ['PATH']}"}
    done = subprocess.run(["sh", script], cwd=tmp_path, env=env, text=True, capture_output=True)
    assert (done.returncode, (tmp_path / "dist").exists()) == (1, False)
    assert "the second build has other bytes:" in done.stderr
