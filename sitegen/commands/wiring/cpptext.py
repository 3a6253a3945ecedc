"""Find calls and their arguments in C++ source, with comments and strings taken into account."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

_TOKEN = re.compile(
    r"""
      (?P<comment>//[^\n]*|/\*.*?\*/)
    | (?P<string>R"(?P<mark>[^()\\\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*")
    | '(?:\\[^'\n]+|[^'\\\n])'
    """,
    re.VERBOSE | re.DOTALL,
)
_LITERAL = re.compile(r'\s*"((?:[^"\\\n])*)"\s*')
_CLOSING = {"(": ")", "[": "]", "{": "}"}


@dataclass(frozen=True)
class Text:
    """A C++ source without comments: `code` with its strings, `bare` with blanks in their place.

    Both have the length of the source, so a position is the same in all three.
    """

    code: str
    bare: str

    @classmethod
    def of(cls, source: str) -> Text:
        """Return a source without its comments."""
        code = _TOKEN.sub(lambda found: _blank(found[0]) if found["comment"] else found[0], source)
        bare = _TOKEN.sub(lambda found: f'"{_blank(found[0][1:-1])}"', code)
        return cls(code, bare)

    def line(self, at: int) -> int:
        """Return the line of a position, counted from 1."""
        return self.bare.count("\n", 0, at) + 1

    def template(self, at: int) -> tuple[list[str], int]:
        """Return the template arguments that begin at `at`, if there are any, and their end."""
        begin = _skip(self.bare, at)
        if self.bare[begin : begin + 1] != "<":
            return [], at
        depth, start, found = 0, begin + 1, []
        for position in range(begin, len(self.bare)):
            letter = self.bare[position]
            depth += (letter in "<(") - (letter in ">)")
            if letter in ";{":
                break
            if depth == 0 or (depth == 1 and letter == ","):
                found.append(self.code[start:position].strip())
                start = position + 1
            if depth == 0:
                return found, position + 1
        return [], at

    def arguments(self, at: int) -> list[str] | None:
        """Return the arguments in the parentheses that begin at `at`, None if there are none."""
        begin = _skip(self.bare, at)
        if self.bare[begin : begin + 1] not in _CLOSING or begin >= len(self.bare):
            return None
        found: list[str] = []
        for start, end in _parts(self.bare, begin):
            found.append(self.code[start:end].strip())
        return found if found != [""] else []


def literal(argument: str) -> str | None:
    """Return the value of an argument that is a string literal without escapes, else None."""
    found = _LITERAL.fullmatch(argument)
    return found[1] if found else None


def _parts(bare: str, begin: int) -> Iterator[tuple[int, int]]:
    waiting, start = [_CLOSING[bare[begin]]], begin + 1
    for position in range(begin + 1, len(bare)):
        letter = bare[position]
        if letter in _CLOSING:
            waiting.append(_CLOSING[letter])
        elif letter == waiting[-1]:
            waiting.pop()
        if not waiting or (len(waiting) == 1 and letter == ","):
            yield start, position
            start = position + 1
        if not waiting:
            return


def _skip(text: str, at: int) -> int:
    while text[at : at + 1].isspace():
        at += 1
    return at


def _blank(text: str) -> str:
    return re.sub(r"[^\n]", " ", text)
