"""Switch between the programs that share an interpreter.

Each program has its own copies of some modules: rclpy, the layer below it, and those of its
workspace. They are in sys.modules while it runs. All other modules are shared: the standard
library, message classes, wheels, and the packages named in SHARED.
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
# Modules of this layer with one state for all programs.
SHARED = re.compile(r"rclpy_backend\.(system|arrays)(\..*)?")

PATH = list(sys.path)

_idents = itertools.count()


class Signals(Protocol):
    """How a program handles signals."""

    def arrive(self, number: int) -> None:
        """Receive a signal."""

    def handle(self, *, main: bool) -> None:
        """Call the handler of the signal received, in the thread of the program."""


class Output(io.RawIOBase):
    """A stream of bytes that is printed to a console line by line."""

    def __init__(self, host: Any, name: str) -> None:
        self._host = host
        self._name = name
        self._rest = b""

    def writable(self) -> bool:
        """Return True."""
        return True

    def fileno(self) -> int:
        """Return the file descriptor: 1 or 2."""
        return ("stdout", "stderr").index(self._name) + 1

    def write(self, data: Any) -> int:
        """Print the complete lines."""
        *lines, self._rest = (self._rest + bytes(data)).split(b"\n")
        for line in lines:
            self._host.print(self._name, line.decode(errors="replace"))
        return len(data)

    def end(self) -> None:
        """Print the last line, which has no end of line."""
        if self._rest:
            self.write(b"\n")


class Program:
    """A program with its threads; `host` is its worker's host object, `own` names its packages."""

    def __init__(self, host: Any, own: Iterable[str]) -> None:
        self.host = host
        # Whether its threads are stacks that the browser suspends. Otherwise it has one thread.
        self.stacks = bool(host.stacks)
        self.ident = next(_idents)
        self.threads = {self.ident}
        self.signals_received = 0
        self.over = False
        self.signals: Signals | None = None
        self.keyboard: Any = None
        # Exit handlers, each with its arguments.
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
        # Its values of attributes of shared modules.
        self._state: dict[tuple[ModuleType, str], Any] = {
            (sys, "argv"): [],
            (sys, "path"): list(PATH),
            (sys, "stdin"): sys.stdin,
            (sys, "stdout"): streams[0],
            (sys, "stderr"): streams[1],
            (threading, "_main_thread"): main,
        }

    def enter(self) -> None:
        """Install the program's own modules and attributes."""
        sys.modules.update(self._modules)
        for (module, name), value in self._state.items():
            setattr(module, name, value)

    def leave(self) -> None:
        """Save and remove the program's own modules and attributes."""
        for module, name in self._state:
            self._state[module, name] = getattr(module, name)
        names = [name for name in sys.modules if self._is_own(name)]
        self._modules = {name: sys.modules.pop(name) for name in names}

    def _is_own(self, name: str) -> bool:
        return name.partition(".")[0] in self._own and not SHARED.fullmatch(name)

    def end(self) -> None:
        """End the program: none of its threads resumes."""
        self.over = True
        # The other threads remove themselves when they end.
        threading._active.pop(self.ident, None)  # type: ignore[attr-defined]
        self.host.wake()


_running: Program | None = None
_thread = 0


def running() -> Program:
    """Return the running program."""
    assert _running
    return _running


def current() -> tuple[Program | None, int]:
    """Return the running program, if any, and the number of its thread."""
    return _running, _thread


def current_thread() -> int:
    """Return the number of the running thread."""
    return _thread


def enter(program: Program | None, thread: int = 0) -> None:
    """Switch to a program and its thread."""
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
    """Return a number for a new thread of the running program."""
    ident = next(_idents)
    running().threads.add(ident)
    return ident
