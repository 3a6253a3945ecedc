"""Evaluate CMake files as far as that is possible without CMake."""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from sitegen.errors import Location

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
VARIABLE = re.compile(r"\$\{(\w+)\}")
INCLUDES = ("add_subdirectory", "include")
# Commands that stand for other commands, or for none.
BLOCKS = ("function", "macro", "foreach")
# Commands that set variables to values that only CMake knows.
SETS = ("cmake_path", "execute_process", "file", "get_filename_component", "list", "math", "string")
DEEPEST, LONGEST = 20, 1000
TRUE = ("1", "ON", "YES", "TRUE", "Y")

PREFIX = "/prefix"
# The folders of an installation, as GNUInstallDirs and ament set them.
FOLDERS = {
    "BINDIR": "bin",
    "DATADIR": "share",
    "DATAROOTDIR": "share",
    "INCLUDEDIR": "include",
    "LIBDIR": "lib",
    "LIBEXECDIR": "libexec",
    "SYSCONFDIR": "etc",
}


class Command(NamedTuple):
    """The name in lower case, and the arguments as written."""

    name: str
    words: list[str]
    location: Location


@dataclass(frozen=True)
class Function:
    """A function, or a macro, which shares the variables of its caller."""

    parameters: Sequence[str]
    body: Sequence[Command]
    scoped: bool


