"""Translate the patterns and regular expressions of CMake to Python's."""

from __future__ import annotations

import re
from typing import NamedTuple

BRACKET = re.compile(r"\[(\^?\]?[^\]]*)\]")


class Rule(NamedTuple):
    """What install() does with the paths in which `expression` is found."""

    expression: re.Pattern[str]
    excludes: bool = False


def rule(text: str, kind: str) -> Rule:
    """Return the rule of a PATTERN or a REGEX. Raises: ValueError, if it is not valid."""
    # A pattern matches whole names at the end of a path.
    expression = f"/{_pattern(text)}\\Z" if kind == "PATTERN" else _regex(text)
    try:
        return Rule(re.compile(expression))
    except re.error:
        raise ValueError(f"'{text}' is not a valid regular expression") from None


def _pattern(text: str) -> str:
    found, rest = "", text
    while rest:
        # "]" may be the first character in brackets, and "!" is another "^".
        bracket = re.match(r"\[([!^]?\]?[^\]]*)\]", rest)
        if bracket:
            inside = bracket[1]
            inside = f"^{inside[1:]}" if inside.startswith("!") else inside
            found += _bracket(inside)
            rest = rest[bracket.end() :]
            continue
        found += {"*": "[^/]*", "?": "[^/]"}.get(rest[0], re.escape(rest[0]))
        rest = rest[1:]
    return found


def _regex(text: str) -> str:
    """Translate a regular expression: there are no classes such as \\d, and no {2,3}."""
    found, rest = "", text
    while rest:
        bracket = BRACKET.match(rest)
        if bracket:
            found += _bracket(bracket[1])
            rest = rest[bracket.end() :]
        elif rest[0] == "\\" and len(rest) > 1:
            found += re.escape(rest[1])
            rest = rest[2:]
        elif rest.startswith("(?"):
            # Python has extensions where CMake sees an error.
            raise ValueError(f"'{text}' is not a valid regular expression")
        else:
            found += {"$": "\\Z", "{": "\\{", "}": "\\}"}.get(rest[0], rest[0])
            rest = rest[1:]
    return found


def _bracket(inside: str) -> str:
    """Return a bracket expression: backslashes are characters, and so are brackets."""
    negated, rest = ("^", inside[1:]) if inside.startswith("^") else ("", inside)
    escaped = re.sub(r"([][\\&|~^])", r"\\\1", rest)
    return f"[{negated}{escaped}]"
