"""What the live lines of a build say while Ninja runs."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import pytest

from sitegen.cache.durations import Durations
from sitegen.nodes.cpp import progress
from sitegen.nodes.cpp.progress import Progress, counted
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.report import Report

NAMES = {"talker": "pubsub/talker", "listener": "pubsub/listener"}
TALKER, LISTENER = (f"CMakeFiles/{name}.dir/src/{name}.cpp.o" for name in NAMES)
LIBRARY = [f"sub/CMakeFiles/parts.dir/{name}.cpp.o" for name in ("one", "two")]


class Terminal(io.StringIO):
    """A terminal that knows what is written on it after the last change."""

    def isatty(self) -> bool:
        return True

    def lines(self) -> list[str]:
        return self.getvalue().rpartition("\x1b[J")[2].splitlines()


class Clock:
    """A clock that a test sets."""

    def __init__(self) -> None:
        self.now = 100.0

    def monotonic(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    monkeypatch.setenv("TERM", "xterm")
    clock = Clock()
    monkeypatch.setattr(progress, "time", clock)
    return clock


def printed(*steps: str, of: int = 5) -> str:
    """What Ninja prints when it has finished these steps."""
    lines = (f"[{number}/{of}] {step}\n" for number, step in enumerate(steps, 1))
    return "ninja: Entering directory `/cache'\n" + "".join(lines)


def built(file: str) -> str:
    return f"Building CXX object {file}"


def linked(name: str) -> str:
    return f"Linking CXX executable bin/{name}.js"


def test_a_line_says_what_its_program_waits_for(tmp_path: Path, clock: Clock) -> None:
    screen = Terminal()
    durations = Durations(tmp_path, "pubsub jspi")
    durations.note("talker", 14.4)
    steps = [built(TALKER), built(LISTENER), *map(built, LIBRARY)]
    planned = printed(*steps, linked("talker"), linked("listener"), of=6)
    making = Progress(Report(screen), NAMES, planned, durations)
    assert screen.lines() == [
        "  pubsub/talker: compiling 3 files (14 s last time)",
        "  pubsub/listener: compiling 3 files",
    ]
    clock.now += 7
    making.watch(printed(*steps[2:], of=6))
    assert screen.lines() == [
        "  pubsub/talker: compiling talker.cpp, 7 s (14 s last time)",
        "  pubsub/listener: compiling listener.cpp, 7 s",
    ]
    clock.now += 2
    making.watch(printed(*steps[2:], steps[0], of=6))
    assert screen.lines()[0] == "  pubsub/talker: linking, 9 s (14 s last time)"
    clock.now += 3
    making.watch(printed(*steps[2:], steps[0], linked("talker"), of=6))
    assert screen.lines() == ["  pubsub/listener: compiling listener.cpp, 12 s"]
    clock.now += 8
    making.note("talker")
    making.note("listener")
    assert [durations.recall(name) for name in NAMES] == [12, 20]


def test_what_is_compiled_already_is_only_linked(tmp_path: Path, clock: Clock) -> None:
    screen = Terminal()
    planned = printed(linked("talker"), of=1)
    Progress(Report(screen), {"talker": "pubsub/talker"}, planned, Durations(tmp_path, ""))
    assert screen.lines() == ["  pubsub/talker: linking"]


def test_libraries_count_their_steps(clock: Clock) -> None:
    screen = Terminal()
    watch = counted(Report(screen), "rclcpp", "compiling the library")
    watch("-- Configuring done\n")
    assert screen.lines() == ["  rclcpp: compiling the library"]
    clock.now += 61
    watch("-- Configuring done\n" + printed(built("a.cpp.o"), built("b.cpp.o")))
    assert screen.lines() == ["  rclcpp: compiling the library, step 2 of 5, 61 s"]


def test_a_pipe_gets_one_line_for_each_step(tmp_path: Path, clock: Clock) -> None:
    said = io.StringIO()
    report = Report(said)
    report.doing("pubsub/talker", "compiling")
    making = Progress(report, NAMES, printed(built(TALKER)), Durations(tmp_path, ""))
    clock.now += 5
    making.watch(printed(built(TALKER)))
    counted(report, "rclcpp", "compiling")("")
    assert said.getvalue() == "pubsub/talker: compiling\n"


def test_a_tool_is_watched_while_it_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sitegen.nodes.cpp.toolchain.TICK", 0.1)
    seen: list[str] = []
    nothing = Path("unused")
    tools = Toolchain(nothing, nothing, nothing, "", watch=seen.append)
    script = "import time\nprint('é', flush=True)\ntime.sleep(1)\nprint('end')"
    done = tools.run(sys.executable, "-X", "utf8", "-c", script)
    assert (done.returncode, done.stdout) == (0, "é\nend\n")
    assert "é\n" in seen
