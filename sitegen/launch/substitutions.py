"""Expand the substitutions of launch files, such as $(var speed)."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import unquote

from sitegen.launch import conditions
from sitegen.launch.environment import Environment
from sitegen.launch.expressions import ExpressionError, value_of
from sitegen.launch.processes import installed

# The substitutions that only Python files have: describe_expressions.py and describe_functions.py
# write them.
OF_PYTHON = ("expression", "apply", "perform")
# Longer expressions are cut in messages.
LONGEST_SHOWN = 200
# Where launch would write its logs. A page has none, but the name may be a part of a value.
LOG_FOLDER = "/root/.ros/log"
ESCAPED = re.compile(r"\\(.)")


class SubstitutionError(Exception):
    """A substitution cannot be expanded; the message says why."""


@dataclass(frozen=True)
class Known:
    """What substitutions can refer to at one point of a launch file.

    `file` contains the text, `loop` has the variables of the loops around it, and `parameters`
    those of all nodes so far: names with values, and files.
    """

    file: Path
    variables: Mapping[str, str]
    environment: Environment = field(default_factory=Environment)
    loop: Mapping[str, str] = field(default_factory=dict)
    parameters: Sequence[tuple[str, object] | Path] = ()


def expand(
    text: str,
    given: Known,
    share: Callable[[str], Path],
    output: Callable[[str], str],
    performed: Callable[[int], str] | None = None,
    *,
    escapes: bool = False,
) -> str:
    """Return `text` with all substitutions expanded.

    `share` returns the folder of a package, `output` the output of a command, and `performed` the
    value of a substitution that a Python file defines itself, by its number; all may raise a
    SubstitutionError. With `escapes`, as in XML and YAML files, a backslash takes the next
    character literally.

    Raises: SubstitutionError if a substitution cannot be expanded.
    """
    known: dict[str, Callable[..., str]] = {
        "var": lambda name, *default: _first(
            given.variables.get(name), *default, what=f"argument '{name}'"
        ),
        "env": lambda name, *default: _variable(given.environment, name, *default),
        "for_var": lambda name, *default: _first(
            given.loop.get(name), *default, what=f"variable '{name}' of the loop"
        ),
        "index": lambda name: _first(given.loop.get(name), what=f"index '{name}' of the loop"),
        "param": lambda name, *default: _first(
            _parameter(given, name), *default, what=f"parameter '{name}'"
        ),
        "dirname": lambda: str(given.file.parent),
        "filename": lambda: str(given.file),
        "log_dir": lambda: LOG_FOLDER,
        "launch_log_dir": lambda: LOG_FOLDER,
        "find_pkg_share": lambda package: str(share(package)),
        "find_pkg_prefix": lambda package: str(share(package)),
        "find_exec": lambda name: name,
        "exec_in_pkg": lambda executable, package: str(
            installed(share(package), package, executable)
        ),
        "command": lambda line, *_: output(line),
        "eval": lambda *words: _evaluated(" ".join(words)),
        "expression": lambda *words: _evaluated("".join(map(_part, words))),
        **({"perform": lambda number: performed(int(number))} if performed else {}),
        "file_content": lambda path: output(shlex.join(["cat", path])),
        "string_join": lambda delimiter, first, *others: delimiter.join([first, *others]),
        **conditions.SUBSTITUTIONS,
        "apply": lambda name, *words: applied[name](*_arguments(words)),
    }
    # Python files join paths, too.
    applied: dict[str, Callable[..., str]] = {**known, "path_join": os.path.join}

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

    reader = _Reader(text, call, escapes=escapes)
    result = reader.plain()
    if reader.at < len(text):
        raise SubstitutionError(f"'{text}' has an unmatched ')'")
    return result


def unescaped(text: str) -> str:
    """Return a text without substitutions, with its escapes replaced."""
    return ESCAPED.sub(r"\1", text)


def pieces(text: str, *, escapes: bool = False) -> Iterator[tuple[str, bool]]:
    """Yield the parts of `text`, and whether each is a substitution; nothing is expanded."""
    reader = _Reader(text, lambda _: "", escapes=escapes)
    plain = ""
    while reader.at < len(text):
        begin = reader.at
        if reader.begins():
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

    def __init__(self, text: str, call: Callable[[list[str]], str], *, escapes: bool) -> None:
        self._text = text
        self._call = call
        self._escapes = escapes
        self.at = 0

    def plain(self) -> str:
        """Return the text up to its end."""
        found = ""
        while self.at < len(self._text):
            found += self._letters()
        return found

    def _letters(self) -> str:
        """Return the value of the next substitution, which may be empty, or the next character."""
        return self.substitution() if self.begins() else self.next()

    def begins(self) -> bool:
        """Return whether a substitution begins here, which it never does after a backslash."""
        is_escaped = self._escapes and self._text.endswith("\\", 0, self.at)
        return self._text.startswith("$(", self.at) and not is_escaped

    def next(self) -> str:
        """Return the next character, of an escape the second one."""
        if self._escapes and ESCAPED.match(self._text, self.at):
            self.at += 1
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


def _variable(environment: Environment, name: str, *default: str) -> str:
    """Return a variable of the environment."""
    if name not in environment and not default:
        raise SubstitutionError(
            f"environment variable '{name}' is not read, because the page would publish its value; "
            f"set it in 'environment' of the page, or use a default: $(env {name} …)"
        )
    return _first(environment.value(name), *default, what=f"environment variable '{name}'")


def _parameter(given: Known, name: str) -> str | None:
    """Return the first value that all nodes get for a parameter."""
    pairs = (each for each in given.parameters if isinstance(each, tuple))
    return next((str(value) for own, value in pairs if own == name), None)


def _first(*values: str | None, what: str) -> str:
    for value in values:
        if value is not None:
            return value
    raise SubstitutionError(f"{what} is not set")
