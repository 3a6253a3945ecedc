"""What the digest of a package, by which its programs are kept, depends on."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen.cache.digest import digest_of


@pytest.mark.parametrize("name", ["src/log/x.cpp", "include/build/a.hpp", "log/x.cpp", ".config"])
def test_every_source_counts(tmp_path: Path, name: str) -> None:
    package = tmp_path / "package"
    file = package / name
    file.parent.mkdir(parents=True)
    file.write_text("one")
    before = digest_of([package], roots={tmp_path})
    file.write_text("another")
    assert digest_of([package], roots={tmp_path}) != before


@pytest.mark.parametrize("name", ["build/a.o", "dist/index.html", "a/__pycache__/a.pyc"])
def test_what_tools_write_at_the_root_does_not_count(tmp_path: Path, name: str) -> None:
    before = digest_of([tmp_path], roots={tmp_path})
    file = tmp_path / name
    file.parent.mkdir(parents=True)
    file.touch()
    assert digest_of([tmp_path], roots={tmp_path}) == before
