"""The workflows of this repository run commands that are there, with few rights."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import pytest
import yaml
from paths import ROOT

WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
# Its steps are run by the tests of a release, and its last job publishes.
RELEASE = "release"
CHECKS = [file for file in WORKFLOWS if file.stem != RELEASE]
TARGETS = re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE)


def steps(file: Path) -> list[dict[str, Any]]:
    jobs = yaml.safe_load(file.read_text())["jobs"].values()
    return [step for job in jobs for step in job["steps"]]


@pytest.mark.parametrize("file", CHECKS, ids=lambda file: file.stem)
def test_commands_of_workflows_exist(file: Path) -> None:
    commands = [step["run"] for step in steps(file) if "run" in step]
    assert commands
    for command in commands:
        if command.startswith("make "):
            assert command.removeprefix("make ") in TARGETS
        else:
            assert os.access(ROOT / command, os.X_OK)


@pytest.mark.parametrize("file", WORKFLOWS, ids=lambda file: file.stem)
def test_workflows_only_read(file: Path) -> None:
    workflow = yaml.safe_load(file.read_text())
    assert workflow["permissions"] == {}
    for name, job in workflow["jobs"].items():
        rights = {"id-token": "write"} if name == "publish" else {"contents": "read"}
        assert job["permissions"] == rights


def test_only_a_release_publishes_and_runs_nothing_else() -> None:
    publishing = {
        file.stem: [step.get("uses") for step in job["steps"]]
        for file in WORKFLOWS
        for name, job in yaml.safe_load(file.read_text())["jobs"].items()
        if name == "publish"
    }
    uses = ["actions/download-artifact@v6", "pypa/gh-action-pypi-publish@release/v1"]
    assert publishing == {RELEASE: uses}
