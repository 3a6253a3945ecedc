"""Give launch files the share folder of each package, as installing it would lay it out."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from sitegen.model import Package

# Where programs of a page find what packages install.
PREFIX = "/ros"
# What the names of the folders begin with that are made for the time of a launch file.
MADE = "sitegen-"


@contextmanager
def shares(packages: Mapping[str, Package]) -> Iterator[dict[str, Path]]:
    """Yield the folders by package: its own, where installing leaves all files where they are."""
    with tempfile.TemporaryDirectory(prefix=MADE) as temporary:
        folders = {}
        for name, package in packages.items():
            files = _files(package)
            moved = any(package.path / path != file for path, file in files.items())
            folders[name] = (
                _linked(Path(temporary) / name, package, files) if moved else package.path
            )
        yield folders


def on_page(text: str, folders: Mapping[str, Path]) -> str:
    """Return a text for a program of a page, which finds share folders elsewhere."""
    for name, folder in folders.items():
        text = re.sub(rf"{re.escape(str(folder))}(?![\w.-])", f"{PREFIX}/share/{name}", text)
    return text


def by_package(text: str) -> str:
    """Return a text for an author, who knows packages, and not the folders that shares() makes."""
    made = re.escape(f"{tempfile.gettempdir()}/{MADE}")
    return re.sub(rf"{made}\w+/(\w+)", r"$(find-pkg-share \1)", text)


def _files(package: Package) -> dict[str, Path]:
    """Return what is installed to the share folder of a package, by path there."""
    above = f"share/{package.name}/"
    files = package.setup.files if package.setup else {}
    return {
        path.removeprefix(above): file for path, file in files.items() if path.startswith(above)
    }


def _linked(folder: Path, package: Package, files: Mapping[str, Path]) -> Path:
    """Make a folder of links: to what is installed, and beside it to what else the package has."""
    for path, file in files.items():
        link = folder / path
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to(file.resolve())
    for each in package.path.iterdir():
        if not (folder / each.name).exists():
            (folder / each.name).symlink_to(each.resolve())
    return folder