@dataclass
class Script:
    """The known variables at one point of a script."""

    variables: dict[str, list[str]]
    # The folder of the current CMakeLists.txt, and the current command.
    folder: Path
    location: Location
    _functions: dict[str, Function] = field(default_factory=dict)
    # Variables whose values depend on conditions, and the number of conditions around a command.
    _unsure: set[str] = field(default_factory=set)
    _conditions: int = 0
    # The values of options. Builds for the browser have no tests.
    _options: dict[str, bool] = field(default_factory=lambda: {"BUILD_TESTING": False})

    _seen: set[Path] = field(default_factory=set)

    @classmethod
    def of(cls, file: Path, package: str) -> Script:
        """Return the script of the CMakeLists.txt of a package."""
        folder = file.parent.resolve()
        here = [folder.as_posix()]
        variables = {
            "PROJECT_NAME": [package],
            "PYTHON_INSTALL_DIR": ["python"],
            "CMAKE_INSTALL_PREFIX": [PREFIX],
            **dict.fromkeys(("CMAKE_SOURCE_DIR", "PROJECT_SOURCE_DIR"), here),
            **dict.fromkeys(("CMAKE_CURRENT_SOURCE_DIR", "CMAKE_CURRENT_LIST_DIR"), here),
            **{f"CMAKE_INSTALL_{name}": [path] for name, path in FOLDERS.items()},
            **{f"CMAKE_INSTALL_FULL_{n}": [f"{PREFIX}/{path}"] for n, path in FOLDERS.items()},
        }
        return cls(variables, folder, Location(file, 1))

    def read(self, file: Path, depth: int = 0) -> Iterator[Command]:
        """Yield the commands of a file, and of the files it includes; each file is read once."""
        try:
            real = file.resolve(strict=True)
            text = real.read_text(encoding="utf-8-sig", errors="replace")
        except (OSError, RuntimeError, ValueError):
            # CMake looks for modules in more folders, and reports those that it does not find.
            return
        if real not in self._seen:
            self._seen.add(real)
            yield from self.run(_parse(text, file), depth)

    def run(self, commands: Iterable[Command], depth: int = 0) -> Iterator[Command]:
        """Yield the commands that are not control flow, in order.

        A call of a function is replaced by the commands in it. Both branches of a condition are
        yielded, except for those of options, which have their default values.
        """
        rest = iter(commands)
        for command in rest:
            name, words, self.location = command
            if name in BLOCKS:
                yield from self._block(name, words, list(_until(f"end{name}", name, rest)), depth)
            elif name == "if" and (value := self._decided(words)) is not None:
                branch = _branch(_until("endif", "if", rest), first=value)
                yield from self.run(branch, depth)
            elif name in self._functions and depth < DEEPEST:
                yield from self._call(self._functions[name], words, depth)
            elif name in INCLUDES and words:
                yield Command(name, self.values(words), self.location)
                yield from self._include(name, self.values(words[:1]), depth)
            else:
                self._conditions += (name == "if") - (name == "endif")
                self._set(name, words)
                yield command

    def _include(self, name: str, given: list[str], depth: int) -> Iterator[Command]:
        path = self.folder / "".join(given[:1])
        before, folder = self.variables, self.folder
        if depth >= DEEPEST or "$" in str(path):
            return
        if name == "add_subdirectory":
            # Unlike an included file, it has variables of its own.
            self.folder, self.variables = path, dict(before)
            path /= "CMakeLists.txt"
            self.variables["CMAKE_CURRENT_SOURCE_DIR"] = [self.folder.as_posix()]
        outer = self.variables["CMAKE_CURRENT_LIST_DIR"]
        self.variables["CMAKE_CURRENT_LIST_DIR"] = [path.parent.as_posix()]
        yield from self.read(path, depth + 1)
        self.variables["CMAKE_CURRENT_LIST_DIR"] = outer
        if name == "add_subdirectory":
            self.folder, self.variables = folder, before

    def values(self, words: Iterable[str]) -> list[str]:
        """Replace variables by their values; unknown variables are left in place."""
        found: list[str] = []
        for word in words:
            alone = VARIABLE.fullmatch(word)
            if alone:
                found += self.variables.get(alone[1], [word])
            else:
                found += VARIABLE.sub(self._one, word).split(";")
        return found

    @property
    def unconditional(self) -> bool:
        """Whether the current command is outside of all conditions, except for decided ones."""
        return not self._conditions

    def surely(self, word: str) -> str | None:
        """Return the value of a word; None if only CMake can tell."""
        text = "".join(self.values([word]))
        unsure = "$" in text or self._unsure.intersection(VARIABLE.findall(word))
        return None if unsure else text

    def _one(self, match: re.Match[str]) -> str:
        values = self.variables.get(match[1])
        return ";".join(values) if values is not None else match[0]

    def _decided(self, words: list[str]) -> bool | None:
        """Return the value of a condition that is an option; None for any other condition."""
        *before, name = words or [""]
        if before not in ([], ["NOT"]) or name not in self._options:
            return None
        return self._options[name] is (not before)

    def _set(self, name: str, words: list[str]) -> None:
        variable, values = (words or [""])[0], list[str]()
        if name == "option" and words:
            on = words[2:3] and words[2].upper() in TRUE
            self._options.setdefault(variable, bool(on))
            return
        if name == "project" and words:
            variable, values = "PROJECT_NAME", words[:1]
            here = [self.folder.as_posix()]
            self.variables |= {"PROJECT_SOURCE_DIR": here, f"{words[0]}_SOURCE_DIR": here}
        elif name == "set" and words:
            ends = (n for n, word in enumerate(words) if word in ("CACHE", "PARENT_SCOPE"))
            end = next(ends, len(words))
            values = self.values(words[1:end])
        elif name == "list" and words[:1] == ["APPEND"] and len(words) > 1:
            variable = words[1]
            values = [*self.variables.get(variable, []), *self.values(words[2:])]
        elif name == "file" and (words or [""])[0] in ("GLOB", "GLOB_RECURSE") and len(words) > 2:
            variable, values = words[1], self._glob(words)
        else:
            for word in words if name in SETS else ():
                self.variables.pop(word, None)
            return
        self.variables[variable] = values
        self._options.pop(variable, None)
        (self._unsure.add if self._conditions else self._unsure.discard)(variable)

    def _glob(self, words: list[str]) -> list[str]:
        """Return the files that file(GLOB) finds, or the pattern if only CMake knows it."""
        base, given = None, self.values(words[2:])
        patterns, rest = list[str](), iter(given)
        for word in rest:
            if word == "RELATIVE":
                base = next(rest, "")
            elif word == "LIST_DIRECTORIES":
                next(rest, "")
            elif word != "CONFIGURE_DEPENDS":
                patterns.append(word)
        if any("$" in word for word in given):
            return ["".join(word for word in given if "$" in word)]
        found = set[Path]()
        for pattern in patterns:
            # An absolute pattern begins with the folder of the package.
            below = os.path.relpath(self.folder / pattern, self.folder)
            if words[0] == "GLOB_RECURSE":
                below = str(PurePosixPath(below).parent / "**" / PurePosixPath(below).name)
            names = glob.glob(below, root_dir=self.folder, recursive=True)  # noqa: PTH207
            found |= {Path(os.path.normpath(self.folder / name)) for name in names}
        files = sorted(path for path in found if path.is_file())
        return [os.path.relpath(file, base) if base else file.as_posix() for file in files]

    def _block(
        self, name: str, words: list[str], body: list[Command], depth: int
    ) -> Iterator[Command]:
        if not words:
            return
        if name != "foreach":
            self._functions[words[0].lower()] = Function(words[1:], body, name == "function")
            return
        for item in self._items(words[1:])[:LONGEST] if depth < DEEPEST else []:
            self.variables[words[0]] = [item]
            yield from self.run(body, depth + 1)

    def _items(self, words: list[str]) -> list[str]:
        """Return the items of a loop, given the arguments after its variable."""
        if words[:1] == ["RANGE"]:
            numbers = [int(word) for word in self.values(words[1:]) if word.isdigit()]
            first, last, step = (*([0] if len(numbers) == 1 else []), *numbers, 1, 1)[:3]
            counted = range(first, last + 1, step or 1) if numbers else range(0)
            return [str(number) for number in counted[:LONGEST]]
        if words[:1] != ["IN"]:
            return self.values(words)
        items, lists = list[str](), False
        for word in words[1:]:
            if word in ("ITEMS", "LISTS"):
                lists = word == "LISTS"
            else:
                items += self.values([f"${{{word}}}" if lists else word])
        return items

    def _call(self, function: Function, words: list[str], depth: int) -> Iterator[Command]:
        given = self.values(words)
        before = dict(self.variables)
        self.variables |= {n: [v] for n, v in zip(function.parameters, given, strict=False)}
        self.variables |= {f"ARGV{number}": [value] for number, value in enumerate(given)}
        others = given[len(function.parameters) :]
        self.variables |= {"ARGV": given, "ARGN": others, "ARGC": [str(len(given))]}
        yield from self.run(function.body, depth + 1)
        if function.scoped:
            self.variables = before


