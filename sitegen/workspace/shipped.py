"""The packages that come with sitegen."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cache

from sitegen import shipped
from sitegen.model import Package, Setup
from sitegen.workspace.packages import PYTHON, scan

# The package of the Python programs of sitegen.
SITEGEN = "sitegen"
# The program that runs the cells of a notebook.
NOTEBOOK = "notebook"
# The same for the cells of a page, without IPython.
CELLS = "cells"
TURTLESIM, TURTLESIM_MSGS = "turtlesim", "turtlesim_msgs"
IMPORT = re.compile(r"^\s*(?:from|import)\s+(\w+)", re.MULTILINE)


def sitegen_package(packages: Mapping[str, Package]) -> Package:
    """Return the package of sitegen's Python programs, which may import all of `packages`."""
    scripts = {
        "prompt": "rclpy_backend.prompt:main",
        NOTEBOOK: "rclpy_backend.notebook:main",
        CELLS: "rclpy_backend.cells:main",
    }
    setup = Setup(scripts, {})
    path = shipped.CLIENTS / "python"
    executables = tuple(setup.scripts)
    return Package(SITEGEN, path, PYTHON, tuple(packages), executables, (), setup=setup)


@cache
def shipped_packages() -> Mapping[str, Package]:
    """Return the ROS packages that come with sitegen, by name."""
    return scan(shipped.PACKAGES)


def replaced(packages: Mapping[str, Package]) -> list[str]:
    """Return the names of packages that need Qt, and that sitegen has for pages."""
    return [name for name, one in packages.items() if one.windowed and name in shipped_packages()]


def with_replaced(packages: Mapping[str, Package]) -> dict[str, Package]:
    """Return `packages`, with the executables of sitegen where it replaces one.

    Such a package keeps its folder, which has its launch files.
    """
    changed = {
        name: replace(packages[name], executables=shipped_packages()[name].executables, sources={})
        for name in replaced(packages)
    }
    return {**packages, **changed}


def with_shipped(packages: Mapping[str, Package], names: Iterable[str] = ()) -> dict[str, Package]:
    """Return `packages` and the shipped packages that they or `names` depend on.

    Those that sitegen replaces are among the latter.
    """
    found: dict[str, Package] = {}
    instead = set(replaced(packages))
    for name, one in packages.items():
        if name in instead:
            continue
        undeclared = (each for each in _imported(one) if each in shipped_packages())
        found[name] = replace(one, depends=tuple(dict.fromkeys([*one.depends, *undeclared])))
    waiting = [*names, *(name for one in found.values() for name in one.depends)]
    while waiting:
        name = waiting.pop()
        if name in shipped_packages() and name not in found:
            found[name] = shipped_packages()[name]
            waiting += found[name].depends
    own = TURTLESIM in packages and TURTLESIM not in instead
    if TURTLESIM in found and not own and TURTLESIM_MSGS in found:
        # Programs that use turtlesim_msgs expect a turtlesim that uses them, too.
        turtlesim = found[TURTLESIM]
        found[TURTLESIM] = replace(turtlesim, depends=(*turtlesim.depends, TURTLESIM_MSGS))
    return found


def _imported(package: Package) -> Iterator[str]:
    """Yield the modules that the Python sources of a package import."""
    scripts = package.setup.scripts.values() if package.setup else ()
    for path, file in (package.setup.files if package.setup else {}).items():
        if file.suffix == ".py" or path in scripts:
            yield from IMPORT.findall(file.read_text(encoding="utf-8-sig", errors="replace"))
