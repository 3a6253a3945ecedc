"""The workspace of tests that write their own launch files."""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import PACKAGE


@pytest.fixture
def root(tmp_path: Path) -> Path:
    package = tmp_path / "src" / "mine"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(PACKAGE.format("mine"))
    return tmp_path
