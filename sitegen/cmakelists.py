"""Turn a CMakeLists.txt into the names of what it builds."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

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
INCLUDES = ("add_subdirectory", "include")
AFTER_INTERFACES = ("DEPENDENCIES", "LIBRARY_NAME", "SKIP_INSTALL", "ADD_LINTER_TESTS")


@dataclass
class Listing:
    """What was found so far; `executables` is None where only CMake can tell their names.

    `sources` has the files of executables, relative to the file that names them, the package's own.
    """

    executables: list[str] | None = field(default_factory=list)
    interfaces: list[str] = field(default_factory=list)
    variables: dict[str, list[str]] = field(default_factory=dict)
    sources: dict[str, list[str]] = field(default_factory=dict)

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