def _until(end: str, begin: str, commands: Iterator[Command]) -> Iterator[Command]:
    """Yield the commands up to the end of the current block."""
    depth = 1
    for command in commands:
        depth += (command.name == begin) - (command.name == end)
        if depth == 0:
            return
        yield command


def _branch(block: Iterator[Command], *, first: bool) -> list[Command]:
    """Return the commands of an if() block up to else(), or what is left of it without them."""
    found, depth, other = list[Command](), 0, False
    for command in block:
        name, words, location = command
        if depth == 0 and name in ("else", "elseif") and not other:
            other = True
            if name == "elseif" and not first:
                return [Command("if", words, location), *block, Command("endif", [], location)]
            continue
        depth += (name == "if") - (name == "endif")
        if other != first:
            found.append(command)
    return found


def _parse(text: str, file: Path) -> Iterator[Command]:
    name, words, depth, line = "", list[str](), 0, 1
    for token in TOKEN.finditer(text):
        word = next((token[kind] for kind in ("word", "quoted", "bracket") if token[kind]), "")
        if token["paren"] == "(":
            depth += 1
        elif token["paren"] == ")":
            depth -= 1
            if depth == 0:
                yield Command(name, words, Location(file, line))
                name, words = "", []
        elif word and depth == 0:
            name, line = word.lower(), text.count("\n", 0, token.start()) + 1
        elif word:
            words.append(word)
