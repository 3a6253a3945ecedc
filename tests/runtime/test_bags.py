"""Damaged bags, read as the page does, but in Node: thousands of them in seconds."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from bags import drive, write_bag
from mcap.writer import CompressionType
from paths import ROOT

# In every run, and with --all.
SHORT, LONG = 400, 10_000


@pytest.mark.parametrize("how", ["cut", "chunk", "any"])
@pytest.mark.parametrize("compression", [CompressionType.ZSTD, CompressionType.LZ4])
def test_what_is_whole_of_a_damaged_bag_is_read(
    tmp_path: Path, pytestconfig: pytest.Config, how: str, compression: CompressionType
) -> None:
    bag = write_bag(tmp_path / "drive.mcap", drive(), compression, chunk_size=1024)
    count = LONG if pytestconfig.getoption("all") else SHORT
    script = str(ROOT / "tests/support/mutatedbags.mjs")
    command = ["node", script, str(bag), how, "1", str(count)]
    done = subprocess.run(command, text=True, capture_output=True, check=False)
    assert done.stderr == ""
    *wrong, last = done.stdout.splitlines()
    assert wrong == []
    assert last.startswith(f"{count} read, of 151 messages in ")
