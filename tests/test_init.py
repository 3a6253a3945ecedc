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


def test_what_else_is_there_is_listed(workspace: Path) -> None:
    package = "<package><name>bringup</name></package>"
    files = {
        "src/bringup/package.xml": package,
        "src/bringup/launch/all.launch.py": "",
        "src/bringup/launch/sim/all.launch.xml": "",
        "src/bringup/launch/notes.txt": "",
        "src/cpp_pubsub/launch/both.launch.yaml": "",
        "src/bringup/urdf/fox.urdf.xacro": "",
        "src/bringup/urdf/fox.urdf": "",
    }
    for name, text in files.items():
        file = workspace / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    assert main(["init", str(workspace)]) == 0
    text = (workspace / "site.yaml").read_text()
    comments = text[text.index("# Launch files of the workspace.") :].split("\n\n")
    assert [comment.splitlines()[-1] for comment in comments] == [
        "#   cpp_pubsub: launch/both.launch.yaml",
        "#   bringup: urdf/fox.urdf, urdf/fox.urdf.xacro",
        "#   calc_interfaces: srv/Divide.srv",
    ]
    assert "#   bringup: launch/all.launch.py, launch/sim/all.launch.xml\n" in text
    assert config.load(workspace / "site.yaml").notes == ()
