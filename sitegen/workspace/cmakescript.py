"""Go through files of CMake as far as that is possible without CMake."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
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
INCLUDES = ("add_subdirectory", "include")
# What stands for other commands, or for none.
BLOCKS = ("function", "macro", "foreach")
# They give variables values that only CMake knows.
SETS = ("cmake_path", "execute_process", "file", "get_filename_component", "list", "math", "string")
DEEPEST, LONGEST = 20, 1000

# The name in small letters, and the words as they are written.
Command = tuple[str, list[str]]


@dataclass(frozen=True)
class Function:
    """A function, or a macro, which shares the variables of who calls it."""

    parameters: Sequence[str]
    body: Sequence[Command]
    scoped: bool


@dataclass
class Script:
    """Knows the variables at one place of a script, as far as that is possible."""

    variables: dict[str, list[str]]
    _functions: dict[str, Function] = field(default_factory=dict)
    # Variables whose values depend on conditions, and how many conditions stand around a command.
    _unsure: set[str] = field(default_factory=set)
    _conditions: int = 0

    def run(self, commands: Iterable[Command], depth: int = 0) -> Iterator[Command]:
        """Yield the commands that are not of the language itself, in their order.

        Calls are yielded as what they do. Of conditions, both sides count, but for tests of the
        package, which are left out.
        """
        rest = iter(commands)
        for name, words in rest:
            if name in BLOCKS:
                yield from self._block(name, words, list(_until(f"end{name}", name, rest)), depth)
            elif name == "if" and words == ["BUILD_TESTING"]:
                yield from self.run(_without_tests(_until("endif", "if", rest)), depth)
            elif name in self._functions and depth < DEEPEST:
                yield from self._call(self._functions[name], words, depth)
            else:
                self._conditions += (name == "if") - (name == "endif")
                self._set(name, words)
                yield name, words

    def values(self, words: Iterable[str]) -> list[str]:
        """Replace variables by what they hold; those that are not known stay as they are."""
        found: list[str] = []
        for word in words:
            alone = VARIABLE.fullmatch(word)
            if alone:
                found += self.variables.get(alone[1], [word])
            else:
                found += VARIABLE.sub(self._one, word).split(";")
        return found

    def surely(self, word: str) -> str | None:
        """Return what a word is; None if only CMake can tell."""
        text = "".join(self.values([word]))
        unsure = "$" in text or self._unsure.intersection(VARIABLE.findall(word))
        return None if unsure else text

    def _one(self, match: re.Match[str]) -> str:
        values = self.variables.get(match[1])
        return ";".join(values) if values is not None else match[0]

    def _set(self, name: str, words: list[str]) -> None:
        variable, values = (words or [""])[0], list[str]()
        if name == "project" and words:
            variable, values = "PROJECT_NAME", words[:1]
        elif name == "set" and words:
            end = words.index("CACHE") if "CACHE" in words else len(words)
            values = self.values(words[1:end])
        elif name == "list" and words[:1] == ["APPEND"] and len(words) > 1:
            variable = words[1]
            values = [*self.variables.get(variable, []), *self.values(words[2:])]
        else:
            for word in words if name in SETS else ():
                self.variables.pop(word, None)
            return
        self.variables[variable] = values
        (self._unsure.add if self._conditions else self._unsure.discard)(variable)

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
        """Return what a loop goes through, given the words behind its variable."""
        if words[:1] == ["RANGE"]:
            numbers = [int(word) for word in self.values(words[1:]) if word.isdigit()]
            first, last, step = (*([0] if len(numbers) == 1 else []), *numbers, 1, 1)[:3]
            return [str(n) for n in range(first, last + 1, step or 1)] if numbers else []
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
    """Yield commands up to the end of the block that has begun."""
    depth = 1
    for name, words in commands:
        depth += (name == begin) - (name == end)
        if depth == 0:
            return
        yield name, words


def _without_tests(block: Iterable[Command]) -> list[Command]:
    """Return what stands behind else() in a block of `if(BUILD_TESTING)`."""
    found, depth, other = list[Command](), 0, False
    for name, words in block:
        depth += (name == "if") - (name == "endif")
        if other:
            found.append((name, words))
        other = other or (name == "else" and depth == 0)
    return found


def written(path: Path, seen: set[Path]) -> Iterator[Command]:
    """Yield the commands of a file, or of a folder's CMakeLists.txt, and of those it includes.

    Each file counts once; `seen` gets to know them.
    """
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
            yield from written(file.parent / words[0], seen)


def _parse(text: str) -> Iterator[Command]:
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
