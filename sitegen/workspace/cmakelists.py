"""Read a CMakeLists.txt: the names of what it builds and installs."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from sitegen.errors import Location
from sitegen.workspace.cmakescript import INCLUDES, PREFIX, Script

INTERFACE = (".msg", ".srv", ".action", ".idl")
ADDS_EXECUTABLE = ("add_executable", "ament_auto_add_executable")
SETS_PROPERTIES = ("set_target_properties", "set_property")
# What ends the names of an install() command.
OPTIONS = {
    *("DESTINATION", "PERMISSIONS", "CONFIGURATIONS", "COMPONENT", "RENAME", "OPTIONAL", "TYPE"),
    *("EXCLUDE_FROM_ALL", "FILE_PERMISSIONS", "DIRECTORY_PERMISSIONS", "USE_SOURCE_PERMISSIONS"),
    *("MESSAGE_NEVER", "FILES_MATCHING", "PATTERN", "REGEX"),
}
AUTO = {"INSTALL_TO_PATH", "USE_SCOPED_HEADER_INSTALL_DIR", "SCOPED_HEADER_INSTALL_DIR"}
# Where nothing is that a program reads.
DEVELOPMENT = {"include", "bin", "$"}
COPIED = ("FILES", "PROGRAMS")
AFTER_INTERFACES = ("DEPENDENCIES", "LIBRARY_NAME", "SKIP_INSTALL", "ADD_LINTER_TESTS")


@dataclass(frozen=True)
class Install:
    """Files or folders that are installed unchanged; `names` are absolute paths."""

    kind: str
    names: tuple[str, ...]
    destination: str
    rename: str = ""

    def files(self, folder: Path) -> Iterator[tuple[str, Path]]:
        """Yield the destination of each file, and its path in the package `folder`."""
        for name in self.names:
            path = folder / name  # which may be absolute
            if self.kind in COPIED:
                yield f"{self.destination}/{self.rename or path.name}", path
                continue
            # The rule of CMake: a folder is installed with its name, or without it if it ends in a
            # slash.
            top = path if name.endswith("/") else path.parent
            for file in _below(path):
                yield f"{self.destination}/{file.relative_to(top).as_posix()}", file


def _below(folder: Path) -> Iterable[Path]:
    return sorted(file for file in folder.rglob("*") if "__pycache__" not in file.parts)


@dataclass
class Listing:
    """The result so far; `executables` is None if only CMake can tell their names.

    `sources` maps executables to source files, relative to the CMakeLists.txt of the package.
    `installs` maps paths below the prefix to what is installed there unchanged. `finds` has the
    packages that are not optional, `requires` those without which CMake fails; `plugins` has the
    packages for which plugins are described.
    """

    script: Script
    folder: Path
    executables: list[str] | None = field(default_factory=list)
    interfaces: list[str] = field(default_factory=list)
    sources: dict[str, list[str]] = field(default_factory=dict)
    installs: list[Install] = field(default_factory=list)
    finds: list[str] = field(default_factory=list)
    requires: list[str] = field(default_factory=list)
    plugins: list[str] = field(default_factory=list)
    # What is installed, but known to CMake only.
    fault: tuple[Location, str] | None = None

    def add(self, name: str, words: list[str]) -> None:
        """Process one command and its arguments."""
        if name in ADDS_EXECUTABLE and words and not {"IMPORTED", "ALIAS"} & set(words[1:3]):
            self._add_executable(words[0])
            self._add_sources(words)
        elif name in SETS_PROPERTIES and "OUTPUT_NAME" in words[:-1]:
            self._rename(words)
        elif name == "rclcpp_components_register_node" and "EXECUTABLE" in words[:-1]:
            self._add_executable(words[words.index("EXECUTABLE") + 1])
        elif name in INCLUDES and "$" in "".join(words[:1]):
            self.executables = None
        elif name == "rosidl_generate_interfaces":
            self._add_interfaces(words[1:])
        elif name == "find_package" and ("QUIET" not in words or "REQUIRED" in words):
            self.finds += self.script.values(words[:1])
            if "REQUIRED" in words and self.script.unconditional:
                self.requires += self.script.values(words[:1])
        elif name == "pluginlib_export_plugin_description_file":
            self.plugins += self.script.values(words[:1])
        elif name == "install":
            self._add_install(self.script.values(words))
        elif name == "ament_auto_package" and "INSTALL_TO_SHARE" in words:
            self._add_shared(self.script.values(words))
        elif name == "ament_python_install_package":
            self._add_python(self.script.values(words))

    def _add_install(self, words: list[str]) -> None:
        kind = words[0] if words else ""
        if kind not in (*COPIED, "DIRECTORY") or "DESTINATION" not in words[:-1]:
            return
        end = next(n for n, word in enumerate(words) if word in OPTIONS)
        destination = words[words.index("DESTINATION") + 1].removeprefix(f"{PREFIX}/").strip("/")
        rename = words[words.index("RENAME") + 1] if "RENAME" in words[:-1] else ""
        self._install(kind, words[1:end], destination, rename)

    def _add_shared(self, words: list[str]) -> None:
        """Process the folders that ament_auto_package() installs."""
        after = words[words.index("INSTALL_TO_SHARE") + 1 :]
        end = next((n for n, word in enumerate(after) if word in AUTO), len(after))
        share = f"share/{''.join(self.script.variables['PROJECT_NAME'])}"
        self._install("DIRECTORY", after[:end], share)

    def _install(self, kind: str, names: list[str], destination: str, rename: str = "") -> None:
        """Note what is installed; names are relative to the folder of the current script."""
        unknown = next((word for word in (*names, destination) if "$" in word), "")
        if unknown and destination.partition("/")[0] not in DEVELOPMENT and self.fault is None:
            what = f"install: sitegen does not know the value of '{unknown}'"
            self.fault = (self.script.location, f"{what}; write it out")
        known = [os.path.join(self.script.folder, name) for name in names if "$" not in name]  # noqa: PTH118
        self.installs.append(Install(kind, tuple(known), destination, rename))

    def _add_python(self, words: list[str]) -> None:
        if words:
            given = words.index("PACKAGE_DIR") + 1 if "PACKAGE_DIR" in words[:-1] else 0
            self._install("DIRECTORY", [f"{words[given]}/"], f"python/{words[0]}")

    def _add_executable(self, word: str) -> None:
        name = self.script.surely(word)
        if name is None:
            self.executables = None
        elif self.executables is not None and name not in self.executables:
            self.executables.append(name)

    def _rename(self, words: list[str]) -> None:
        """Process a property that gives the program of a target another name."""
        end = next(at for at, word in enumerate(words) if word in ("PROPERTY", "PROPERTIES"))
        name = self.script.surely(words[words.index("OUTPUT_NAME") + 1])
        for target in self.script.values(words[:end]):
            if self.executables is None or target not in self.executables:
                continue
            if name is None:
                self.executables = None
            else:
                self.executables[self.executables.index(target)] = name
                self.sources[name] = self.sources.pop(target, [])

    def _add_sources(self, words: list[str]) -> None:
        for name, *files in filter(None, [self.script.values(words)]):
            self.sources[name] = [
                self._below(word) for word in files if "." in word and "$" not in word
            ]

    def _below(self, word: str) -> str:
        """Return a name relative to the package if the script gives its whole path."""
        return word.removeprefix(f"{self.folder.as_posix()}/").removeprefix("./")

    def _add_interfaces(self, words: list[str]) -> None:
        end = next((i for i, word in enumerate(words) if word in AFTER_INTERFACES), len(words))
        self.interfaces += [
            self._below(word.replace(":", "/"))
            for word in self.script.values(words[:end])
            if word.endswith(INTERFACE) and "$" not in word
        ]


def installed(listing: Listing, folder: Path, root: Path) -> dict[str, Path]:
    """Return the files below `root` that the package `folder` installs unchanged, by path."""
    found: dict[str, Path] = {}
    for install in listing.installs:
        for path, file in install.files(folder):
            parts = PurePosixPath(path).parts
            inside = file.resolve().is_relative_to(root.resolve()) and ".." not in parts
            if file.is_file() and inside and "$" not in path:
                found[PurePosixPath(path).as_posix()] = file
    return found


def read(file: Path, package: str) -> Listing:
    """Return what the CMakeLists.txt of `package`, and the files that it includes, build."""
    script = Script.of(file, package)
    listing = Listing(script, script.folder)
    for name, words, _ in script.read(file):
        listing.add(name, words)
    return listing
