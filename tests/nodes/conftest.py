"""What the tests of compiled nodes share."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from configuring import Configuring, cmake_for_tests
from packages import Workspace

from sitegen.cache.folder import cache_folder
from sitegen.nodes.cpp.locks import locked
from sitegen.report import Report


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A cache that these tests share, with nothing but the library if that is compiled already."""
    folder = tmp_path_factory.mktemp("cache")
    own = cache_folder()
    for library in own.glob("work/*/jspi/rclcpp/librclcpp.a"):
        there = folder / library.relative_to(own)
        there.parent.mkdir(parents=True)
        with locked([library.parent], Report()):  # another process may be writing it
            shutil.copyfile(library, there)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SITEGEN_CACHE", str(folder))
        yield folder


@pytest.fixture
def workspace(tmp_path: Path, cache: Path) -> Workspace:
    return Workspace(tmp_path, cache)


@pytest.fixture(scope="module")
def configured(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("configured")


@pytest.fixture
def packages(tmp_path: Path, configured: Path) -> Configuring:
    return Configuring(cmake_for_tests(configured), tmp_path)
