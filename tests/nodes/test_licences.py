"""The licences of the libraries that programs contain."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from sitegen.model import Package
from sitegen.nodes.cpp import libraries
from sitegen.nodes.cpp.licences import licences_of
from sitegen.nodes.cpp.sources import LibrarySources
from sitegen.report import Report


def licences(folder: Path, include: str, *, within: str = "src") -> tuple[dict[str, str], str]:
    """Return the licences of a package with one include, by path, and what is reported."""
    path = folder / "package"
    (path / within).mkdir(parents=True, exist_ok=True)
    (path / within / "talker.cpp").write_text(f"#include <{include}>\nint main() {{}}\n")
    package = Package("cpp", path, "ament_cmake", (), (), ())
    said = io.StringIO()
    sources = LibrarySources(folder / "sources", Report(said))
    found = licences_of([package], sources, Report(said))
    texts = (each.source for each in found)
    contents = (text if isinstance(text, bytes) else text.read_bytes() for text in texts)
    paths = (each.path for each in found)
    return {
        path: text.decode() for path, text in zip(paths, contents, strict=True)
    }, said.getvalue()


@pytest.mark.parametrize(
    ("include", "names"),
    [
        ("boost/algorithm/clamp.hpp", ["Boost"]),
        ("fmt/format.h", ["fmt"]),
        ("spdlog/spdlog.h", ["fmt", "spdlog"]),
        ("nlohmann/json.hpp", ["nlohmann_json"]),
    ],
)
def test_those_of_packages_of_debian(tmp_path: Path, include: str, names: list[str]) -> None:
    found, said = licences(tmp_path, include)
    assert [*found] == [f"nodes/licenses/{name}/copyright" for name in names]
    for text in found.values():
        assert "permission" in text.lower()
    assert said == ""


def test_the_one_of_eigen_without_a_package_of_debian(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "share/eigen3/cmake"
    place.mkdir(parents=True)
    (place / "Eigen3Config.cmake").touch()
    monkeypatch.setattr(libraries, "find_eigen", lambda: place)
    found, said = licences(tmp_path, "Eigen/Dense")
    assert "Mozilla Public License 2.0" in found["nodes/licenses/Eigen/NOTICE.txt"]
    assert said == ""


def test_those_of_homebrew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cellar = tmp_path / "Cellar/fmt/10.2.1_1"
    (cellar / "include/fmt").mkdir(parents=True)
    (cellar / "include/fmt/core.h").touch()
    (cellar / "LICENSE").write_text("as you like")
    (tmp_path / "include").mkdir()
    (tmp_path / "include/fmt").symlink_to(cellar / "include/fmt")
    monkeypatch.setattr(libraries, "ROOTS", [tmp_path / "include"])
    found, said = licences(tmp_path, "fmt/core.h")
    assert found == {"nodes/licenses/fmt/LICENSE": "as you like"}
    assert said == ""


def test_one_that_is_not_there_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "include/fmt").mkdir(parents=True)
    (tmp_path / "include/fmt/core.h").touch()
    monkeypatch.setattr(libraries, "ROOTS", [tmp_path / "include"])
    found, said = licences(tmp_path, "fmt/core.h")
    assert found == {}
    assert said == (
        "the license of 'fmt' was not found on this computer; "
        "add it to the site, as programs contain its code\n"
    )


def test_no_others(tmp_path: Path) -> None:
    assert licences(tmp_path, "fmt/core.h", within="test") == ({}, "")
    own = tmp_path / "package/include/fmt"
    own.mkdir(parents=True)
    (own / "core.h").touch()
    assert licences(tmp_path, "fmt/core.h") == ({}, "")
