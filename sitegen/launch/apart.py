"""Run the programs that read launch files for us, which change the interpreter that they run in."""

from __future__ import annotations

import io
import runpy
import subprocess
import sys
from collections.abc import Sequence
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import NamedTuple

# The modules of the programs, which have a state: each run gets its own.
PACKAGE, DESCRIBING = "sitegen.launch", "describe"


class Output(NamedTuple):
    """What a program has written, and its exit code."""

    stdout: str
    stderr: str
    code: int


def run(program: Path, words: Sequence[str], given: str, limit: float) -> Output:
    """Run a Python program with the standard input `given`, for `limit` seconds at most.

    It has a process of its own, except in a page, which has none: there, what it has changed in
    the interpreter is undone, and there is no limit.

    Raises: TimeoutError if it takes longer.
    """
    if sys.platform == "emscripten":
        return _run_here(program, words, given)
    command = [sys.executable, "-I", "-B", str(program), *words]
    try:
        done = subprocess.run(command, input=given, text=True, capture_output=True, timeout=limit)
    except subprocess.TimeoutExpired:
        raise TimeoutError from None
    return Output(done.stdout, done.stderr, done.returncode)


def _run_here(program: Path, words: Sequence[str], given: str) -> Output:
    modules, paths, finders = dict(sys.modules), [*sys.path], [*sys.meta_path]
    line, source = sys.argv, sys.stdin
    out, err, code = io.StringIO(), io.StringIO(), 0
    package = vars(sys.modules[PACKAGE])
    members = dict(package)
    for name in [name for name in modules if name.startswith(f"{PACKAGE}.{DESCRIBING}")]:
        del sys.modules[name]
        package.pop(name.removeprefix(f"{PACKAGE}."), None)
    sys.argv, sys.stdin = [str(program), *words], io.StringIO(given)
    try:
        with redirect_stdout(out), redirect_stderr(err):
            runpy.run_path(str(program), run_name="__main__")
    except SystemExit as ended:
        code = ended.code if isinstance(ended.code, int) else int(ended.code is not None)
    finally:
        sys.argv, sys.stdin = line, source
        sys.path[:], sys.meta_path[:] = paths, finders
        for changed, kept in ((sys.modules, modules), (package, members)):
            changed.clear()
            changed.update(kept)
    return Output(out.getvalue(), err.getvalue(), code)
