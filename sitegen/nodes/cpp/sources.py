"""Download the sources of libraries that are compiled for the page.

They are those of the Debian or Ubuntu on this computer: apt-get verifies them, and programs of the
page have the same versions as those of the robot.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tarfile
import tempfile
from collections.abc import Iterator
from fnmatch import fnmatchcase
from pathlib import Path, PurePosixPath

from filelock import FileLock

from sitegen.errors import SiteError
from sitegen.model import Package
from sitegen.report import Report
from sitegen.shipped import PACKAGES
from sitegen.workspace.libraries import COMPILED, Compiled

# Where Debian and Ubuntu list their own archives. Those of others need not have sources.
ARCHIVES = [
    Path("/etc/apt", name)
    for name in ("sources.list", "sources.list.d/debian.sources", "sources.list.d/ubuntu.sources")
]
LICENCE = re.compile(r"(LICEN[CS]E|COPYING|COPYRIGHT)(\.\w+)?", re.IGNORECASE)
# A download without progress is given up after this time (s).
PATIENCE = 300


class LibrarySources:
    """The sources of libraries in `folder`, each in a folder with the name of its package."""

    def __init__(self, folder: Path, report: Report) -> None:
        self._folder = folder
        self._report = report
        self._faults: dict[str, str] = {}

    def of(self, package: Package) -> list[Path]:
        """Return the folder with the source of `package`, which is downloaded if necessary.

        There is none for packages that have their own source, or if the download fails.
        """
        library = next((one for one in COMPILED if one.package == package.name), None)
        if not library or not package.path.is_relative_to(PACKAGES):
            return []
        place = self._folder / library.package
        if not place.exists() and library.package not in self._faults:
            self._folder.mkdir(parents=True, exist_ok=True)
            with (
                FileLock(self._folder / "lock"),
                self._report.during(library.package, "downloading its source, with apt-get"),
            ):
                try:
                    _provide(library, place)
                except _DownloadError as error:
                    what = f"the source of '{library.package}' is missing: {error}"
                    self._faults[library.package] = f"{what}; unpack it to {place}"
        return [place] if place.exists() else []

    def check(self, package: Package) -> None:
        """Raise SiteError if the source of `package` could not be downloaded."""
        if fault := self._faults.get(package.name):
            raise SiteError([fault])


class _DownloadError(Exception):
    """A source could not be downloaded; the message says why."""


def _provide(library: Compiled, place: Path) -> None:
    if place.exists():  # another build was faster
        return
    with tempfile.TemporaryDirectory(dir=place.parent) as temporary:
        archive = _download(library.source, Path(temporary))
        draft = Path(temporary, "unpacked")
        _unpack(archive, library.parts, draft)
        version = re.search(r"_(\d[\d.]*)", archive.name)
        (draft / "version.txt").write_text(version[1].strip(".") if version else "1.0")
        draft.rename(place)


def _download(source: str, folder: Path) -> Path:
    """Download the archive of upstream's source with apt-get, whose own state is left alone."""
    apt = shutil.which("apt-get")
    lists = folder / "lists"
    (folder / "archives" / "partial").mkdir(parents=True)
    (lists / "partial").mkdir(parents=True)
    (folder / "sources.list.d").mkdir()
    for number, file in enumerate(each for each in ARCHIVES if each.is_file()):
        text = "\n".join(_with_sources(file.read_text(encoding="utf-8-sig", errors="replace")))
        (folder / "sources.list.d" / f"{number}{file.suffix}").write_text(text, encoding="utf-8")
    if not apt or not any((folder / "sources.list.d").iterdir()):
        raise _DownloadError("this computer has no apt-get of Debian or Ubuntu")
    options = {
        "APT::Sandbox::User": "root",
        "Dir::Cache": folder,
        "Dir::Etc::sourcelist": "/dev/null",
        "Dir::Etc::sourceparts": folder / "sources.list.d",
        "Dir::State::lists": lists,
    }
    words = [apt, "--quiet=2", *(f"--option={name}={value}" for name, value in options.items())]
    for command in (["update"], ["source", "--download-only", source]):
        try:
            done = subprocess.run(
                [*words, *command],
                cwd=folder,
                stdin=subprocess.DEVNULL,
                text=True,
                errors="replace",
                capture_output=True,
                timeout=PATIENCE,
            )
        except subprocess.TimeoutExpired:
            raise _DownloadError(f"apt-get did not finish in {PATIENCE} s") from None
        if done.returncode:
            errors = [line[3:] for line in done.stderr.splitlines() if line.startswith("E: ")]
            raise _DownloadError(f"apt-get: {(errors or [done.stderr.strip()])[0]}")
    found = [each for each in folder.glob("*.orig.tar.*") if each.suffix != ".asc"]
    if not found:
        raise _DownloadError(f"apt-get found no archive of '{source}'")
    return found[0]


def _with_sources(text: str) -> Iterator[str]:
    """Yield the lines of a list of archives, changed from programs to sources.

    Those with security updates are left out: the updates are patches, and the archives of
    upstream's source are those of the release.
    """
    for entry in re.split(r"\n[ \t]*\n", text):
        lines = [*_of_release(entry)]
        if not any(line.strip() == "Suites:" for line in lines):
            yield from (*lines, "")


def _of_release(entry: str) -> Iterator[str]:
    for line in entry.splitlines():
        if re.match(r"(Types:|deb\s)", line):
            if not (line.startswith("deb") and "security" in line):
                yield re.sub(r"^Types:.*", "Types: deb-src", re.sub(r"^deb\s", "deb-src ", line))
        elif line.startswith("Suites:"):
            yield re.sub(r"\s+\S*security\S*", "", line)
        elif not line.startswith("deb-src"):
            yield line


def _is_of(path: PurePosixPath, part: PurePosixPath) -> bool:
    named = path.parent == part.parent and fnmatchcase(path.name, part.name)
    return named or path.is_relative_to(part)


def _unpack(archive: Path, parts: tuple[str, ...], place: Path) -> None:
    """Unpack the folders and files `parts` of an archive, and their licences."""
    wanted = [PurePosixPath(part) for part in parts]
    above = {folder for part in wanted for folder in part.parents}
    place.mkdir()
    with tarfile.open(archive) as opened:
        for member in opened:
            path = PurePosixPath(*PurePosixPath(member.name).parts[1:])
            if not member.isfile() or ".." in path.parts:
                continue
            licence = path.parent in above and LICENCE.fullmatch(path.name)
            if licence or any(_is_of(path, part) for part in wanted):
                content = opened.extractfile(member)
                assert content is not None  # it is a file
                target = place / path
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content.read())
