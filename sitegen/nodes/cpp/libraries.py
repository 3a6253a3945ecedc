"""Let CMake find the libraries of workspace/libraries.py, and the compiler their headers."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from importlib import metadata
from itertools import islice
from pathlib import Path

from sitegen.cache.digest import digest_of
from sitegen.workspace.libraries import COMPILED, EIGEN, HEADER_ONLY, LIBRARIES, Library

# Where Debian, `make install` and Homebrew put headers.
ROOTS = [Path(root, "include") for root in ("/usr", "/usr/local", "/opt/homebrew")]
# The folder of Eigen's headers, with whose name programs may include them.
EIGEN_FOLDER = "eigen3"


def write(prefix: Path) -> None:
    """Add the CMake packages of all libraries to the prefix."""
    for library in LIBRARIES:
        for package, targets in library.packages.items():
            lists = map(";".join, (library.definitions, library.options))
            values = [package, "|".join(library.marks), targets, *lists]
            words = " ".join(f'"{value}"' for value in values)
            _write_package(prefix, package, f"sitegen_library({words})\n", library.version)
    for compiled in COMPILED:
        for name in compiled.names:
            _write_package(prefix, name, f"sitegen_compiled({name} {compiled.package})\n", "1.0.0")


def _write_package(prefix: Path, package: str, text: str, version: str) -> None:
    folder = prefix / "share" / package / "cmake"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{package}Config.cmake").write_text(text)
    (folder / f"{package}ConfigVersion.cmake").write_text(f'sitegen_any_version("{version}")\n')


def link(folder: Path, eigen: Path | None) -> None:
    """Make a folder of the headers that programs may use, and of no others of this computer.

    `eigen` is the folder of Eigen's CMake package.
    """
    folder.mkdir(parents=True, exist_ok=True)
    found = {mark.relative_to(root).parts[0]: root for root, mark in _installed()}
    headers = {name: root / name for name, root in found.items()}
    if eigen:
        headers[EIGEN_FOLDER] = eigen.parents[2] / "include" / EIGEN_FOLDER
    for name, target in headers.items():
        place = folder / name
        if not place.is_symlink() or place.readlink() != target:
            place.unlink(missing_ok=True)
            place.symlink_to(target)


def identity() -> str:
    """Return a value that changes with the versions of the headers that are installed."""
    return digest_of(mark for _, mark in _installed())


def find_eigen() -> Path | None:
    """Return the folder of the CMake package of Eigen, from PyPI or from the system."""
    folders = [root.parent / "share/eigen3/cmake" for root in ROOTS]
    with contextlib.suppress(metadata.PackageNotFoundError):
        place = metadata.distribution("cmeel-eigen").locate_file("cmeel.prefix/share/eigen3/cmake")
        folders.insert(0, Path(str(place)))
    return next((folder for folder in folders if (folder / "Eigen3Config.cmake").is_file()), None)


def header_of(library: Library) -> Path | None:
    """Return a file that only this library has; None if its headers are not installed here."""
    if library is EIGEN:
        found = find_eigen()
        return found / "Eigen3Config.cmake" if found else None
    return next((mark for _, mark in _marks(library)), None)


def not_installed() -> list[Library]:
    """Return the libraries of which this computer lacks the headers."""
    return [one for one in HEADER_ONLY if not header_of(one)]


def _installed() -> Iterator[tuple[Path, Path]]:
    """Yield a header with the version of each library that is installed, after its root."""
    for library in HEADER_ONLY:
        yield from islice(_marks(library), 1)


def _marks(library: Library) -> Iterator[tuple[Path, Path]]:
    marks = ((root, root / mark) for root in ROOTS for mark in library.marks)
    return (each for each in marks if each[1].is_file())
