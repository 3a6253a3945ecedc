"""Turn a CMakeLists.txt into the names of what it builds."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

TOKEN = re.compile(
    r"""
      \#\[(?P<remark>=*)\[.*?\](?P=remark)\]       # bracket comment
    | \#[^\n]*                                     # comment
    | \[(?P<level>=*)\[(?P<bracket>.*?)\](?P=level)\]
    | "(?P<quoted>(?:[^"\\]|\\.)*)"
    | (?P<paren>[()])
    | (?P<word>(?:[^\s()\#"\\;]|\\.)+)
    """,
    re.VERBOSE | re.DOTALL,
)
HERE = re.compile(r"\$\{CMAKE_(CURRENT_)?(SOURCE|LIST)_DIR\}")
VARIABLE = re.compile(r"\$\{(\w+)\}")
INTERFACE = (".msg", ".srv", ".action", ".idl")
ADDS_EXECUTABLE = ("add_executable", "ament_auto_add_executable")
COPIED = ("FILES", "PROGRAMS")
INCLUDES = ("add_subdirectory", "include")
AFTER_INTERFACES = ("DEPENDENCIES", "LIBRARY_NAME", "SKIP_INSTALL", "ADD_LINTER_TESTS")


@dataclass(frozen=True)
class Install:
    """Files or folders that are installed as they are, relative to the package."""

    kind: str
    names: tuple[str, ...]
    destination: str
    rename: str = ""

    def files(self, folder: Path) -> Iterator[tuple[str, Path]]:
        """Yield where each file goes, and where it is in the package `folder`."""
        for name in self.names:
            path = folder / name
            if self.kind in COPIED:
                yield f"{self.destination}/{self.rename or path.name}", path
                continue
            # As CMake has it: a folder goes with its name, or without it if that ends in a slash.
            top = path if name.endswith("/") else path.parent
            for file in _below(path):
                yield f"{self.destination}/{file.relative_to(top).as_posix()}", file


def _below(folder: Path) -> Iterable[Path]:
    return sorted(file for file in folder.rglob("*") if "__pycache__" not in file.parts)


@dataclass
class Listing:
    """What was found so far; `executables` is None where only CMake can tell their names.

    `sources` has the files of executables, relative to the file that names them, the package's own.
    `installs` has what is installed as it is: the places below the prefix, and what goes there.
    `finds` has the packages that are looked for, but for those that may be missing.
    """

    executables: list[str] | None = field(default_factory=list)
    interfaces: list[str] = field(default_factory=list)
    variables: dict[str, list[str]] = field(default_factory=dict)
    sources: dict[str, list[str]] = field(default_factory=dict)
    installs: list[Install] = field(default_factory=list)
    finds: list[str] = field(default_factory=list)

    def add(self, name: str, words: list[str]) -> None:
        """Take in one command with its arguments."""
        if name == "project" and words:
            self.variables["PROJECT_NAME"] = [words[0]]
        elif name == "set" and words:
            self.variables[words[0]] = self._expand(words[1:])
        elif name == "list" and words[:1] == ["APPEND"] and len(words) > 1:
            self.variables.setdefault(words[1], []).extend(self._expand(words[2:]))
        elif name in ADDS_EXECUTABLE and words and not {"IMPORTED", "ALIAS"} & set(words[1:3]):
            self._add_executable(words[0])
            self._add_sources(words)
        elif name == "rclcpp_components_register_node" and "EXECUTABLE" in words[:-1]:
            self._add_executable(words[words.index("EXECUTABLE") + 1])
        elif name in INCLUDES and "$" in "".join(words[:1]):
            self.executables = None
        elif name == "rosidl_generate_interfaces":
            self._add_interfaces(words[1:])
        elif name == "find_package" and ("QUIET" not in words or "REQUIRED" in words):
            self.finds += self._expand(words[:1])
        elif name == "install":
            self._add_install(self._expand(words))
        elif name == "ament_python_install_package":
            self._add_python(self._expand(words))

    def _add_install(self, words: list[str]) -> None:
        kind = words[0] if words else ""
        if kind not in (*COPIED, "DIRECTORY") or "DESTINATION" not in words[:-1]:
            return
        at = words.index("DESTINATION")
        names = [word for word in words[1:at] if word not in ("OPTIONAL", "USE_SOURCE_PERMISSIONS")]
        rename = words[words.index("RENAME") + 1] if "RENAME" in words[:-1] else ""
        self.installs.append(Install(kind, tuple(names), words[at + 1].strip("/"), rename))

    def _add_python(self, words: list[str]) -> None:
        if words:
            given = words.index("PACKAGE_DIR") + 1 if "PACKAGE_DIR" in words[:-1] else 0
            self.installs.append(Install("DIRECTORY", (f"{words[given]}/",), f"python/{words[0]}"))

    def _add_executable(self, word: str) -> None:
        project = self.variables.get("PROJECT_NAME", [""])[0]
        name = word.replace("${PROJECT_NAME}", project)
        if "$" in name:
            self.executables = None
        elif self.executables is not None and name not in self.executables:
            self.executables.append(name)

    def _add_sources(self, words: list[str]) -> None:
        for name, *files in filter(None, [self._expand(words)]):
            self.sources[name] = [word for word in files if "." in word and "$" not in word]

    def _add_interfaces(self, words: list[str]) -> None:
        end = next((i for i, word in enumerate(words) if word in AFTER_INTERFACES), len(words))
        self.interfaces += [
            word
            for word in self._expand(words[:end])
            if word.endswith(INTERFACE) and "$" not in word
        ]

    def _expand(self, words: list[str]) -> list[str]:
        found: list[str] = []
        for word in words:
            alone = VARIABLE.fullmatch(word)
            if alone:
                found += self.variables.get(alone[1], [])
            else:
                found += VARIABLE.sub(self._one, word).split(";")
        return found

    def _one(self, match: re.Match[str]) -> str:
        values = self.variables.get(match[1])
        return ";".join(values) if values is not None else match[0]


def installed(listing: Listing, folder: Path) -> dict[str, Path]:
    """Return the files of the package `folder` that are installed as they are, by their place."""
    found: dict[str, Path] = {}
    for install in listing.installs:
        for place, file in install.files(folder):
            parts = PurePosixPath(place).parts
            inside = file.resolve().is_relative_to(folder.resolve()) and ".." not in parts
            if file.is_file() and inside and "$" not in place:
                found[PurePosixPath(place).as_posix()] = file
    return found


def read(file: Path, package: str) -> Listing:
    """Return what the CMakeLists.txt of `package` builds, the files that it includes too."""
    listing = Listing(variables={"PROJECT_NAME": [package]})
    for name, words in _commands(file, set()):
        listing.add(name, words)
    return listing


def _commands(path: Path, seen: set[Path]) -> Iterator[tuple[str, list[str]]]:
    try:
        file = (path / "CMakeLists.txt" if path.is_dir() else path).resolve(strict=True)
        text = file.read_text(encoding="utf-8", errors="replace")
    except (OSError, RuntimeError, ValueError):
        # CMake looks for modules in more places than here, and says what it does not find.
        return
    if file in seen:
        return
    seen.add(file)
    for name, words in _parse(text):
        if name in INCLUDES and words:
            words[0] = HERE.sub(lambda _: file.parent.as_posix(), words[0])
        yield name, words
        if name in INCLUDES and words:
            yield from _commands(file.parent / words[0], seen)


def _parse(text: str) -> Iterator[tuple[str, list[str]]]:
    name, words, depth = "", list[str](), 0
    for token in TOKEN.finditer(text):
        word = next((token[kind] for kind in ("word", "quoted", "bracket") if token[kind]), "")
        if token["paren"] == "(":
            depth += 1
        elif token["paren"] == ")":
            depth -= 1
            if depth == 0:
                yield name, words
                name, words = "", []
        elif word and depth == 0:
            name = word.lower()
        elif word:
            words.append(word)
