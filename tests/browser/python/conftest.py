"""What several tests of Python in pages share."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from bags import STRING, write_bag
from browser import Built
from mcap.writer import CompressionType
from paths import ROOT


@pytest.fixture(scope="session")
def lab(built: Built, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The built site of sites/lab, with the package of a demo."""
    folder = tmp_path_factory.mktemp("lab") / "site"
    shutil.copytree(ROOT / "tests/sites/lab", folder)
    shutil.copytree(ROOT / "demos/demo03/src", folder / "src")
    sent = [("/words", STRING, {"data": f"word {number}"}, 50.0 * number) for number in range(9)]
    write_bag(folder / "notebooks/words.mcap", sent, CompressionType.NONE)
    return built(folder)


BESIDE = """\
site: {title: Lab}
pages:
  - {path: demo05/, file: page.md}
  - {path: lab/, title: Lab, jupyter: {notebooks: notebooks/, page: demo05, open: call.ipynb}}
"""


@pytest.fixture(scope="session")
def beside(built: Built, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A built site with JupyterLab beside the page of demo05."""
    folder = tmp_path_factory.mktemp("beside") / "site"
    shutil.copytree(ROOT / "demos/demo05", folder)
    (folder / "notebooks").mkdir()
    shutil.copy(ROOT / "tests/sites/notebooks/call.ipynb", folder / "notebooks")
    (folder / "site.yaml").write_text(BESIDE)
    return built(folder)
