"""Run programs in this interpreter, several at a time if needed."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Sequence
from typing import Any

from rclpy_backend.system import (
    collecting,
    exits,
    frames,
    interrupts,
    keyboard,
    loops,
    outside,
    threads,
    turns,
)

_begun = False


def run(
    host: Any,
    own: Sequence[str],
    module: str,
    attribute: str,
    words: Sequence[str],
    environment: dict[str, str],
) -> int:
    """Run a program to its end and return its exit code; see Program and program.run().

    The caller calls collecting.begin() first, from an existing stack.
    """
    global _begun
    if not _begun:
        _begun = True
        threads.install(stacks=host.stacks)
        loops.install()
        interrupts.install()
        keyboard.install()
        exits.install()
        outside.install()
        frames.install()
        # Each program imports its own copy of these.
        for name in [n for n in sys.modules if n.partition(".")[0] == "rclpy_backend"]:
            if not turns.SHARED.fullmatch(name):
                del sys.modules[name]
    importlib.invalidate_caches()
    program = turns.Program(host, own)
    turns.enter(program, program.ident)
    sys.stdin = keyboard.opened(program)
    loops.none_runs()
    try:
        start = importlib.import_module("rclpy_backend.program").run
        code: int = start(module, attribute, words, environment)
    finally:
        turns.enter(program, program.ident)
        for output in program.outputs:
            output.end()
        program.end()
        turns.enter(None)
        collecting.end()
    return code
