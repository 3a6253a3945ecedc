"""Pack plain Python packages that sitegen needs itself, for programs that import them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from functools import cache
from importlib import metadata
from pathlib import Path

from sitegen.nodes.python.imports import Import
from sitegen.nodes.python.ipython import installed
from sitegen.nodes.python.wheel import archived

# Package and executable.
Program = tuple[str, str]

# Programs of ROS compare versions with it.
MODULES = frozenset({"packaging"})


def taken(
    wanted: Mapping[Program, dict[str, Import]], provided: Collection[str]
) -> dict[Program, list[str]]:
    """Take the modules out of `wanted` that are packed here, and return them by program.

    Those that are `provided` by the site stay there.
    """
    found = {}
    for program, modules in wanted.items():
        found[program] = sorted(MODULES & modules.keys() - {*provided})
        for name in found[program]:
            del modules[name]
    return found


def path(name: str) -> str:
    """Return the path of the archive of a package."""
    return f"nodes/{name}.zip"


@cache
def archive(name: str) -> bytes:
    """Return the archive of an installed package, with its licenses."""
    files = {path: data for path, data in installed(name) if "__pycache__" not in path}
    for file in metadata.files(name) or ():
        if "LICENSE" in file.name:
            files[f"python/{file.as_posix()}"] = Path(str(file.locate())).read_bytes()
    return archived(files)
