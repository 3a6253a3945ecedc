"""Run the tests, then those that failed once more: `python run.py [--at-once N] [PYTEST OPTIONS]`.

Thousands of tests in real browsers include, now and then, one that fails by accident. A fault of
the product fails again, alone and on an idle machine.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path

import pytest

# More failures than this are no accidents.
MOST = 10
# Below the current folder: the tests that passed only when they were run again.
LIST = Path(".test", "passed-when-run-again.txt")


class Failures:
    """A plugin of pytest that records why each test failed, by the test's node id."""

    def __init__(self) -> None:
        self.reasons: dict[str, str] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            self.reasons.setdefault(report.nodeid, _reason(report))


def _reason(report: pytest.TestReport) -> str:
    """Return the first line of what a test raised, and the phase if that was not the test."""
    crash = getattr(report.longrepr, "reprcrash", None)
    lines = str(crash.message if crash else report.longreprtext).strip().splitlines()
    said = lines[0] if lines else "no reason given"
    return said if report.when == "call" else f"{report.when}: {said}"


def run(at_once: int, options: list[str]) -> int:
    """Return the exit status: 0 if each test has passed, at once or when it was run again."""
    failures = Failures()
    parallel = ["--numprocesses", str(at_once), "--dist", "loadfile", "--durations", "20"]
    status = int(pytest.main([*parallel, *options], plugins=[failures]))
    LIST.parent.mkdir(exist_ok=True)
    LIST.write_text("")
    if status != pytest.ExitCode.TESTS_FAILED or not failures.reasons:
        return status
    if len(failures.reasons) > MOST:
        print(f"\n{len(failures.reasons)} tests failed; only up to {MOST} are run again")
        return status
    return _run_again(failures.reasons, [one for one in options if one.startswith("--")])


def _run_again(reasons: dict[str, str], options: list[str]) -> int:
    """Run each test in a process of its own, one after another."""
    passed, failed = [], []
    for test, reason in reasons.items():
        print(f"\nrunning again, alone: {test}", flush=True)
        # A test that is not found, or skips, has not passed either.
        command = [sys.executable, "-m", "pytest", "-rs", *options, test]
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True)
        print(done.stdout, flush=True)
        if done.returncode == 0 and "1 passed" in done.stdout:
            passed.append(f"RERUN {test}: failed ({reason}), then passed")
        else:
            failed.append(f"FAILED {test}: failed ({reason}), then failed again")
    LIST.write_text("".join(f"{line}\n" for line in passed))
    for title, lines in (("passed only when run again", passed), ("failed twice", failed)):
        if lines:
            print(f"{f' {title} ':=^80}", *lines, sep="\n", flush=True)
    return 1 if failed else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False)
    parser.add_argument("--at-once", type=int, default=2, help="how many tests run at once")
    given, options = parser.parse_known_args()
    return run(given.at_once, options)


if __name__ == "__main__":
    sys.exit(main())
