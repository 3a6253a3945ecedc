"""Keep a finished program in the cache."""

from __future__ import annotations

import json
import shutil
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
    build.types.write_text(json.dumps(types))
    if build.lines:
        lines = sourcemap.lines_of(program.with_suffix(".wasm.map"), shown)
        build.lines.write_text(json.dumps(lines, separators=(",", ":")))
    shutil.copyfile(program.with_suffix(".js"), build.script)
    # Last, and in one step: the presence of this file means that the program is complete.
    draft = build.wasm.with_suffix(".draft")
    shutil.copyfile(program.with_suffix(".wasm"), draft)
    draft.replace(build.wasm)
