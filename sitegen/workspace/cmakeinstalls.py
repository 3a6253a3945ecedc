"""Read the install() commands of CMake, and find the files that they install."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from sitegen.errors import Location
from sitegen.workspace.cmakepatterns import Rule, rule
from sitegen.workspace.presence import is_folder

COPIED = ("FILES", "PROGRAMS")
KINDS = (*COPIED, "DIRECTORY")
EXPRESSIONS = ("PATTERN", "REGEX")
# The arguments of install() by the number of values that follow them.
NO_VALUE = {
    *("OPTIONAL", "EXCLUDE_FROM_ALL", "USE_SOURCE_PERMISSIONS", "MESSAGE_NEVER", "FILES_MATCHING"),
}
ONE_VALUE = {"DESTINATION", "TYPE", "COMPONENT", "RENAME"}
VALUES = {"PERMISSIONS", "FILE_PERMISSIONS", "DIRECTORY_PERMISSIONS", "CONFIGURATIONS"}
# What TYPE may be, apart from the names of these folders in GNUInstallDirs.
TYPES = (
    *("BIN", "SBIN", "LIB", "INCLUDE", "SYSCONF", "SHAREDSTATE", "LOCALSTATE", "RUNSTATE"),
    *("DATA", "INFO", "LOCALE", "MAN", "DOC"),
)
# The configuration that programs are built in.
CONFIGURATION = "release"
# Folders with nothing that a program reads: libraries, headers, documentation, files for CMake.
DEVELOPMENT = {"include", "bin", "sbin"}
DEVELOPMENT_BELOW = {"cmake", "doc", "info", "locale", "man", "pkgconfig"}


@dataclass(frozen=True)
class Install:
    """Files or folders that are installed unchanged.

    `names` are absolute paths, as written, and `destination` is below the prefix. `needed` says
    whether CMake surely fails without these files.
    """

    kind: str
    names: tuple[str, ...]
    destination: str
    location: Location
    rename: str = ""
    rules: tuple[Rule, ...] = ()
    only_matching: bool = False
    needed: bool = True

    def files(self, root: Path) -> Iterator[tuple[str, Path]]:
        """Yield the path of each file below the prefix, and the file, which is below `root`."""
        for name in self.names:
            last = name.rpartition("/")[2]
            if self.kind in COPIED:
                found = [(self.rename or last, name)]
            else:
                # A folder is installed with its name, or without it if it ends in a slash.
                found = [*self._below(name.rstrip("/") or "/", last or ".", root)]
            for path, file in found:
                yield posixpath.normpath(posixpath.join(self.destination, path)), Path(file)

    def missing(self) -> Iterator[str]:
        """Yield the names of what is neither there nor excluded."""
        for name in self.names:
            if not os.path.lexists(name) and not self._skips(name.rstrip("/")):
                yield name

    def _below(self, top: str, to: str, root: Path) -> Iterator[tuple[str, str]]:
        inside = Path(top).resolve().is_relative_to(root.resolve())
        waiting = [(top, to, 0)] if inside and is_folder(top) else []
        while waiting:
            path, to, links = waiting.pop()
            if self._skips(path):
                continue
            if not is_folder(path):
                yield to, path
                continue
            if path != top and Path(path).is_symlink():
                links += 1
                # Links in linked folders may lead to each other.
                if links > 1 or not Path(path).resolve().is_relative_to(root.resolve()):
                    continue
            waiting += ((f"{path}/{name}", f"{to}/{name}", links) for name in _names(path))

    def _skips(self, path: str) -> bool:
        matches = [rule for rule in self.rules if rule.expression.search(path)]
        if not matches and self.only_matching:
            return not is_folder(path)
        return any(rule.excludes for rule in matches)


@dataclass
class Arguments:
    """The arguments of an install() command: its names, its options and its rules.

    `fault` says why CMake refuses them.
    """

    kind: str
    options: dict[str, list[str]] = field(default_factory=dict)
    rules: list[Rule] = field(default_factory=list)
    fault: str = ""

    @classmethod
    def of(cls, words: Sequence[str]) -> Arguments:
        """Return the arguments of an install() command of one of KINDS."""
        found, key, expression = cls(words[0], {words[0]: []}), words[0], ""
        repeated = {words[0]} if words[0] in COPIED else set[str]()
        try:
            for word in words[1:]:
                if word in EXPRESSIONS:
                    key = expression = word
                elif word == "EXCLUDE" and found.rules:
                    found.rules[-1] = found.rules[-1]._replace(excludes=True)
                    key = ""
                elif word in NO_VALUE | ONE_VALUE | VALUES | repeated:
                    key = word
                    found.options.setdefault(word, [])
                elif key in EXPRESSIONS:
                    found.rules.append(rule(word, expression))
                    key = ""
                elif not key or key in NO_VALUE or (key in ONE_VALUE and found.options[key]):
                    found.fault = found.fault or f"unknown argument '{word}'; remove it"
                else:
                    found.options[key].append(word)
        except ValueError as error:
            found.fault = str(error)
        return found

    @property
    def names(self) -> list[str]:
        """The files or folders to install."""
        return self.options[self.kind]

    @property
    def rename(self) -> str:
        """The new name of the only file, if it gets one."""
        return "".join(self.options.get("RENAME", []))

    @property
    def by_default(self) -> bool:
        """Whether an installation without options includes the files."""
        configurations = self.options.get("CONFIGURATIONS")
        chosen = configurations is None or CONFIGURATION in map(str.lower, configurations)
        return chosen and "EXCLUDE_FROM_ALL" not in self.options

    def destination(self, variables: Mapping[str, list[str]]) -> str:
        """Return the folder to install to. Raises: ValueError, if CMake refuses the arguments."""
        given, types = self.options.get("DESTINATION", []), self.options.get("TYPE", [])
        if self.fault:
            raise ValueError(self.fault)
        if given and types:
            raise ValueError("has both TYPE and DESTINATION; remove one")
        if self.rename and len(self.names) > 1:
            raise ValueError("RENAME is for one file; install the others with another command")
        if given:
            return given[0]
        if not types:
            raise ValueError("has no DESTINATION; add one")
        if types[0] not in TYPES:
            raise ValueError(f"unknown TYPE '{types[0]}'; write one of {', '.join(TYPES)}")
        return "".join(variables[f"CMAKE_INSTALL_{types[0]}DIR"])


def of_interest(destination: str) -> bool:
    """Return whether programs may read what is installed to `destination`."""
    first, *below = destination.split("/")
    if first in DEVELOPMENT or destination == "lib":
        return False
    return not DEVELOPMENT_BELOW.intersection(below)


def below_prefix(destination: str, prefix: str) -> str | None:
    """Return a destination relative to the prefix; None if it is outside."""
    path = posixpath.normpath(posixpath.join(prefix, destination))
    if path == prefix:
        return "."
    return path.removeprefix(f"{prefix}/") if path.startswith(f"{prefix}/") else None


def unescaped(word: str) -> str:
    """Return an argument with its escape sequences replaced."""
    control = {"n": "\n", "r": "\r", "t": "\t"}
    return re.sub(r"\\(.)", lambda match: control.get(match[1], match[1]), word, flags=re.DOTALL)


def _names(folder: str) -> list[str]:
    try:
        found = sorted((path.name for path in Path(folder).iterdir()), reverse=True)
    except OSError:
        return []
    return [name for name in found if name != "__pycache__"]
