"""Convert TeX to MathML in a separate process: the library may hang or crash on invalid TeX."""

from __future__ import annotations

import contextlib
import functools
import json
import os
import subprocess
import sys
import threading
from pathlib import Path

PROGRAM = Path(__file__).with_name("texprogram.py")
# The longest time (s) for one formula; most take less than a millisecond.
LIMIT = 3.0


class TexError(ValueError):
    """The formula is not valid TeX; the message says why, and where if that is known."""


def mathml(tex: str, *, block: bool) -> str:
    """Return a formula as MathML.

    Raises: TexError if the formula is invalid or too complex.
    """
    return _converter(os.getpid()).convert(tex, block)


# One for each process that renders pages: after a fork, two of them would share its pipes.
@functools.cache
def _converter(_pid: int) -> _Converter:
    return _Converter()


class _Converter:
    def __init__(self) -> None:
        # `sitegen serve` renders pages and the search index in different threads.
        self._lock = threading.Lock()
        self._process: subprocess.Popen[str] | None = None

    def convert(self, tex: str, block: bool) -> str:
        with self._lock:
            line = self._answer(json.dumps([tex, block]))
        if not line:
            raise TexError("too complex, or a brace or a parenthesis is not closed")
        found: str
        fault: str
        found, fault = json.loads(line)
        if fault:
            raise TexError(fault)
        return found

    def _answer(self, question: str) -> str:
        """Return the line that answers a line; nothing if the process hung or crashed."""
        process = self._process = self._process or _started()
        assert process.stdin and process.stdout
        late = threading.Timer(LIMIT, process.kill)
        late.start()
        try:
            with contextlib.suppress(BrokenPipeError):
                print(question, file=process.stdin, flush=True)
            line = process.stdout.readline()
        finally:
            late.cancel()
        if not line:
            self._process = None
            process.kill()
            process.communicate()
        return line


def _started() -> subprocess.Popen[str]:
    # It ends with this process, which closes its input.
    return subprocess.Popen(
        [sys.executable, "-I", str(PROGRAM)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        encoding="utf-8",
    )
