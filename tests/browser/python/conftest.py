"""What several tests of Python in pages share."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from browser import Built
from paths import ROOT


@pytest.fixture(scope="session")
def lab(built: Built, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The built site of sites/lab, with the package of a demo."""
    folder = tmp_path_factory.mktemp("lab") / "site"
    shutil.copytree(ROOT / "tests/sites/lab", folder)
    shutil.copytree(ROOT / "demos/demo03/src", folder / "src")
    return built(folder)
