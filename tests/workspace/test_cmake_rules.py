"""What install() and its options install, as CMake does; the answers are CMake's."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sitegen.model import BuildSettings
from sitegen.workspace import cmakelists

# Made by `cmake --install` in a project with these files; links and empty folders are left out.
FACTS = json.loads(Path(__file__).with_name("cmake_installs.json").read_text(encoding="utf-8"))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, text in FACTS["files"].items():
        file = tmp_path / "yard" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return tmp_path / "yard"


def read(folder: Path, text: str) -> cmakelists.Listing:
    file = folder / "CMakeLists.txt"
    file.write_text(f"cmake_minimum_required(VERSION 3.8)\nproject(yard NONE)\n{text}\n")
    return cmakelists.read(file, "yard", BuildSettings())


def messages(listing: cmakelists.Listing) -> list[str]:
    return [f"{fault.location.line}: {fault.key}: {fault.message}" for fault in listing.faults]


def notes(listing: cmakelists.Listing) -> list[str]:
    return [f"{note.location.line}: {note.key}: {note.message}" for note in listing.notes]


@pytest.mark.parametrize("case", FACTS["cases"], ids=lambda case: "\n".join(case["commands"]))
def test_the_same_files_as_by_cmake(folder: Path, case: dict[str, list[str]]) -> None:
    listing = read(folder, "\n".join(case["commands"]))
    if "fails" in case:
        assert messages(listing)
    else:
        assert sorted(cmakelists.installed(listing, folder.parent)) == case["installs"]
        assert messages(listing) == []
    assert notes(listing) == []


UNKNOWN = "sitegen does not know the value of"
NOT_RUN = "is not run for Python programs; a page lacks the files that it installs"
MISSING = "add it, or remove it from this command"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "install(PROGRAMS scripts/on.py DESTINATION lib/yard)",
            ["3: install: no file 'scripts/on.py'; did you mean 'one.py'?"],
        ),
        (
            "install(DIRECTORY launc/ urdf DESTINATION share/yard)",
            [
                "3: install: no folder 'launc'; did you mean 'launch'?",
                f"3: install: no folder 'urdf'; {MISSING}",
            ],
        ),
        (
            "\ninstall(FILES\n  launch\n  DESTINATION share/yard)",
            ["4: install: 'launch' is a folder; write install(DIRECTORY …)"],
        ),
        (
            "add_subdirectory(scripts)\nadd_subdirectory(mor)",
            [
                "3: add_subdirectory: no CMakeLists.txt in 'scripts'; add it, or remove this line",
                "4: add_subdirectory: no folder 'mor'; did you mean 'more'?",
            ],
        ),
        (
            "include(mods/Mind.cmake)",
            ["3: include: no file 'mods/Mind.cmake'; did you mean 'Mine.cmake'?"],
        ),
        (
            "string(TOLOWER MORE f)\nadd_subdirectory(${f}/x)\ninclude(${f}/x.cmake)",
            [
                f"4: add_subdirectory: {UNKNOWN} '${{f}}/x'; write it out",
                f"5: include: {UNKNOWN} '${{f}}/x.cmake'; write it out",
            ],
        ),
        (
            "install(PROGRAMS top.py DESTINATION $<IF:1,lib/yard,lib/none>)",
            [f"3: install: {UNKNOWN} '$<IF:1,lib/yard,lib/none>'; write it out"],
        ),
        (
            "install(FILES top.py TYPE SHARE)",
            [
                "3: install: unknown TYPE 'SHARE'; write one of BIN, SBIN, LIB, INCLUDE, SYSCONF, "
                "SHAREDSTATE, LOCALSTATE, RUNSTATE, DATA, INFO, LOCALE, MAN, DOC"
            ],
        ),
        ("install(FILES top.py)", ["3: install: has no DESTINATION; add one"]),
    ],
)
def test_what_cmake_refuses_is_said(folder: Path, text: str, expected: list[str]) -> None:
    listing = read(folder, text)
    assert messages(listing) == expected
    assert notes(listing) == []


@pytest.mark.parametrize(
    "text",
    [
        # Only CMake decides these conditions.
        "if(WIN32)\ninstall(FILES gone.py DESTINATION share/yard)\nadd_subdirectory(gone)\nendif()",
        "if(WIN32)\nreturn()\nendif()\ninstall(FILES gone.py DESTINATION share/yard)",
        "set(n top.py)\nif(WIN32)\nset(n gone.py)\nendif()\n"
        "install(FILES ${n} DESTINATION share/yard)",
        "if(WIN32)\nlist(APPEND n gone)\nendif()\nset(all ${n})\nforeach(each ${all})\n"
        "install(DIRECTORY ${each} DESTINATION share/yard)\nendforeach()",
        "while(NOT DONE)\ninstall(FILES gone.py DESTINATION share/yard)\nendwhile()",
        "if(BUILD_TESTING)\nadd_subdirectory(test)\nendif()",
        # Modules of CMake, and files of other packages.
        "include(CTest)\ninclude(GNUInstallDirs)\ninclude(gone.cmake OPTIONAL)",
        "find_package(ros2)\ninclude(${ros2_DIR}/gone.cmake)\ninclude($ENV{HOME}/gone.cmake)",
        # What the build makes, where no program reads it, and what is compiled.
        "configure_file(a.in a.h)\ninstall(FILES ${PROJECT_BINARY_DIR}/a.h DESTINATION include)",
        "install(FILES ${CMAKE_CURRENT_BINARY_DIR}/a.cmake DESTINATION share/yard/cmake)",
        "install(DIRECTORY include/ DESTINATION include)\ninstall(FILES a.so DESTINATION lib)",
        "install(PROGRAMS $<TARGET_FILE:talker> DESTINATION lib/yard)",
        'install(CODE "message(STATUS \\"done\\")")',
        "install(FILES ${CMAKE_CURRENT_BINARY_DIR}/a.py DESTINATION include)",
    ],
)
def test_a_package_that_works_has_no_faults(folder: Path, text: str) -> None:
    listing = read(folder, text)
    assert messages(listing) == []
    assert notes(listing) == []


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "configure_file(top.py ${CMAKE_CURRENT_SOURCE_DIR}/made.py)\n"
            "install(FILES made.py DESTINATION share/yard)",
            f"4: install: no file 'made.py'; {MISSING}, unless the build makes it",
        ),
        (
            "install(DIRECTORY made DESTINATION share/yard)\n"
            "add_custom_target(maps COMMAND make_maps)",
            f"3: install: no folder 'made'; {MISSING}, unless the build makes it",
        ),
        (
            "install(FILES /nowhere/at/all.yaml DESTINATION share/yard)",
            f"3: install: no file '/nowhere/at/all.yaml'; {MISSING}, unless the build makes it",
        ),
        (
            "if(WIN32)\ninstall(FILES ${what} DESTINATION share/yard)\nendif()",
            f"4: install: {UNKNOWN} '${{what}}'; write it out",
        ),
        ("install(SCRIPT more/run.cmake)", f"3: install: SCRIPT {NOT_RUN}"),
        ('install(CODE "execute_process(COMMAND ln)")', f"3: install: CODE {NOT_RUN}"),
        ("file(COPY top.py DESTINATION ${CMAKE_INSTALL_PREFIX})", f"3: file: COPY {NOT_RUN}"),
    ],
)
def test_what_is_doubtful_is_a_note(folder: Path, text: str, expected: str) -> None:
    listing = read(folder, text)
    assert messages(listing) == []
    assert notes(listing) == [expected]


def test_links_are_installed_with_what_they_lead_to(folder: Path) -> None:
    (folder / "launch/linked").symlink_to("sub")
    (folder / "launch/round").symlink_to("../launch")
    (folder / "launch/link.py").symlink_to("a.py")
    (folder / "launch/lost.py").symlink_to("gone.py")
    listing = read(
        folder, 'install(DIRECTORY launch/ DESTINATION share FILES_MATCHING PATTERN "[acl]*.py")'
    )
    found = cmakelists.installed(listing, folder.parent)
    assert set(found) >= {"share/a.py", "share/link.py", "share/linked/c.py", "share/sub/c.py"}
    assert "share/lost.py" not in found
    assert len(found) < 20


def test_files_outside_of_the_site_are_named(folder: Path) -> None:
    (folder.parent / "far.yaml").write_text("")
    listing = read(folder, "install(FILES ../far.yaml top.py DESTINATION share/yard)")
    assert list(cmakelists.installed(listing, folder)) == ["share/yard/top.py"]
    assert [note.message for note in cmakelists.outside(listing, folder)] == [
        f"'{folder}/../far.yaml' is outside the folder of site.yaml"
    ]


@pytest.mark.parametrize(
    "text",
    [
        "include({0})",
        "include({0}.cmake)",
        "add_subdirectory({0})",
        "install(FILES {0} DESTINATION share/yard)",
        "install(DIRECTORY {0}/ DESTINATION share/yard)",
        "set(CMAKE_MODULE_PATH {0})\ninclude(a)",
        "install(DIRECTORY / DESTINATION share/yard)",
        "install(SCRIPT {0})",
        "install(FILES a TYPE)",
        "install()",
    ],
)
def test_impossible_names_are_missing(folder: Path, text: str) -> None:
    listing = read(folder, text.format("x" * 300))
    assert cmakelists.installed(listing, folder.parent) == {}
