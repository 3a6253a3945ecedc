"""How long something took is remembered, and whatever is wrong with that memory costs nothing."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest

from sitegen.cache.durations import Durations
from sitegen.cache.folder import forget_old


def test_a_step_is_remembered_until_it_runs_again(tmp_path: Path) -> None:
    talker = Durations(tmp_path, "src/talker jspi")
    assert talker.recall("talker") is None
    talker.note("talker", 14.04)
    assert talker.recall("talker") == 14.0
    talker.note("talker", 3)
    assert talker.recall("talker") == 3.0
    assert Durations(tmp_path, "src/talker asyncify").recall("talker") is None


@pytest.mark.parametrize("damaged", [b"", b"soon", b"nan", b"-3", b"inf", b"\xff"])
def test_a_damaged_duration_is_unknown(tmp_path: Path, damaged: bytes) -> None:
    durations = Durations(tmp_path, "src/talker jspi")
    durations.note("talker", 14)
    [file] = (tmp_path / "durations").iterdir()
    file.write_bytes(damaged)
    assert durations.recall("talker") is None


def test_a_cache_that_cannot_be_written_is_no_error(tmp_path: Path) -> None:
    (tmp_path / "durations").write_text("a file where the folder should be")
    durations = Durations(tmp_path, "src/talker jspi")
    durations.note("talker", 14)
    assert durations.recall("talker") is None


def test_old_durations_are_forgotten(tmp_path: Path) -> None:
    durations = Durations(tmp_path, "src/talker jspi")
    durations.note("talker", 14)
    durations.note("listener", 14)
    long_ago = time.time() - 61 * 24 * 3600
    old = min((tmp_path / "durations").iterdir())
    os.utime(old, (long_ago, long_ago))
    forget_old(tmp_path)
    assert not old.exists()
    assert len(list((tmp_path / "durations").iterdir())) == 1
