"""Find the files that CMake needs and that neither the package has nor the build makes."""

from __future__ import annotations

import difflib
import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from sitegen.model import Fault
from sitegen.workspace.cmakeinstalls import COPIED, Install, of_interest
from sitegen.workspace.presence import exists, is_file, is_folder

# Commands that can make any file.
OPAQUE = {
    *("add_custom_command", "add_custom_target", "execute_process", "externalproject_add"),
    *("fetchcontent_makeavailable", "fetchcontent_populate", "try_run"),
}
# Commands that make no files in the package; any other one may.
PLAIN = {
    *("if", "elseif", "else", "endif", "while", "endwhile", "set", "unset", "list", "string"),
    *("math", "message", "option", "project", "install", "include", "mark_as_advanced"),
    *("add_executable", "add_library", "add_subdirectory", "add_test", "add_dependencies"),
    *("add_compile_options", "add_definitions", "add_compile_definitions", "enable_testing"),
    *("link_directories", "link_libraries", "pkg_check_modules"),
}
PLAIN_BEGINNINGS = (
    *("ament_", "cmake_", "end", "find_", "get_", "include_", "pluginlib_", "rclcpp_"),
    *("rosidl_", "set_", "target_"),
)
# Uses of file() that make none.
READS = {"READ", "STRINGS", "GLOB", "GLOB_RECURSE", "SIZE", "RELATIVE_PATH", "REAL_PATH", "REMOVE"}


def is_maker(name: str, words: Sequence[str]) -> bool:
    """Return whether a command may make files in the folder of the package."""
    if name == "file":
        return not READS.intersection(words[:1])
    return name not in PLAIN and not name.startswith(PLAIN_BEGINNINGS)


@dataclass
class Absent:
    """What commands need, until it is known what others make: `makers` are names and arguments."""

    makers: list[tuple[str, list[str]]] = field(default_factory=list)
    _wanted: list[tuple[Fault, Path, str]] = field(default_factory=list)

    def check(self, at: Fault, path: Path, *, certain: bool) -> None:
        """Check a path that is read where `at` says; nothing is wrong if it is not `certain`."""
        kind = "DIRECTORY" if at.key == "add_subdirectory" else "FILES"
        lists = kind == "FILES" or is_file(path / "CMakeLists.txt")
        if certain and not (exists(path) and lists):
            self._wanted.append((at, path, kind))

    def check_install(self, install: Install) -> None:
        """Check the names of an install() command."""
        if not install.needed or not of_interest(install.destination):
            return
        at = Fault(install.location, "install", "", not install.destination.startswith("share/"))
        kind = "FILES" if install.kind in COPIED else "DIRECTORY"
        wrong = [*install.missing(), *(name for name in install.names if _is_other(name, kind))]
        self._wanted += ((at, Path(name), kind) for name in wrong)

    def found(self, folder: Path) -> tuple[list[Fault], list[Fault]]:
        """Return what is missing in a package, and what is there only if the build makes it."""
        faults, notes = list[Fault](), list[Fault]()
        for at, path, kind in self._wanted:
            name = os.path.relpath(path, folder) if path.is_relative_to(folder) else str(path)
            message = _message(name, path, kind, at.key)
            if not path.is_relative_to(folder) or (not exists(path) and self._may_make(name)):
                notes.append(at._replace(message=f"{message}, unless the build makes it"))
            else:
                faults.append(at._replace(message=message))
        return faults, notes

    def _may_make(self, name: str) -> bool:
        parts = Path(name).parts
        return any(
            maker in OPAQUE or any(part in word for part in parts for word in words)
            for maker, words in self.makers
        )


def _is_other(name: str, kind: str) -> bool:
    """Return whether there is a file in place of a folder, or the reverse."""
    folder = is_folder(name)
    return folder if kind == "FILES" else exists(name) and not folder


def _message(name: str, path: Path, kind: str, key: str) -> str:
    if is_folder(path) and key == "add_subdirectory":
        return f"no CMakeLists.txt in '{name}'; add it, or remove this line"
    if is_folder(path):
        return f"'{name}' is a folder; write install(DIRECTORY …)"
    if exists(path):
        return f"'{name}' is a file; write install(FILES …)"
    what = "file" if kind == "FILES" else "folder"
    others = [each.name for each in _beside(path) if each.is_dir() == (kind == "DIRECTORY")]
    close = difflib.get_close_matches(path.name, others, n=1)
    hint = f"did you mean '{close[0]}'?" if close else "add it, or remove it from this command"
    return f"no {what} '{name}'; {hint}"


def _beside(path: Path) -> list[Path]:
    try:
        return sorted(path.parent.iterdir())
    except OSError:
        return []
