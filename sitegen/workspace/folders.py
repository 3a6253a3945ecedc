"""Find the folders of packages, through links as colcon does, but not outside of the site."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from sitegen.errors import Location, Problems
from sitegen.ignored import is_ignored

MANIFEST = "package.xml"
IGNORE = {"COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE"}


def packages(folder: Path, root: Path) -> list[Path]:
    """Return the folders of packages below `folder`; those behind links by their real paths.

    Links are followed to folders below `root`, and each folder is returned once.
    """
    return [path for path, inside in _walk(folder, root) if inside]


def report_outside(folder: Path, problems: Problems) -> None:
    """Report the links below `folder` to packages that are not below the root of the site."""
    for path, inside in _walk(folder, problems.root):
        if not inside and _has_packages(path):
            message = "leads to packages outside the folder of site.yaml; copy them to this place"
            problems.add(Location(path, 1), "link", message)


def _walk(folder: Path, root: Path) -> Iterator[tuple[Path, bool]]:
    """Yield the folders of packages, and the links that lead outside of `root` with False."""
    top, limit, seen = folder.resolve(), root.resolve(), set[Path]()
    for name, names, files in os.walk(folder, followlinks=True):
        path, below = Path(name), sorted(names)
        real = path.resolve()
        names.clear()
        if not real.is_relative_to(limit):
            yield path, False
        elif real in seen or IGNORE & set(files):
            pass
        elif MANIFEST in files:
            # As in colcon, a package contains no other packages.
            yield path if real == top / path.relative_to(folder) else real, True
        else:
            at_root = real in (top, limit)
            names += (
                name
                for name in below
                if not is_ignored(name, at_root=at_root) and not name.startswith(".")
            )
        seen.add(real)


def _has_packages(folder: Path) -> bool:
    return any(any(folder.glob(pattern)) for pattern in (MANIFEST, f"*/{MANIFEST}"))
