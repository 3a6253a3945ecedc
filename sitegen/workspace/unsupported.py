"""Find the libraries that the programs of a package need and that a page cannot have."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from pathlib import Path

from sitegen.model import Package
from sitegen.workspace.libraries import UNAVAILABLE, Library, of_header

HEADER = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)


def unsupported_libraries(
    package: Package, workspace: Collection[str], lacking: Collection[Library] = UNAVAILABLE
) -> dict[str, Library]:
    """Return the first library that each executable lacks, where it is known.

    `workspace` are the names of the packages of the workspace, whose headers are there, and
    `lacking` are the libraries that are not.
    """
    found: dict[str, Library] = {}
    named = {file for files in package.sources.values() for file in files}
    sources = (file.relative_to(package.path).as_posix() for file in package.path.rglob("*.cpp"))
    others = [file for file in sources if file not in named and not file.startswith("test/")]
    for executable in package.executables or ():
        files = package.sources.get(executable, ())
        # The source files of a component are not known, so it is assumed to need all libraries.
        missing = [_missing(package.path, (file,), workspace, lacking) for file in files or others]
        if missing and (all(missing) or (files and any(missing))):
            found[executable] = next(filter(None, missing))
    return found


def _missing(
    folder: Path, files: tuple[str, ...], workspace: Collection[str], lacking: Collection[Library]
) -> Library | None:
    for header in _headers(folder, files):
        library, first = of_header(header), header.partition("/")[0]
        # The package may have a copy of the library.
        if library in lacking and first not in workspace and not any(folder.rglob(header)):
            return library
    return None


def _headers(folder: Path, files: tuple[str, ...]) -> Iterator[str]:
    """Yield the headers that source files of a package include and that the package has not."""
    waiting, seen = [folder / file for file in files], set[Path]()
    while waiting:
        file = waiting.pop()
        if file in seen:
            continue
        seen.add(file)
        text = file.read_text(encoding="utf-8-sig", errors="replace") if file.is_file() else ""
        near = (file.parent, folder / "include", folder / "src", folder)
        for name in HEADER.findall(text):
            own = [place / name for place in near if (place / name).is_file()]
            waiting += own
            if not own:
                yield name
