"""Leave out plugins and components that cannot be built, and say so in each build.

A program is linked with the plugins of all packages of the workspace that it may load. One that
needs what no page can have must not cost the others: packages that fail are left out and, of a
package that does not, single libraries.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from sitegen.model import Build, Package
from sitegen.nodes.cpp.diagnosis import lacks_library, lacks_package
from sitegen.nodes.cpp.leftout import Problems
from sitegen.nodes.cpp.store import write

# What follows the problem of a package or of a library.
LEFT_OUT = " (left out: "


def lost(package: Package, failed: Problems, *, keep_going: bool) -> Problems:
    """Return the packages whose plugins `package` does without, with what is wrong with each.

    `failed` has the errors of packages. Errors in sources count only with `keep_going`.
    """
    found = {name: failed[name] for name in package.linked if name in failed}
    return {name: lines for name, lines in found.items() if keep_going or _is_no_error(lines)}


def note(build: Build, packages: Problems, libraries: Iterable[Problems]) -> None:
    """Keep beside a program what it is built without: packages, and libraries of others."""
    lines = _without("the plugins of ", packages)
    for problems in libraries:
        lines += _without("the library ", problems)
    file = _list_of(build)
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


def _without(what: str, problems: Problems) -> list[str]:
    found = []
    for name in problems:
        for problem in problems[name]:
            first, newline, rest = problem.partition("\n")
            found.append(f"{first}{LEFT_OUT}{what}'{name}'){newline}{rest}")
    return found


def _is_no_error(lines: Sequence[str]) -> bool:
    return all(lacks_library(line) or lacks_package(line) for line in lines)


def _list_of(build: Build) -> Path:
    return build.wasm.with_suffix(".left-out.txt")
