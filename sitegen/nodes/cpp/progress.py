"""Show on a terminal what a run of Ninja is doing."""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import PurePosixPath

from sitegen.cache.durations import Durations
from sitegen.model import Package
from sitegen.nodes.cpp.cmake import PROGRAMS, CMake
from sitegen.report import Report

STEP = re.compile(r"^\[\d+/\d+\] (Building \w+ object|Linking \w+ executable) (\S+)$", re.MULTILINE)
COUNT = re.compile(r"^\[(\d+)/(\d+)\] ", re.MULTILINE)
TARGET = re.compile(r"CMakeFiles/([^/]+)\.dir/")


class Progress:
    """The lines of the programs that one run of Ninja makes, until they are linked.

    `names` are the names of the lines by executable; `planned` is the output of a dry run.
    """

    def __init__(
        self, report: Report, names: Mapping[str, str], planned: str, durations: Durations
    ) -> None:
        self._report = report
        self._names = names
        self._durations = durations
        self._last = {executable: durations.recall(executable) for executable in names}
        self._planned = STEP.findall(planned)
        self._begun = time.monotonic()
        self._took: dict[str, float] = {}
        self.watch("")

    def watch(self, output: str) -> None:
        """Update the lines; `output` is what Ninja has printed so far."""
        finished = {file for _, file in STEP.findall(output)}
        left = [step for step in self._planned if step[1] not in finished]
        seconds = time.monotonic() - self._begun
        for executable, name in self._names.items():
            if executable in self._took:
                continue
            if f"{PROGRAMS}/{executable}.js" in finished:
                self._took[executable] = seconds
                self._report.done(name)
                continue
            step = _step([file for kind, file in left if self._needs(executable, kind, file)])
            last = self._last[executable]
            before = f" ({last:.0f} s last time)" if last else ""
            self._report.showing(name, f"{step}{elapsed(seconds)}{before}")

    def note(self, executable: str) -> None:
        """Record how long a program took that is linked."""
        seconds = self._took.setdefault(executable, time.monotonic() - self._begun)
        self._durations.note(executable, seconds)

    def _needs(self, executable: str, kind: str, file: str) -> bool:
        """Return whether a program may need an object: its own, or one of a library."""
        target = TARGET.search(file)
        is_other = target and target[1] != executable and target[1] in self._names
        return kind.startswith("Building") and not is_other


def plan(cmake: CMake, package: Package, executables: Iterable[str]) -> str:
    """Return what Ninja would print if it made programs of a configured package."""
    targets = (f"{PROGRAMS}/{name}.js" for name in executables)
    return cmake.tools.run(cmake.tools.ninja, "-C", cmake.tree(package), "-n", *targets).stdout


def counted(report: Report, name: str, what: str) -> Callable[[str], None]:
    """Return a function that updates a line with the number of steps that Ninja has finished."""
    begun = time.monotonic()

    def watch(output: str) -> None:
        steps = COUNT.findall(output)
        done = ", step {} of {}".format(*steps[-1]) if steps else ""
        report.showing(name, f"{what}{done}{elapsed(time.monotonic() - begun)}")

    return watch


def elapsed(seconds: float) -> str:
    """Return what a line says about its age; nothing in the first second."""
    return f", {seconds:.0f} s" if seconds >= 1 else ""


def _step(objects: list[str]) -> str:
    """Return the current step of a program, given the objects that it waits for."""
    if not objects:
        return "linking"
    source = PurePosixPath(objects[0]).stem
    return f"compiling {source if len(objects) == 1 else f'{len(objects)} files'}"
