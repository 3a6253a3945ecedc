"""Evaluate CMake files as far as that is possible without CMake."""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from sitegen.errors import Location
from sitegen.workspace.cmakesyntax import Command, branch, parse, until
from sitegen.workspace.presence import is_file

VARIABLE = re.compile(r"\$\{(\w+)\}")
INCLUDES = ("add_subdirectory", "include")
# Commands that stand for other commands, or for none.
BLOCKS = ("function", "macro", "foreach")
JUMPS = ("return", "break", "continue")
CONDITIONS = ("if", "while")
# Commands that set variables to values that only CMake knows.
SETS = ("cmake_path", "execute_process", "file", "get_filename_component", "list", "math", "string")
# Uses of list() that only set their last argument.
READS = ("LENGTH", "GET", "JOIN", "SUBLIST", "FIND")
DEEPEST, LONGEST = 20, 1000
TRUE = ("1", "ON", "YES", "TRUE", "Y")
FALSE = ("0", "OFF", "NO", "FALSE", "N", "IGNORE", "NOTFOUND")

PREFIX = "/prefix"
# The folders of an installation, as GNUInstallDirs and ament set them.
FOLDERS = {
    "BINDIR": "bin",
    "DATADIR": "share",
    "DATAROOTDIR": "share",
    "INCLUDEDIR": "include",
    "INFODIR": "share/info",
    "LIBDIR": "lib",
    "LIBEXECDIR": "libexec",
    "LOCALEDIR": "share/locale",
    "LOCALSTATEDIR": "var",
    "MANDIR": "share/man",
    "RUNSTATEDIR": "var/run",
    "SBINDIR": "sbin",
    "SHAREDSTATEDIR": "com",
    "SYSCONFDIR": "etc",
}


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
    # The folder of the current CMakeLists.txt, whether it is installed, and the current command.
    folder: Path
    location: Location
    installed: bool = True
    # The cached variables that a package does not set itself.
    given: Mapping[str, str] = field(default_factory=dict)
    # Variables that the package sets to values that only CMake knows.
    computed: set[str] = field(default_factory=set)
    _functions: dict[str, Function] = field(default_factory=dict)
    # Variables whose values depend on conditions, and the number of conditions around a command.
    _unsure: set[str] = field(default_factory=set)
    _conditions: int = 0
    # The same around the current function or file, and the command that ends it.
    _outside: int = 0
    _jump: str = ""
    # What a function or folder sets in the scope of its caller.
    _returned: dict[str, list[str]] = field(default_factory=dict)
    # The values of options. Builds for the browser have no tests.
    _options: dict[str, bool] = field(default_factory=lambda: {"BUILD_TESTING": False})

    _seen: set[Path] = field(default_factory=set)

    @classmethod
    def of(cls, file: Path, package: str, given: Mapping[str, str]) -> Script:
        """Return the script of the CMakeLists.txt of a package, with the variables `given`."""
        folder = file.parent.resolve()
        here = [folder.as_posix()]
        folders = {**FOLDERS, "DOCDIR": f"share/doc/{package}"}
        variables = {
            "PROJECT_NAME": [package],
            "PYTHON_INSTALL_DIR": ["python"],
            "CMAKE_INSTALL_PREFIX": [PREFIX],
            **dict.fromkeys(("CMAKE_SOURCE_DIR", "PROJECT_SOURCE_DIR"), here),
            **dict.fromkeys(("CMAKE_CURRENT_SOURCE_DIR", "CMAKE_CURRENT_LIST_DIR"), here),
            **{f"CMAKE_INSTALL_{name}": [path] for name, path in folders.items()},
            **{f"CMAKE_INSTALL_FULL_{n}": [f"{PREFIX}/{path}"] for n, path in folders.items()},
            **{name: value.split(";") for name, value in given.items()},
        }
        script = cls(variables, folder, Location(file, 1), given=given)
        flags = {name: value.upper() for name, value in given.items()}
        script._options |= {
            n: value in TRUE for n, value in flags.items() if value in (*TRUE, *FALSE)
        }
        return script

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
            yield from self._scope(parse(text, file), depth)

    def run(self, commands: Iterable[Command], depth: int = 0) -> Iterator[Command]:
        """Yield the commands that are not control flow, in order.

        A call of a function is replaced by the commands in it. Both branches of a condition are
        yielded, except for those of options, which have their default values.
        """
        rest = iter(commands)
        for command in rest:
            if self._jump:
                return
            name, words, self.location = command
            if name in JUMPS and self._conditions == self._outside:
                self._jump = name
            elif name in BLOCKS:
                yield from self._block(name, words, list(until(f"end{name}", name, rest)), depth)
            elif name == "if" and (value := self._decided(words)) is not None:
                chosen = branch(until("endif", "if", rest), first=value)
                yield from self.run(chosen, depth)
            elif name in self._functions and depth < DEEPEST:
                yield from self._call(self._functions[name], words, depth)
            elif name in INCLUDES and words:
                yield command
                yield from self._include(name, self.values(words), depth)
            else:
                self._conditions += name in CONDITIONS
                self._conditions -= name in ("endif", "endwhile")
                # What follows a jump in a condition is conditional, too.
                self._conditions += name in JUMPS
                self._set(name, words)
                yield command

    def _scope(self, commands: Iterable[Command], depth: int) -> Iterator[Command]:
        """Yield the commands of a file or a function, which return() ends."""
        before = self._conditions, self._outside
        self._outside = self._conditions
        yield from self.run(commands, depth)
        self._conditions, self._outside = before
        self._jump = ""

    def module(self, given: str) -> Path:
        """Return the file that include() reads: a path, or the name of a module."""
        folders = self.variables.get("CMAKE_MODULE_PATH", [])
        paths = [self.folder / given, *(self.folder / each / f"{given}.cmake" for each in folders)]
        return next(filter(is_file, paths), paths[0])

    def _include(self, name: str, given: list[str], depth: int) -> Iterator[Command]:
        path = self.module("".join(given[:1]))
        before, folder, installed = self.variables, self.folder, self.installed
        returned = self._returned
        if depth >= DEEPEST or "$" in "".join(given[:1]):
            return
        if name == "add_subdirectory":
            # Unlike an included file, it has variables of its own.
            path = self.folder / "".join(given[:1])
            self.folder, self.variables, self._returned = path, dict(before), {}
            self.installed = installed and "EXCLUDE_FROM_ALL" not in given
            path /= "CMakeLists.txt"
            self.variables["CMAKE_CURRENT_SOURCE_DIR"] = [self.folder.as_posix()]
        outer = self.variables["CMAKE_CURRENT_LIST_DIR"]
        self.variables["CMAKE_CURRENT_LIST_DIR"] = [path.parent.as_posix()]
        yield from self.read(path, depth + 1)
        self.variables["CMAKE_CURRENT_LIST_DIR"] = outer
        if name == "add_subdirectory":
            self.folder, self.variables, self.installed = folder, before, installed
            self._leave(before, returned)

    def _leave(self, variables: dict[str, list[str]], returned: dict[str, list[str]]) -> None:
        """Go back to the `variables` of the caller, and set those that are returned to it."""
        self.variables, self._returned = variables | self._returned, returned

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

    def certain(self, words: Iterable[str]) -> bool:
        """Return whether no variable in `words` depends on a condition."""
        return not self._unsure.intersection(VARIABLE.findall(" ".join(words)))

    def surely(self, word: str) -> str | None:
        """Return the value of a word; None if only CMake can tell."""
        text = "".join(self.values([word]))
        return text if "$" not in text and self.certain([word]) else None

    def _one(self, match: re.Match[str]) -> str:
        values = self.variables.get(match[1])
        return ";".join(values) if values is not None else match[0]

    def _decided(self, words: list[str]) -> bool | None:
        """Return the value of a condition that is an option or a constant; None for others."""
        *before, name = words or [""]
        if before not in ([], ["NOT"]):
            return None
        constants = {**dict.fromkeys(TRUE, True), **dict.fromkeys(FALSE, False)}
        value = self._options.get(name, constants.get(name.upper()))
        return None if value is None else value is (not before)

    def _set(self, name: str, words: list[str]) -> None:
        variable, values = "".join(self.values(words[:1])), list[str]()
        if name == "option" and words:
            on = words[2:3] and words[2].upper() in TRUE
            self._options.setdefault(variable, bool(on))
            return
        if name == "project" and words:
            variable, values = "PROJECT_NAME", words[:1]
            here = [self.folder.as_posix()]
            self.variables |= {"PROJECT_SOURCE_DIR": here, f"{words[0]}_SOURCE_DIR": here}
        elif name == "set" and words:
            if variable in self.given and "CACHE" in words and words[-1] != "FORCE":
                return
            ends = (n for n, word in enumerate(words) if word in ("CACHE", "PARENT_SCOPE"))
            end = next(ends, len(words))
            values = self.values(words[1:end])
            if words[-1] == "PARENT_SCOPE":
                self._returned[variable] = values
                self._doubt(variable, words)
                return
        elif name == "unset" and words:
            values = []
        elif name == "list" and words[:1] == ["APPEND"] and len(words) > 1:
            variable = words[1]
            values = [*self.variables.get(variable, []), *self.values(words[2:])]
        elif name == "file" and (words or [""])[0] in ("GLOB", "GLOB_RECURSE") and len(words) > 2:
            variable, values = words[1], self._glob(words)
        else:
            read = name == "list" and words and words[0] in READS
            for word in words[-1 if read else 0 :] if name in SETS else ():
                self.variables.pop(word, None)
                self.computed.add(word)
            return
        self.variables[variable] = values
        self._options.pop(variable, None)
        self._doubt(variable, [*words, f"${{{variable}}}"] if name == "list" else words)

    def _doubt(self, variable: str, words: list[str]) -> None:
        """Note whether the value of a variable, which is made of `words`, is certain."""
        unsure = self._conditions or not self.certain(words)
        (self._unsure.add if unsure else self._unsure.discard)(variable)

    def _glob(self, words: list[str]) -> list[str]:
        """Return the files that file(GLOB) finds, or the pattern if only CMake knows it."""
        base, given = None, self.values(words[2:])
        patterns, rest = list[str](), iter(given)
        folders = words[0] == "GLOB"
        for word in rest:
            if word == "RELATIVE":
                base = next(rest, "")
            elif word == "LIST_DIRECTORIES":
                folders = next(rest, "").upper() in TRUE
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
            names = glob.glob(below, root_dir=self.folder, recursive=True, include_hidden=True)  # noqa: PTH207
            found |= {Path(os.path.normpath(self.folder / name)) for name in names}
        cache = "__pycache__"
        found = {path for path in found if cache not in path.parts and (folders or path.is_file())}
        files = sorted(found)
        return [os.path.relpath(file, base) if base else file.as_posix() for file in files]

    def _block(
        self, name: str, words: list[str], body: list[Command], depth: int
    ) -> Iterator[Command]:
        if not words:
            return
        if name != "foreach":
            self._functions[words[0].lower()] = Function(words[1:], body, name == "function")
            return
        lists = [f"${{{word}}}" for word in words[1:]]
        for item in self._items(words[1:])[:LONGEST] if depth < DEEPEST else []:
            if self._jump in ("return", "break"):
                break
            self._jump = ""
            self.variables[words[0]] = [item]
            self._doubt(words[0], [*words, *lists])
            yield from self.run(body, depth + 1)
        if self._jump != "return":
            self._jump = ""

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
        before, returned = dict(self.variables), self._returned
        if function.scoped:
            self._returned = {}
        for name in (
            *function.parameters,
            "ARGV",
            "ARGN",
            *(f"ARGV{n}" for n in range(len(given))),
        ):
            self._doubt(name, words)
        self.variables |= {n: [v] for n, v in zip(function.parameters, given, strict=False)}
        self.variables |= {f"ARGV{number}": [value] for number, value in enumerate(given)}
        others = given[len(function.parameters) :]
        self.variables |= {"ARGV": given, "ARGN": others, "ARGC": [str(len(given))]}
        run = self._scope if function.scoped else self.run
        yield from run(function.body, depth + 1)
        if function.scoped:
            self._leave(before, returned)
