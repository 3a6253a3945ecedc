"""The workflows for GitHub: well-formed, with few rights, and their commands run here, too."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest
from paths import ROOT
from workflow import Runner
from workflow import workflow as read

from sitegen.__main__ import main
from sitegen.commands import installed

# Steps that prepare a computer of GitHub; here, all that is done already.
PREPARES = ("Install Emscripten", "Install sitegen")

REQUIRED = "ros-sitegen @ git+https://github.com/me/sitegen@0123456789"


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository with a workspace in a folder of it, and no site yet."""
    subprocess.run(["git", "init", "-q", "-b", "trunk", tmp_path], check=True)
    monkeypatch.setattr(installed, "requirement", lambda: installed.Requirement(REQUIRED))
    shutil.copytree(ROOT / "demos" / "demo01" / "src", tmp_path / "web" / "src")
    return tmp_path


def workflow(repository: Path, name: str) -> dict[str, Any]:
    return read(repository / ".github" / "workflows" / f"{name}.yml")


def run(workflow: dict[str, Any], job: str, repository: Path, **given: str) -> list[str]:
    """Run the commands of a job but those that prepare; tests of the wheel run all of them."""
    path = [Path(sys.executable).parent, *map(Path, os.environ["PATH"].split(os.pathsep))]
    return Runner(repository, path, os.environ, without=PREPARES).run(workflow, job, **given)


def test_the_site_is_built_and_published(
    repository: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["init", "--github", str(repository / "web")]) == 0
    out = capsys.readouterr().out
    for name in ("web/site.yaml", ".github/workflows/pages.yml", ".github/workflows/nodes.yml"):
        assert f"wrote {repository / name}" in out
    pages = workflow(repository, "pages")
    assert pages["on"] == {"push": {"branches": ["trunk"]}, "workflow_dispatch": None}
    assert pages["env"] == {"SITE": "web", "SITEGEN": REQUIRED}
    assert run(pages, "build", repository) == ["Check the site", "Build the site"]
    [upload] = [
        step for step in pages["jobs"]["build"]["steps"] if "upload" in step.get("uses", "")
    ]
    path = upload["with"]["path"].replace("${{ env.SITE }}", "web")
    assert (repository / path / "index.html").exists()
    assert (repository / path / "nodes/cpp_hello/talker.jspi.wasm").exists()


def test_nodes_are_compiled_for_others(repository: Path, tmp_path: Path) -> None:
    assert main(["init", "--github", str(repository / "web")]) == 0
    nodes = workflow(repository, "nodes")
    assert list(nodes["on"]) == ["workflow_dispatch"]
    assert nodes["on"]["workflow_dispatch"]["inputs"]["package"]["required"] is True
    # What is typed is no more than a name: neither an option, nor a pattern, nor a command.
    given = {"${{ inputs.package }}": "cpp_hello/talker cpp_hello"}
    assert run(nodes, "compile", repository, **given) == [
        "Compile",
        "Unpack the archive",
        "Explain how to use the archive",
    ]
    assert "compiled: nodes.zip" in (repository / "summary.md").read_text()

    # What GitHub packs of the folder is an archive as it is.
    site = tmp_path / "far"
    site.mkdir()
    with zipfile.ZipFile(site / "nodes.zip", "w") as packed:
        for file in sorted((repository / "nodes").rglob("*")):
            packed.write(file, file.relative_to(repository / "nodes"))
    (site / "site.yaml").write_text(
        "site: {title: Far}\nnodes: {talker: {compiled: nodes.zip}}\n"
        "pages: [{path: /, title: Far, content: [{console: talker}]}]\n"
    )
    assert main(["build", str(site)]) == 0


@pytest.mark.parametrize("typed", ["--help", "$(touch evil)", "*", "cpp_hello; touch evil"])
def test_what_is_typed_is_a_name(typed: str, repository: Path) -> None:
    assert main(["init", "--github", str(repository / "web")]) == 0
    nodes = workflow(repository, "nodes")
    with pytest.raises(AssertionError, match="no package"):
        run(nodes, "compile", repository, **{"${{ inputs.package }}": typed})
    assert not (repository / "evil").exists()


@pytest.mark.parametrize("name", ["pages", "nodes"])
def test_rights_are_few(name: str, repository: Path) -> None:
    assert main(["init", "--github", str(repository / "web")]) == 0
    found = workflow(repository, name)
    assert found["permissions"] == {}
    rights = {job: given["permissions"] for job, given in found["jobs"].items()}
    assert (
        rights
        == {
            "pages": {
                "build": {"contents": "read"},
                "deploy": {"pages": "write", "id-token": "write"},
            },
            "nodes": {"compile": {"contents": "read"}},
        }[name]
    )
    for job in found["jobs"].values():
        for step in job["steps"]:
            assert ("run" in step and step["name"]) or re.fullmatch(
                r"actions/[\w-]+@v\d+", step["uses"]
            )
            if step.get("uses", "").startswith("actions/checkout@"):
                assert step["with"]["persist-credentials"] is False
            if step.get("uses", "").startswith("actions/cache@"):
                assert step["with"]["path"] == "~/.cache/sitegen"


def test_nothing_is_overwritten(repository: Path, capsys: pytest.CaptureFixture[str]) -> None:
    web = repository / "web"
    (web / "site.yaml").write_text("mine")
    file = repository / ".github" / "workflows" / "pages.yml"
    file.parent.mkdir(parents=True)
    file.write_text("mine")
    assert main(["init", "--github", str(web)]) == 1
    assert capsys.readouterr().err == (
        f"{file} already exists; remove or edit it\n1 problem, nothing was written\n"
    )
    assert [path.name for path in file.parent.iterdir()] == ["pages.yml"]
    file.unlink()
    assert main(["init", "--github", str(web)]) == 0
    assert (web / "site.yaml").read_text() == "mine"


def test_a_source_that_is_not_known_is_said(
    repository: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    guess = installed.Requirement("ros-sitegen==9", "unknown where this sitegen came from")
    monkeypatch.setattr(installed, "requirement", lambda: guess)
    assert main(["init", "--github", str(repository / "web")]) == 0
    said = capsys.readouterr().out
    assert "the workflows install ros-sitegen==9\n" in said
    assert "check SITEGEN in both workflows: unknown where this sitegen came from\n" in said
    assert workflow(repository, "pages")["env"]["SITEGEN"] == "ros-sitegen==9"
