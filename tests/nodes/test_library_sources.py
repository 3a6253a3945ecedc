"""The sources of libraries that are compiled for the page."""

from __future__ import annotations

import io
import tarfile
from dataclasses import replace
from pathlib import Path

import pytest

from sitegen.errors import SiteError
from sitegen.nodes.cpp import sources
from sitegen.nodes.cpp.licences import licences_of
from sitegen.nodes.cpp.sources import LibrarySources
from sitegen.report import Report
from sitegen.workspace import shipped_packages
from sitegen.workspace.libraries import COMPILED, COMPILED_BY, compiled

DEBIAN = """\
Types: deb
URIs: http://example.org/debian
Suites: bookworm bookworm-updates
"""
SECURITY = """\
Types: deb
URIs: http://example.org/debian-security
Suites: bookworm-security

Types: deb
URIs: http://example.org/ubuntu
Suites: noble noble-updates noble-security
"""
UBUNTU = """\
# See the manual.
deb [arch=amd64] http://example.org/ubuntu jammy main
deb-src http://example.org/ubuntu jammy main
deb http://security.example.org/ubuntu jammy-security main
"""


def test_the_archive_of_debian_has_all_of_them(tmp_path: Path) -> None:
    found = LibrarySources(tmp_path / "sources", Report(io.StringIO()))
    packages = [shipped_packages()[one.package] for one in COMPILED]
    for package, one in zip(packages, COMPILED, strict=True):
        (folder,) = found.of(package)
        found.check(package)
        assert all([*folder.glob(part)] for part in one.parts if part != ".")
        assert (folder / "version.txt").read_text()[0].isdecimal()
    said = io.StringIO()
    licences = [each.path.split("/")[2] for each in licences_of(packages, found, Report(said))]
    # That of KDL includes the headers of Eigen.
    assert {*licences} >= {*(one.package for one in COMPILED), "Eigen"}
    assert said.getvalue() == ""
    # A package of the workspace has its own source.
    own = replace(packages[0], path=tmp_path / "src" / "yaml-cpp")
    assert found.of(own) == []


def test_libraries_are_known_by_many_names() -> None:
    assert compiled(["rclcpp", "yaml_cpp_vendor", "TinyXML2"]) == ["yaml-cpp", "tinyxml2"]
    assert set(COMPILED_BY.values()) <= set(shipped_packages())


def test_archives_of_programs_become_those_of_sources() -> None:
    assert next(iter(sources._with_sources(DEBIAN))) == "Types: deb-src"
    assert list(sources._with_sources(UBUNTU)) == [
        "# See the manual.",
        "deb-src [arch=amd64] http://example.org/ubuntu jammy main",
        "",
    ]


def test_archives_of_security_updates_are_left_out() -> None:
    assert list(sources._with_sources(SECURITY)) == [
        "Types: deb-src",
        "URIs: http://example.org/ubuntu",
        "Suites: noble noble-updates",
        "",
    ]


def test_a_source_that_cannot_be_downloaded_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sources, "ARCHIVES", [])
    found = LibrarySources(tmp_path, Report(io.StringIO()))
    package = shipped_packages()["tinyxml2"]
    assert found.of(package) == []
    with pytest.raises(SiteError) as wrong:
        found.check(package)
    assert wrong.value.lines == [
        "the source of 'tinyxml2' is missing: this computer has no apt-get of Debian or Ubuntu; "
        f"unpack it to {tmp_path}/tinyxml2"
    ]
    assert [each.name for each in tmp_path.iterdir()] == ["lock"]


def test_only_what_is_needed_is_unpacked(tmp_path: Path) -> None:
    archive = tmp_path / "library_1.0.orig.tar.gz"
    with tarfile.open(archive, "w:gz") as written:
        for name in (
            *("src/a.cpp", "test/b.cpp", "COPYING", "src/../../c.cpp", "/src/d.cpp", "src/LICENSE"),
            *("e.c", "f.c.in", "test/g.c", "test/LICENSE"),
        ):
            entry = tarfile.TarInfo(f"library-1.0/{name}")
            entry.size = 1
            written.addfile(entry, io.BytesIO(b"x"))
        link = tarfile.TarInfo("library-1.0/src/link.cpp")
        link.type, link.linkname = tarfile.SYMTYPE, "/etc/passwd"
        written.addfile(link)
    sources._unpack(archive, ("src", "*.c"), tmp_path / "unpacked")
    files = [file for file in tmp_path.rglob("*") if file.is_file() and file != archive]
    names = [file.relative_to(tmp_path / "unpacked").as_posix() for file in files]
    assert sorted(names) == ["COPYING", "e.c", "src/LICENSE", "src/a.cpp", "src/d.cpp"]
