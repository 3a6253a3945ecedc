"""Give launch files the share folder of each package, laid out as an installation would be."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from sitegen.model import Package

# The path of share folders in the page.
PREFIX = "/ros"
# The prefix of the temporary folders that exist while a launch file is read.
MADE = "sitegen-"


@contextmanager
def shares(packages: Mapping[str, Package]) -> Iterator[dict[str, Path]]:
    """Yield the share folders by package: its own folder if an installation has the same layout."""
    with tempfile.TemporaryDirectory(prefix=MADE) as temporary:
        folders = {}
        for name, package in packages.items():
            files = _files(package)
            moved = any(package.path / path != file for path, file in files.items())
            folders[name] = (
                _linked(Path(temporary) / name, package, files) if moved else package.path
            )
        yield folders


def share_path(file: Path, package: Package) -> str:
    """Return the path that a file of a package has in its share folder."""
    installed = (path for path, source in _files(package).items() if source == file)
    return next(installed, file.relative_to(package.path).as_posix())


def on_page(text: str, folders: Mapping[str, Path]) -> str:
    """Replace the share folders in a text by their paths in the page."""
    for name, folder in folders.items():
        text = re.sub(rf"{re.escape(str(folder))}(?![\w.-])", f"{PREFIX}/share/{name}", text)
    return text


def by_package(text: str) -> str:
    """Replace the share folders in a message by the names of their packages."""
    made = re.escape(f"{tempfile.gettempdir()}/{MADE}")
    return re.sub(rf"{made}\w+/(\w+)", r"$(find-pkg-share \1)", text)


def _files(package: Package) -> dict[str, Path]:
    """Return the files that are installed to the share folder of a package, by path in it."""
    above = f"share/{package.name}/"
    return {
        path.removeprefix(above): file
        for path, file in package.share.items()
        if path.startswith(above)
    }


def _linked(folder: Path, package: Package, files: Mapping[str, Path]) -> Path:
    """Make a folder of links to the installed files and to the other files of the package."""
    for path, file in files.items():
        link = folder / path
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to(file.resolve())
    for each in package.path.iterdir():
        if not (folder / each.name).exists():
            (folder / each.name).symlink_to(each.resolve())
    return folder
