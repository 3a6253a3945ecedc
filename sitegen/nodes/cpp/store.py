"""Keep a finished program in the cache."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Sequence
from pathlib import Path

from sitegen.interfaces import messages
from sitegen.model import Build
from sitegen.nodes.cpp import sourcemap


def keep(program: Path, prefixes: Sequence[Path], shown: Sequence[str], build: Build) -> None:
    """Copy a linked program, named without its suffix, to where `build` says.

    `prefixes` are those of the packages with its interfaces, `shown` the paths of the packages
    whose source lines are recorded.
    """
    build.wasm.parent.mkdir(parents=True, exist_ok=True)
    types = messages.types_of(program.with_suffix(".wasm"), prefixes)
    write(build.types, json.dumps(types).encode())
    if build.lines:
        lines = sourcemap.lines_of(program.with_suffix(".wasm.map"), shown)
        write(build.lines, json.dumps(lines, separators=(",", ":")).encode())
    write(build.script, program.with_suffix(".js").read_bytes())
    # Last: the presence of this file means that the program is complete.
    write(build.wasm, program.with_suffix(".wasm").read_bytes())


def write(file: Path, content: bytes) -> None:
    """Write a file in one step: another build may read it, or write the same."""
    with tempfile.TemporaryDirectory(dir=file.parent) as temporary:
        draft = Path(temporary) / file.name
        draft.write_bytes(content)
        draft.replace(file)
