"""Turn a wheel into an archive with the layout of the modules in a page."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from email.parser import Parser
from pathlib import Path, PurePosixPath

from packaging.requirements import InvalidRequirement, Requirement
from packaging.utils import canonicalize_name

from sitegen.nodes.python import pyodide

# Of compression. The highest, 9, would take four times as long for another 0.7 %.
LEVEL = 7


@dataclass(frozen=True)
class Wheel:
    """An installed unit: its archive, and the modules that can be imported from it.

    `package` and `needs` are normalized names of packages.
    """

    name: str
    modules: frozenset[str]
    data: bytes
    needs: frozenset[str] = frozenset()

    @property
    def package(self) -> str:
        """The name of its package."""
        return canonicalize_name(self.name.partition("-")[0])


def opened(name: str, file: Path) -> Wheel:
    """Read a wheel, or an archive of shared libraries, from `file`."""
    files: dict[str, bytes] = {}
    needs: set[str] = set()
    with zipfile.ZipFile(file) as archive:
        for member in archive.infolist():
            path = PurePosixPath(member.filename)
            if member.is_dir() or ".." in path.parts or path.is_absolute():
                continue
            content = archive.read(member)
            if re.fullmatch(r"[^/]+\.dist-info/METADATA", member.filename):
                needs |= set(_needs(content.decode(errors="replace")))
            data = re.fullmatch(r"[^/]+\.data/(purelib|platlib)/(.+)", member.filename)
            if not name.endswith(".whl"):
                files[f"lib/{path.name}"] = content
            elif data or ".data/" not in path.parts[0] + "/":
                files[f"python/{data[2] if data else path.as_posix()}"] = content
    paths = (PurePosixPath(path).parts for path in files)
    tops = {parts[1] for parts in paths if parts[0] == "python"}
    modules = {top.partition(".")[0] for top in tops if not top.endswith(".dist-info")}
    return Wheel(name, frozenset(modules), archived(files), frozenset(needs))


def _needs(metadata: str) -> Iterator[str]:
    """Yield the packages that the metadata of a wheel requires in a page."""
    for line in Parser().parsestr(metadata).get_all("Requires-Dist") or []:
        try:
            requirement = Requirement(line)
        except InvalidRequirement:
            continue  # pip would have refused the wheel
        if requirement.marker is None or requirement.marker.evaluate(pyodide.environment()):
            yield canonicalize_name(requirement.name)


def archived(files: Mapping[str, bytes]) -> bytes:
    """Return a ZIP file, the same bytes for the same files."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            archive.writestr(entry, files[name], zipfile.ZIP_DEFLATED, LEVEL)
    return buffer.getvalue()
