"""Check ROS interface definitions: rosidl reports an error without its location, this with it."""

from __future__ import annotations

import contextlib
import io
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from sitegen.errors import nearest
from sitegen.interfaces import rosidl

# The number of parts of a definition, which are separated by lines of three dashes.
PARTS = {".msg": 1, ".srv": 2, ".action": 3}
NAMES = {1: "message", 2: "service", 3: "action"}
ARRAY = re.compile(r"(<=\d+)?(\[(<=)?\d*\])?$")
MESSAGE = "msg"
# Types of ROS 1, which rosidl parses and later fails on.
FORMER = {"time": "builtin_interfaces/Time", "duration": "builtin_interfaces/Duration"}
# Comments and string literals of IDL, and the messages that it names.
IDL_TEXT = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:[^"\\]|\\.)*"', re.S)
IDL_MESSAGE = re.compile(r"\b(\w+)::msg::(\w+)\b(?!::)")


def check(
    package: str, folder: Path, files: Sequence[str], packages: Mapping[str, Path]
) -> list[str]:
    """Return the errors in the definitions of `package`, all of them, as `file:line: what`.

    `files` are relative to `folder`; `packages` are the packages that they may use, each with the
    folder of its type descriptions.
    """
    checker = _Checker(package, folder, files, packages)
    return [problem for name in files for problem in checker.problems(name)]


class _Checker:
    def __init__(
        self, package: str, folder: Path, files: Sequence[str], packages: Mapping[str, Path]
    ) -> None:
        self._parser = rosidl.module(rosidl.PARSER)
        self._package = package
        self._folder = folder
        self._packages = packages
        self._messages = {Path(name).stem for name in files if Path(name).parent.name == MESSAGE}

    def problems(self, name: str) -> Iterator[str]:
        """Yield the errors in one file."""
        file = self._folder / name
        try:
            text = file.read_text(encoding="utf-8")
        except FileNotFoundError:
            here = (f.relative_to(self._folder).as_posix() for f in file.parent.glob("*.*"))
            what = f"rosidl_generate_interfaces() lists '{name}', which does not exist"
            yield f"{self._folder / 'CMakeLists.txt'}: {what}; {nearest(name, here)}"
            return
        except UnicodeDecodeError:
            yield f"{file}: not UTF-8; save the file as UTF-8"
            return
        if text.startswith("\ufeff"):
            yield f"{file}:1: ROS reads no byte order mark; save the file as UTF-8 without it"
            return
        check = self._idl if file.suffix == ".idl" else self._definition
        for line, what in check(file, text):
            yield f"{file}:{line}: {what}"

    def _definition(self, file: Path, text: str) -> Iterator[tuple[int, str]]:
        lines = text.splitlines()
        cuts = [number for number, line in enumerate(lines) if line.rstrip() == "---"]
        expected = PARTS[file.suffix]
        if len(cuts) != expected - 1:
            where = cuts[expected - 1] if len(cuts) >= expected else len(lines) - 1
            count = f"{expected - 1 or 'no'} line{'s'[: expected != 2]}"
            yield max(where, 0) + 1, f"{NAMES[expected]} needs {count} '---', found {len(cuts)}"
            return
        for begin, end in zip([-1, *cuts], [*cuts, len(lines)], strict=True):
            for line, what in self._message(file.stem, lines[begin + 1 : end]):
                yield begin + 1 + line, what

    def _message(self, name: str, lines: list[str]) -> Iterator[tuple[int, str]]:
        try:
            message = self._parse(name, lines)
        except Exception as error:
            yield self._first_wrong_line(name, lines), self._say(error)
            return
        for field in message.fields:
            kind = field.type
            if kind.pkg_name is None:
                what = f"'{kind.type}' is {FORMER[kind.type]} now" if kind.type in FORMER else ""
            else:
                what = self._unknown(kind.pkg_name, kind.type)
            if what:
                pattern = re.compile(rf"\s*\S+\s+{field.name}\b")
                yield 1 + next(i for i, line in enumerate(lines) if pattern.match(line)), what

    def _parse(self, name: str, lines: Iterable[str]) -> Any:
        with contextlib.redirect_stderr(io.StringIO()):
            return self._parser.parse_message_string(self._package, name, "\n".join(lines))

    def _first_wrong_line(self, name: str, lines: list[str]) -> int:
        for count in range(len(lines)):
            try:
                self._parse(name, lines[: count + 1])
            except Exception:
                return count + 1
        return 1

    def _say(self, error: Exception) -> str:
        text = str(error)
        known = {*self._parser.PRIMITIVE_TYPES, *self._messages} - FORMER.keys()
        if isinstance(error, self._parser.InvalidFieldDefinition):
            return f"'{text.strip()}' is not a valid field; write a type and a name"
        if isinstance(error, self._parser.InvalidResourceName):
            wrong = ARRAY.sub("", re.match(r"'?([^']*)", text)[1])  # type: ignore[index]
            return f"no type '{wrong}'; {nearest(wrong, known)}"
        if isinstance(error, NameError):
            # rosidl quotes the pattern that the name does not match.
            example = "WHEEL_SPEED" if "constant" in text else "wheel_speed"
            return f"{text.partition('. It should')[0]}; write it like {example}"
        twice = re.fullmatch(r"the (\w+)s iterable contains duplicate names: (.+)", text)
        return f"more than one {twice[1]} named '{twice[2]}'" if twice else text.replace("\n", " ")

    def _unknown(self, package: str, name: str) -> str:
        if package == self._package:
            known = self._messages
        elif package in self._packages:
            known = {file.stem for file in (self._packages[package] / MESSAGE).glob("*.json")}
        else:
            hint = nearest(package, self._packages)
            return f"no package '{package}' with interfaces; {hint} (package.xml must list it)"
        if name in known:
            return ""
        return f"package '{package}' has no message '{name}'; {nearest(name, known)}"

    def _idl(self, file: Path, text: str) -> Iterator[tuple[int, str]]:
        parser = rosidl.module("rosidl_parser.parser")
        try:
            parser.parse_idl_string(text)
        except Exception as error:
            line = getattr(error, "line", 1)
            word = str(getattr(error, "token", "") or getattr(error, "char", ""))
            if word:
                yield line, f"'{word}' is unexpected here"
            elif line < 1:
                yield text.count("\n"), "unexpected end of file"
            else:
                yield line, f"not an interface: {error}"
            return
        text = IDL_TEXT.sub(lambda words: "\n" * words[0].count("\n"), text)
        for match in IDL_MESSAGE.finditer(text):
            what = self._unknown(match[1], match[2])
            if what:
                yield text.count("\n", 0, match.start(2)) + 1, what
