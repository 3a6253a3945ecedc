"""The sdist and the wheel of the working tree, made as the release workflow makes them."""

from __future__ import annotations

import os
import subprocess
import sys
import venv
from pathlib import Path

from filelock import FileLock
from paths import ROOT
from workflow import Runner, Step, system, workflow

from sitegen import __version__

RELEASE = ROOT / ".github" / "workflows" / "release.yml"
# What shows where this run's own Python and sitegen are.
OWN = ("PYTHON", "VIRTUAL_ENV", "SITEGEN_CACHE", "XDG_CACHE_HOME", "GIT_", "NODE_PATH")


def environment(home: Path, **more: str) -> dict[str, str]:
    """Return the environment of a computer on which sitegen never was."""
    own = {name: value for name, value in os.environ.items() if not name.startswith(OWN)}
    cache = subprocess.check_output([sys.executable, "-m", "pip", "cache", "dir"], text=True)
    # Downloads may come from this computer's cache: they are the same.
    shared = {"PIP_CACHE_DIR": cache.strip(), "npm_config_cache": str(Path.home() / ".npm")}
    return {
        **own,
        **shared,
        "HOME": str(home),
        **more,
    }


def commit(tree: Path) -> None:
    """Make a repository of a folder, with one commit of all of it."""
    who = ("-c", "user.name=A", "-c", "user.email=a@example.org")
    for words in (("init", "-q", "-b", "main"), ("add", "-A"), (*who, "commit", "-qm", "Begin")):
        subprocess.run(["git", *words], cwd=tree, check=True)


def distribution(folder: Path) -> Path:
    """Return the folder with the sdist and the wheel; they are made in `folder`, once per run."""
    with FileLock(folder.with_suffix(".lock")):
        if not (folder / "complete").exists():
            _release(folder)
            (folder / "complete").touch()
    return folder / "tree" / "dist"


def _release(folder: Path) -> None:
    tree = folder / "tree"
    tree.mkdir(parents=True)
    listed = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    names = subprocess.check_output(listed, cwd=ROOT, text=True).split("\0")
    for name in filter(None, names):
        if (ROOT / name).is_file():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            (tree / name).write_bytes((ROOT / name).read_bytes())
            (tree / name).chmod((ROOT / name).stat().st_mode)
    commit(tree)

    def set_up_python(step: Step) -> None:
        venv.create(folder / "venv", with_pip=True)

    (folder / "home").mkdir()
    runner = Runner(
        tree,
        [folder / "venv" / "bin", system(folder / "bin", without=("python3", "pip", "pip3"))],
        environment(folder / "home", GITHUB_REF_NAME=f"v{__version__}"),
        {"setup-python": set_up_python},
    )
    assert runner.run(workflow(RELEASE), "build") == [
        "Check that the tag is the version",
        "Install the build tool",
        "Build twice and compare",
    ]
