"""Leave out the plugins of packages that cannot be built, and say so in each build.

A program is linked with the plugins of all packages of the workspace that it may load. One that
needs what no page can have must not cost the others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from sitegen.model import Build, Package
from sitegen.nodes.cpp.diagnosis import lacks_library, lacks_package
from sitegen.nodes.cpp.store import write

# What follows the problem of a package.
LEFT_OUT = " (left out: the plugins of "


def lost(
    package: Package, failed: Mapping[str, Sequence[str]], *, keep_going: bool
) -> dict[str, Sequence[str]]:
    """Return the packages whose plugins `package` does without, with what is wrong with each.

    `failed` has the errors of packages. Errors in sources count only with `keep_going`.
    """
    found = {name: failed[name] for name in package.linked if name in failed}
    return {name: lines for name, lines in found.items() if keep_going or _is_no_error(lines)}


def note(build: Build, found: Mapping[str, Sequence[str]]) -> None:
    """Keep what a program is built without beside it."""
    file = _list_of(build)
    lines = [_without(name, line) for name in found for line in found[name]]
    if lines:
        file.parent.mkdir(parents=True, exist_ok=True)
        write(file, "\0".join(lines).encode())
    else:
        file.unlink(missing_ok=True)


def noted(build: Build) -> list[str]:
    """Return what a program was built without, in one line for each problem."""
    file = _list_of(build)
    return file.read_text(encoding="utf-8").split("\0") if file.exists() else []


def is_complete(build: Build) -> bool:
    """Return whether a program exists, and has the plugins of all packages that had errors."""
    lines = [line.partition(LEFT_OUT)[0] for line in noted(build)]
    return build.wasm.exists() and _is_no_error(lines)


def _without(name: str, problem: str) -> str:
    first, newline, rest = problem.partition("\n")
    return f"{first}{LEFT_OUT}'{name}'){newline}{rest}"


def _is_no_error(lines: Sequence[str]) -> bool:
    return all(lacks_library(line) or lacks_package(line) for line in lines)


def _list_of(build: Build) -> Path:
    return build.wasm.with_suffix(".left-out.txt")
