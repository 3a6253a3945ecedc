"""The runner of the suite: what failed is run once more, and what fails twice fails the run."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from paths import ROOT

ONCE = """
from pathlib import Path


def test_that_fails_once():
    done = Path("done")
    before = done.exists()
    done.touch()
    assert before, "not yet"


def test_that_passes():
    pass
"""
TWICE = """
def test_that_fails_always():
    raise ValueError("never")
"""
SKIPS = """
from pathlib import Path

import pytest


def test_that_skips_then():
    done = Path("skip")
    if done.exists():
        pytest.skip("gone")
    done.touch()
    raise ValueError("at first")
"""


def run(folder: Path, tests: str) -> tuple[int, str, str]:
    """Run tests; return the exit status, what was printed, and the list of what passed later."""
    (folder / "test_some.py").write_text(tests)
    (folder / "pytest.ini").write_text("[pytest]\naddopts = -q\n")
    command = [sys.executable, str(ROOT / "tests/support/run.py"), "--at-once", "1"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    return done.returncode, done.stdout, (folder / ".test/passed-when-run-again.txt").read_text()


def test_what_fails_once_passes_and_is_named(tmp_path: Path) -> None:
    status, printed, listed = run(tmp_path, ONCE)
    line = (
        "RERUN test_some.py::test_that_fails_once: failed (AssertionError: not yet), then passed\n"
    )
    assert status == 0
    assert listed == line
    assert "= passed only when run again =====" in printed
    assert line in printed
    stages = printed[printed.index("= stages =") :]
    assert [row.split(" s  ")[1] for row in stages.splitlines()[1:]] == [
        "tests",
        "tests that were run again",
    ]
    assert (tmp_path / ".test/seconds.txt").read_text().split()[1] == "test_some.py"


@pytest.mark.parametrize(
    ("tests", "reason"),
    [
        (TWICE, "test_that_fails_always: failed (ValueError: never)"),
        (SKIPS, "test_that_skips_then: failed (ValueError: at first)"),
    ],
)
def test_what_does_not_pass_then_fails(tmp_path: Path, tests: str, reason: str) -> None:
    status, printed, listed = run(tmp_path, ONCE + tests)
    assert status == 1
    assert f"FAILED test_some.py::{reason}, then failed again" in printed
    assert "test_that_fails_once" in listed


def test_many_failures_are_no_accidents(tmp_path: Path) -> None:
    tests = "".join(f"def test_{number}(): assert False\n" for number in range(11))
    status, printed, listed = run(tmp_path, tests)
    assert status == 1
    assert "11 tests failed; only up to 10 are run again" in printed
    assert "running again" not in printed
    assert listed == ""


def test_errors_of_the_tests_themselves_are_not_run_again(tmp_path: Path) -> None:
    status, printed, _ = run(tmp_path, "import missing_module_of_tests\n")
    assert status not in (0, 5)
    assert "running again" not in printed
