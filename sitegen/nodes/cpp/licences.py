"""Find the licences of the libraries that programs contain, for the site."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path

from sitegen.model import Artifact, Package
from sitegen.nodes.cpp.libraries import header_of
from sitegen.nodes.cpp.sources import LICENCE, LibrarySources
from sitegen.report import Report
from sitegen.workspace.libraries import COMPILED, EIGEN, HEADER_ONLY, Library, of_header
from sitegen.workspace.unsupported import HEADER

SOURCE = re.compile(r"\.(c|cc|cpp|cxx|h|hh|hpp|hxx|inl|ipp|tpp)")
# The headers of the first include those of the second.
BRINGS = {"spdlog": "fmt"}
# A folder with one version of a library, as those of Homebrew.
VERSION = re.compile(r"\d+(\.\w+)+")
DEBIAN_DOCS = Path("/usr/share/doc")
# The one of PyPI comes without a text. Its licence asks to say where its source is.
EIGEN_NOTICE = b"""\
Eigen is available under the Mozilla Public License 2.0, https://mozilla.org/MPL/2.0/.
Its source is at https://gitlab.com/libeigen/eigen.
"""


def licences_of(
    packages: Sequence[Package], sources: LibrarySources, report: Report
) -> list[Artifact]:
    """Return the licences of the libraries that programs of `packages` may contain.

    These are the libraries among `packages`, and those of which they include headers. A licence
    that is not on this computer is reported.
    """
    artifacts = [artifact for package in packages for artifact in _compiled(package, sources)]
    folders = [folder for each in packages for folder in (each.path, *sources.of(each))]
    for library in _included(folders):
        found = _header_licences(library)
        artifacts += found
        if not found:
            what = f"the license of '{library.name}' was not found on this computer"
            report.say_once(f"{what}; add it to the site, as programs contain its code", "warning")
    return artifacts


def _compiled(package: Package, sources: LibrarySources) -> Iterator[Artifact]:
    named = {one.package: one.licence for one in COMPILED}
    for folder in sources.of(package):
        for file in sorted(folder.rglob("*")):
            if LICENCE.fullmatch(file.name) or file == folder / named[package.name]:
                yield _artifact(package.name, file)


def _included(folders: Iterable[Path]) -> list[Library]:
    """Return the header-only libraries that sources in `folders` include and bring no copy of."""
    names = {library.name for folder in folders for library in _included_in(folder)}
    names |= {BRINGS[name] for name in names if name in BRINGS}
    return [library for library in HEADER_ONLY if library.name in names and header_of(library)]


def _included_in(folder: Path) -> Iterator[Library]:
    headers = set[str]()
    for file in folder.rglob("*"):
        tested = "test" in file.relative_to(folder).parts
        if SOURCE.fullmatch(file.suffix) and not tested and file.is_file():
            text = file.read_text(encoding="utf-8-sig", errors="replace")
            headers.update(HEADER.findall(text))
    for header in headers:
        library = of_header(header)
        if library in HEADER_ONLY and not any(folder.rglob(header)):
            yield library


def _header_licences(library: Library) -> list[Artifact]:
    header = header_of(library)
    files = _installed_with(header.resolve()) if header else []
    if library is EIGEN and not files:
        return [Artifact(f"nodes/licenses/{library.name}/NOTICE.txt", EIGEN_NOTICE)]
    return [_artifact(library.name, file) for file in files]


@cache  # dpkg reads its lists of all files
def _installed_with(header: Path) -> list[Path]:
    """Return the files with the licence of the library of an installed header."""
    for folder in header.parents:
        if VERSION.fullmatch(folder.name):
            return sorted(each for each in folder.iterdir() if LICENCE.fullmatch(each.name))
    dpkg = shutil.which("dpkg")
    if not dpkg:
        return []
    done = subprocess.run([dpkg, "--search", header], capture_output=True, text=True)
    copyright = DEBIAN_DOCS / done.stdout.partition(":")[0] / "copyright"
    return [copyright] if done.stdout and copyright.is_file() else []


def _artifact(library: str, file: Path) -> Artifact:
    return Artifact(f"nodes/licenses/{library}/{file.name}", file)
