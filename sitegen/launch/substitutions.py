"""Expand the substitutions of launch files, such as $(var speed)."""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from urllib.parse import unquote

from sitegen.launch import conditions
from sitegen.launch.expressions import ExpressionError, value_of
from sitegen.launch.processes import installed
from sitegen.workspace.manifest import ENVIRONMENT

# The substitutions that only describe_expressions.py writes.
OF_PYTHON = ("expression", "apply")
# Longer expressions are cut in messages.
LONGEST_SHOWN = 200
# A page shows the values of its launch file to everyone, so the environment of the author's
# computer is not read, except for what ROS is configured with.
PUBLIC = ("ROS_", "RMW_", "RCUTILS_")


class SubstitutionError(Exception):
    """A substitution cannot be expanded; the message says why."""


def expand(
    text: str,
    variables: Mapping[str, str],
    file: Path,
    share: Callable[[str], Path],
    output: Callable[[str], str],
) -> str:
    """Return `text` with all substitutions expanded.

    `variables` are the launch arguments; `file` is the file that contains the text; `share` returns
    the folder of a package and `output` the output of a command; both may raise a
    SubstitutionError.

    Raises: SubstitutionError if a substitution cannot be expanded.
    """
    known: dict[str, Callable[..., str]] = {
        "var": lambda name, *default: _first(
            variables.get(name), *default, what=f"argument '{name}'"
        ),
        "env": _variable,
        "dirname": lambda: str(file.parent),
        "filename": lambda: str(file),
        "find_pkg_share": lambda package: str(share(package)),
        "find_pkg_prefix": lambda package: str(share(package)),
        "find_exec": lambda name: name,
        "exec_in_pkg": lambda executable, package: str(
            installed(share(package), package, executable)
        ),
        "command": lambda line, *_: output(line),
        "eval": lambda *words: _evaluated(" ".join(words)),
        "expression": lambda *words: _evaluated("".join(map(_part, words))),
        "file_content": lambda path: output(shlex.join(["cat", path])),
        **conditions.SUBSTITUTIONS,
        "apply": lambda name, *words: conditions.SUBSTITUTIONS[name](*_arguments(words)),
    }

    def call(words: list[str]) -> str:
        name, *arguments = words or [""]
        function = known.get(name.replace("-", "_"))
        if function is None:
            public = (each.replace("_", "-") for each in known if each not in OF_PYTHON)
            others = ", ".join(f"$({each} …)" for each in public)
            raise SubstitutionError(f"$({name} …) is not supported; supported: {others}")
        try:
            return function(*arguments)
        except TypeError:
            raise SubstitutionError(f"$({name} …) has the wrong number of arguments") from None
        except ValueError as error:
            raise SubstitutionError(f"$({name} …): {error}") from None

    reader = _Reader(text, call)
    result = reader.plain()
    if reader.at < len(text):
        raise SubstitutionError(f"'{text}' has an unmatched ')'")
    return result


def pieces(text: str) -> Iterator[tuple[str, bool]]:
    """Yield the parts of `text`, and whether each is a substitution; nothing is expanded."""
    reader = _Reader(text, lambda _: "")
    plain = ""
    while reader.at < len(text):
        begin = reader.at
        if text.startswith("$(", begin):
            if plain:
                yield plain, False
            plain = ""
            reader.substitution()
            yield text[begin : reader.at], True
        else:
            plain += reader.next()
    if plain:
        yield plain, False


class _Reader:
    """Reads text with substitutions, which may be nested."""

    def __init__(self, text: str, call: Callable[[list[str]], str]) -> None:
        self._text = text
        self._call = call
        self.at = 0

    def plain(self) -> str:
        """Return the text up to its end."""
        found = ""
        while self.at < len(self._text):
            found += self._letters()
        return found

    def _letters(self) -> str:
        """Return the value of the next substitution, which may be empty, or the next character."""
        return self.substitution() if self._text.startswith("$(", self.at) else self.next()

    def next(self) -> str:
        """Return the next character."""
        self.at += 1
        return self._text[self.at - 1]

    def substitution(self) -> str:
        """Return the value of the substitution that begins here."""
        self.at += 2
        words: list[str] = []
        while (word := self._word()) is not None:
            words.append(word)
        if self.at >= len(self._text):
            raise SubstitutionError(f"'{self._text}' has an unclosed '('")
        self.at += 1
        return self._call(words)

    def _word(self) -> str | None:
        """Return the next word of a substitution, None at its end."""
        while self.at < len(self._text) and self._text[self.at].isspace():
            self.at += 1
        if self.at >= len(self._text) or self._text[self.at] == ")":
            return None
        found, quote = "", ""
        while self.at < len(self._text):
            letter = self._text[self.at]
            if not quote and (letter.isspace() or letter == ")"):
                break
            if letter in ("'", '"') and quote in ("", letter):
                quote = "" if quote else letter
                self.at += 1
            else:
                found += self._letters()
        return found


def _arguments(words: Sequence[str]) -> list[str]:
    """Return the arguments written by describe_expressions.py, which commas separate."""
    arguments = [""]
    for word in words:
        if word == ",":
            arguments.append("")
        else:
            arguments[-1] += _part(word)
    return arguments


def _part(word: str) -> str:
    """Return a word written by describe_expressions.py as a part of the expression."""
    return unquote(word[1:]) if word.startswith("=") else word[1:]


def _evaluated(expression: str) -> str:
    """Return the value of a Python expression, which may use `math` and the plain functions."""
    try:
        return str(value_of(expression))
    except ExpressionError as error:
        raise SubstitutionError(f"'{_short(expression)}': {error}") from None
    except Exception as error:
        raise SubstitutionError(
            f"'{_short(expression)}' is not a valid expression: {type(error).__name__}: {error}"
        ) from None


def _short(expression: str) -> str:
    return expression if len(expression) <= LONGEST_SHOWN else f"{expression[:LONGEST_SHOWN]}…"


def _variable(name: str, *default: str) -> str:
    """Return a variable of the environment."""
    if name.startswith(PUBLIC):
        value = ENVIRONMENT.get(name, os.environ.get(name))
        return _first(value, *default, what=f"environment variable '{name}'")
    if not default:
        raise SubstitutionError(
            f"environment variable '{name}' is not read, because the page would publish its value; "
            f"use an argument, or a default: $(env {name} …)"
        )
    return default[0]


def _first(*values: str | None, what: str) -> str:
    for value in values:
        if value is not None:
            return value
    raise SubstitutionError(f"{what} is not set")
