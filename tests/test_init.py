"""A site.yaml for a workspace that is there already."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from sitegen import config
from sitegen.__main__ import main

ROOT = Path(__file__).parent.parent


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Two packages of demos, which both have a talker, and one with interfaces alone."""
    for source in ("demo03/src/cpp_pubsub", "demo05/src/cpp_chatter"):
        shutil.copytree(ROOT / "demos" / source, tmp_path / "src" / Path(source).name)
    shutil.copytree(
        ROOT / "tests/sites/services/src/calc_interfaces", tmp_path / "src/calc_interfaces"
    )
    return tmp_path


def test_a_workspace_becomes_a_site(workspace: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["init", str(workspace)]) == 0
    assert "/cpp_pubsub/  talker, listener" in capsys.readouterr().out
    site = config.load(workspace / "site.yaml")
    assert [page.path for page in site.pages] == ["", "cpp_chatter/", "cpp_pubsub/"]
    pubsub = site.pages[2]
    assert {name: node.executable for name, node in pubsub.nodes.items()} == {
        "cpp_pubsub_talker": "talker",
        "cpp_pubsub_listener": "listener",
    }
    assert site.notes == ()
    text = (workspace / "site.yaml").read_text()
    assert "# The programs that pages run." in text
    assert "# url: https://me.github.io/my-robot/" in text


def test_a_site_that_is_there_stays(workspace: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (workspace / "site.yaml").write_text("mine")
    assert main(["init", str(workspace)]) == 1
    assert "site.yaml exists already; remove it, or edit it" in capsys.readouterr().err
    assert (workspace / "site.yaml").read_text() == "mine"


def test_a_folder_with_nothing_to_run_is_told(
    tmp_path: Path, workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    assert main(["init", str(empty)]) == 1
    assert "no ROS package here or below" in capsys.readouterr().err
    assert main(["init", str(workspace / "src/calc_interfaces")]) == 1
    assert "no package has an executable that could run on a page: calc_interfaces" in (
        capsys.readouterr().err
    )
    assert not (empty / "site.yaml").exists()
