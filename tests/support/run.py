"""Run the tests, then those that failed once more, alone.

    python run.py [--at-once N] [--compile] [--begun TIME] [OPTIONS OF PYTEST]

Thousands of tests in real browsers include, now and then, one that fails by accident. A fault of
the product fails again, alone and on an idle machine.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import pytest

# More failures than this are no accidents.
MOST = 10
# Below the current folder, what a run leaves: the tests that passed only when they were run again,
# and the seconds that the tests of each file took.
FOLDER = Path(".test")
AGAIN = FOLDER / "passed-when-run-again.txt"
TIMES = FOLDER / "seconds.txt"


class Outcomes:
    """A plugin of pytest that records why tests failed, and how long the tests of files took."""

    def __init__(self) -> None:
        self.reasons: dict[str, str] = {}
        self.milliseconds: Counter[str] = Counter()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.milliseconds[report.nodeid.partition("::")[0]] += round(report.duration * 1000)
        if report.failed:
            self.reasons.setdefault(report.nodeid, _reason(report))


def _reason(report: pytest.TestReport) -> str:
    """Return the first line of what a test raised, and the phase if that was not the test."""
    crash = getattr(report.longrepr, "reprcrash", None)
    lines = str(crash.message if crash else report.longreprtext).strip().splitlines()
    said = lines[0] if lines else "no reason given"
    return said if report.when == "call" else f"{report.when}: {said}"


class Stages:
    """The times that the stages of a run take."""

    def __init__(self, begun: float) -> None:
        self._last = begun
        self._lines: list[str] = []

    def end(self, name: str) -> None:
        now = time.time()
        self._lines.append(f"{now - self._last:6.0f} s  {name}")
        self._last = now

    def print(self) -> None:
        print(f"{' stages ':=^80}", *self._lines, sep="\n", flush=True)


def run(at_once: int, options: list[str], stages: Stages) -> int:
    """Return the exit status: 0 if each test has passed, at once or when it was run again."""
    outcomes = Outcomes()
    parallel = ["--numprocesses", str(at_once), "--dist", "loadfile", "--durations", "20"]
    status = int(pytest.main([*parallel, *options], plugins=[outcomes]))
    stages.end("tests")
    FOLDER.mkdir(exist_ok=True)
    AGAIN.write_text("")
    slowest = outcomes.milliseconds.most_common()
    TIMES.write_text("".join(f"{taken / 1000:8.1f}  {file}\n" for file, taken in slowest))
    if status != pytest.ExitCode.TESTS_FAILED or not outcomes.reasons:
        return status
    if len(outcomes.reasons) > MOST:
        print(f"\n{len(outcomes.reasons)} tests failed; only up to {MOST} are run again")
        return status
    status = _run_again(outcomes.reasons, [one for one in options if one.startswith("--")])
    stages.end("tests that were run again")
    return status


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
    AGAIN.write_text("".join(f"{line}\n" for line in passed))
    for title, lines in (("passed only when run again", passed), ("failed twice", failed)):
        if lines:
            print(f"{f' {title} ':=^80}", *lines, sep="\n", flush=True)
    return 1 if failed else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False)
    parser.add_argument("--at-once", type=int, default=2, help="how many tests run at once")
    parser.add_argument("--compile", action="store_true", help="compile all programs beforehand")
    parser.add_argument("--begun", type=float, help="when the set-up began, in seconds since 1970")
    given, options = parser.parse_known_args()
    stages = Stages(given.begun or time.time())
    if given.begun:
        stages.end("set-up and linters")
    status = 0
    if given.compile:
        programs = [sys.executable, str(Path(__file__).with_name("programs.py"))]
        everything = [one for one in options if one == "--all"]
        status = subprocess.run([*programs, *everything]).returncode
        stages.end("compiling programs")
    status = status or run(given.at_once, options, stages)
    stages.print()
    return status


if __name__ == "__main__":
    sys.exit(main())
