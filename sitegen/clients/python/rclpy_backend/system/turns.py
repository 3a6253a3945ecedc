"""Whose turn it is: the programs that share an interpreter, and what each sees of it.

A program has modules of its own: rclpy, what stands below it, and those of its workspace. They are
in sys.modules while it runs. Everything else is there once for all: Python's own modules, message
classes, what came from elsewhere, and what is named here.
"""

from __future__ import annotations

import copy
import io
import itertools
import re
import sys
import threading
from collections.abc import Callable, Iterable
from types import ModuleType
from typing import Any, Protocol

OWN = ("__main__", "ros_host", "rclpy", "rclpy_backend")
# All that is in these packages has one state for all programs.
SHARED = re.compile(r"rclpy_backend\.(system|arrays)(\..*)?")

PATH = list(sys.path)

_idents = itertools.count()


class Signals(Protocol):
    """What a program does when a signal comes."""

    def arrive(self, number: int) -> None:
        """Take it."""

    def handle(self, *, main: bool) -> None:
        """Call its handler, from the thread of the program."""


class Output(io.RawIOBase):
    """A stream of bytes that becomes lines of a console."""

    def __init__(self, host: Any, name: str) -> None:
        self._host = host
        self._name = name
        self._rest = b""

    def writable(self) -> bool:
        """Return that it can be written to."""
        return True

    def fileno(self) -> int:
        """Return what the system would write to."""
        return ("stdout", "stderr").index(self._name) + 1

    def write(self, data: Any) -> int:
        """Print the lines that are complete."""
        *lines, self._rest = (self._rest + bytes(data)).split(b"\n")
        for line in lines:
            self._host.print(self._name, line.decode(errors="replace"))
        return len(data)

    def end(self) -> None:
        """Print what has no end of line."""
        if self._rest:
            self.write(b"\n")


class Program:
    """A program with its threads; `host` is the page's side of it, `own` names its packages."""

    def __init__(self, host: Any, own: Iterable[str]) -> None:
        self.host = host
        # Whether its threads are stacks that the browser sets aside. Otherwise there is one.
        self.stacks = bool(host.stacks)
        self.ident = next(_idents)
        self.threads = {self.ident}
        self.waiting = 0
        self.over = False
        self.signals: Signals | None = None
        self.keyboard: Any = None
        # What is called when it ends, each with its arguments.
        self.exits: list[tuple[Callable[..., Any], tuple[Any, ...], dict[str, Any]]] = []
        self._own = {*OWN, *own}
        self._modules: dict[str, ModuleType] = {
            "__main__": ModuleType("__main__"),
            "ros_host": host,
        }
        self.outputs = [Output(host, name) for name in ("stdout", "stderr")]
        streams = [io.TextIOWrapper(io.BufferedWriter(out), "utf-8") for out in self.outputs]
        for stream in streams:
            stream.reconfigure(line_buffering=True)
        main = copy.copy(threading.main_thread())
        main._ident = self.ident  # type: ignore[attr-defined]
        threading._active[self.ident] = main  # type: ignore[attr-defined]
        # What it finds in `sys` and elsewhere.
        self._state: dict[tuple[ModuleType, str], Any] = {
            (sys, "argv"): [],
            (sys, "path"): list(PATH),
            (sys, "stdin"): sys.stdin,
            (sys, "stdout"): streams[0],
            (sys, "stderr"): streams[1],
            (threading, "_main_thread"): main,
        }

    def enter(self) -> None:
        """Let it see what is its own."""
        sys.modules.update(self._modules)
        for (module, name), value in self._state.items():
            setattr(module, name, value)

    def leave(self) -> None:
        """Take out of sight what is its own."""
        for module, name in self._state:
            self._state[module, name] = getattr(module, name)
        names = [name for name in sys.modules if self._is_own(name)]
        self._modules = {name: sys.modules.pop(name) for name in names}

    def _is_own(self, name: str) -> bool:
        return name.partition(".")[0] in self._own and not SHARED.fullmatch(name)

    def end(self) -> None:
        """Let none of its threads go on."""
        self.over = True
        # The others take themselves out of the list, when they end.
        threading._active.pop(self.ident, None)  # type: ignore[attr-defined]
        self.host.wake()


_running: Program | None = None
_thread = 0


def running() -> Program:
    """Return the program that runs."""
    assert _running
    return _running


def current() -> tuple[Program | None, int]:
    """Return who runs: the program, if one does, and the number of its thread."""
    return _running, _thread


def current_thread() -> int:
    """Return the number of the thread that runs."""
    return _thread


def enter(program: Program | None, thread: int = 0) -> None:
    """Say who runs from now on."""
    global _running, _thread
    _thread = thread
    if program is _running:
        return
    if _running:
        _running.leave()
    _running = program
    if program:
        program.enter()


def new_thread() -> int:
    """Return a number for a thread of the program that runs."""
    ident = next(_idents)
    running().threads.add(ident)
    return ident
