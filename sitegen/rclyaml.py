"""Parameters of nodes in YAML, read by the rules of ROS: from files and from `-p name:=value`.

The rules are those of rcl_yaml_param_parser in rcl 10.1. They differ from YAML's own: `y` is a
boolean, `1e3` a number, `12:30`, `1_000` and `null` are strings, and aliases are refused. The build
and, in pages, Python nodes use this module; it needs only PyYAML.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

import yaml

Scalar = bool | int | float | str
# None is the value of an empty list: its type is unknown, so that the parameter is not set.
Value = Scalar | list[Scalar] | None

KEY = "ros__parameters"
EVERYWHERE = "/**"
TRUE = {"Y", "y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"}
FALSE = {"N", "n", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"}
INFINITE = re.compile(r"[-+]?\.(inf|Inf|INF)")
NOT_A_NUMBER = {".nan", ".NaN", ".NAN"}
# What strtoll() and strtod() of C accept.
INTEGER = re.compile(r"\s*[-+]?(0[xX][0-9a-fA-F]+|0[0-7]*|[1-9][0-9]*)", re.ASCII)
DECIMAL = re.compile(r"\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?", re.ASCII)
HEXADECIMAL = re.compile(
    r"\s*[-+]?0[xX]([0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)([pP][-+]?[0-9]+)?", re.ASCII
)
NAMED = re.compile(r"\s*[-+]?(inf(inity)?|nan(\(\w*\))?)", re.IGNORECASE | re.ASCII)
SMALLEST = 2.2250738585072014e-308
# A part of a node's name in a file: a name or a wildcard.
PART = re.compile(r"\*\*?|[A-Za-z_]\w*", re.ASCII)


class ParameterError(ValueError):
    """Parameters cannot be read; says why, and `line` says where, counted from 1."""

    def __init__(self, message: str, line: int) -> None:
        super().__init__(message)
        self.line = line


class Override(NamedTuple):
    """A parameter for the nodes that `pattern` matches."""

    pattern: str
    name: str
    value: Value


@dataclass
class _Parameter:
    """A parameter of the nodes that one pattern matches."""

    name: str
    value: Value = None

    def keep(self, value: Value) -> None:
        """Take a later value, unless the one that is there is of a type that rcl prefers.

        In rcl a parameter has a place for each type, and the first that is taken counts: 2 stays
        when 2.5 or "fast" comes after it.
        """
        if value is not None and (self.value is None or _rank(value) <= _rank(self.value)):
            self.value = value


NAMES: dict[type, str] = {bool: "boolean", int: "integer", float: "double", str: "string"}


def _rank(value: Value) -> int:
    kinds = list(NAMES)
    return kinds.index(type(value[0])) + 4 if isinstance(value, list) else kinds.index(type(value))


def scalar(text: str) -> Scalar:
    """Return the value of `text` without quotes: a boolean, a number or a string."""
    if text in TRUE or text in FALSE:
        return text in TRUE
    if INTEGER.fullmatch(text):
        digits = text.strip().lstrip("+-")
        base = 16 if digits[:2] in ("0x", "0X") else 8 if digits[0] == "0" else 10
        whole = int(text, base)
        if -(2**63) <= whole < 2**63:
            return whole
    if INFINITE.fullmatch(text) or text in NOT_A_NUMBER:
        return float(text.replace(".", ""))
    number = _double(text)
    return text if number is None else number


def _double(text: str) -> float | None:
    """Return what strtod() makes of all of `text`; None if it is no number or out of range."""
    if NAMED.fullmatch(text):
        return float(text.partition("(")[0])
    if DECIMAL.fullmatch(text):
        number, digits = float(text), re.split("[eE]", text)[0]
    elif HEXADECIMAL.fullmatch(text):
        digits = re.split("[pP]", text)[0].lower().partition("x")[2]
        try:
            number = float.fromhex(text.strip())
        except OverflowError:
            return None
    else:
        return None
    is_zero = not digits.strip("+-0. \t\n")
    return number if is_zero or SMALLEST <= abs(number) < float("inf") else None


class Overrides:
    """Parameters in the order in which they are given."""

    def __init__(self) -> None:
        self._nodes: dict[str, list[_Parameter]] = {}

    def add(self, name: str, text: str, pattern: str = EVERYWHERE) -> None:
        """Add the parameter of `-p name:=text`.

        Raises: ParameterError, or yaml.YAMLError if the text is not valid YAML.
        """
        self.set(name, value(text), pattern)

    def set(self, name: str, value: Value, pattern: str = EVERYWHERE) -> None:
        """Add a parameter with a value that is known."""
        _named(self._nodes.setdefault(pattern, []), name).keep(value)

    def file(self, events: Iterable[yaml.Event]) -> None:
        """Add the parameters of a file.

        Raises: ParameterError, or yaml.YAMLError if the file is not valid YAML.
        """
        reader = _Reader(events)
        for event in reader:
            if isinstance(event, yaml.MappingStartEvent):
                self._sections(reader, "")
            elif isinstance(event, yaml.NodeEvent) and not _is_nothing(event):
                raise _error(event, "expected names of nodes, like '/**:'")

    def _sections(self, reader: _Reader, above: str) -> None:
        """Add the parameters of the nodes whose names begin with `above`."""
        for key, event in reader.pairs():
            if key.value.startswith(KEY):
                if not above:
                    raise _error(key, f"expected the name of a node above '{KEY}'")
                _check(key, above)
                if not isinstance(event, yaml.MappingStartEvent):
                    raise _error(key, f"'{KEY}' of '{above}' has no parameters")
                _parameters(reader, self._nodes.setdefault(above, []), "")
            elif isinstance(event, yaml.MappingStartEvent):
                self._sections(reader, f"{above}/{key.value}" if above else key.value)
            else:
                raise _error(key, f"'{key.value}' has a value, but is not below '{KEY}'")

    def __iter__(self) -> Iterator[Override]:
        """Yield the overrides, of which the last that matches a node counts."""
        for pattern, parameters in self._nodes.items():
            last = {one.name: one.value for one in parameters}
            yield from (Override(pattern, name, value) for name, value in last.items())


def matches(pattern: str, node: str) -> bool:
    """Return whether a name or a pattern with * and ** is that of a node, like `/arm/left`."""
    parts = re.escape(f"/{pattern.lstrip('/')}").replace(r"/\*\*", r"(/\w+)*")
    return bool(re.fullmatch(parts.replace(r"\*", r"\w+"), node, re.ASCII))


def value(text: str) -> Value:
    """Return the value of a parameter in `-p name:=text`.

    Raises: ParameterError, or yaml.YAMLError if the text is not valid YAML.
    """
    reader = _Reader(yaml.parse(text, Loader=yaml.SafeLoader))
    found = [_value(reader, event) for event in reader if isinstance(event, yaml.NodeEvent)]
    if len(found) != 1:
        raise ParameterError("there is no value", 1)
    return found[0]


def written(value: Value) -> str:
    """Return a value as YAML in one line, which value() reads as the same."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        text = repr(value)
        return f"{text[:-3]}.{text[-3:]}" if text.lstrip("-") in ("inf", "nan") else text
    if isinstance(value, str):
        if value.isprintable():
            return "'" + value.replace("'", "''") + "'"
        # In single quotes, line ends would become spaces.
        dumped = yaml.safe_dump(value, default_style='"', width=float("inf"), allow_unicode=True)
        return str(dumped).strip()
    return f"[{', '.join(map(written, value or ()))}]" if not isinstance(value, int) else str(value)


class _Reader:
    """Reads events of YAML, without those that rcl ignores."""

    def __init__(self, events: Iterable[yaml.Event]) -> None:
        self._events = iter(events)

    def __iter__(self) -> Iterator[yaml.Event]:
        return self

    def __next__(self) -> yaml.Event:
        event = next(self._events)
        if isinstance(event, yaml.AliasEvent):
            raise _error(event, f"ROS does not support aliases like '*{event.anchor}'")
        return event

    def pairs(self) -> Iterator[tuple[yaml.ScalarEvent, yaml.Event]]:
        """Yield each key of a mapping with the event after it, up to the end of the mapping."""
        for key in self:
            if isinstance(key, yaml.MappingEndEvent):
                return
            if not isinstance(key, yaml.ScalarEvent) or not key.value:
                raise _error(key, "expected a name before ':'")
            yield key, next(self)


def _parameters(reader: _Reader, found: list[_Parameter], above: str) -> None:
    """Add the parameters of a mapping whose name is `above`, which ends in a dot or is empty."""
    for key, event in reader.pairs():
        # As in rcl: the name of the mapping becomes that of its first parameter.
        parameter = _named(found, above.removesuffix(".") or key.value)
        parameter.name = f"{above}{key.value}"
        if isinstance(event, yaml.MappingStartEvent):
            _parameters(reader, found, f"{parameter.name}.")
        else:
            parameter.keep(_value(reader, event))


def _named(parameters: list[_Parameter], name: str) -> _Parameter:
    """Return the first parameter of this name; add it if there is none."""
    found = next((one for one in parameters if one.name == name), None)
    if found is None:
        found = _Parameter(name)
        parameters.append(found)
    return found


def _value(reader: _Reader, event: yaml.Event) -> Value:
    """Return the value that begins with `event`: a scalar or a list."""
    if not isinstance(event, yaml.SequenceStartEvent):
        return _scalar(event)
    items: list[Scalar] = []
    for item in reader:
        if isinstance(item, yaml.SequenceEndEvent):
            return items or None
        if not isinstance(item, yaml.ScalarEvent):
            raise _error(item, "the items of a list must be scalars")
        items.append(_scalar(item))
        first, last = NAMES[type(items[0])], NAMES[type(items[-1])]
        if first != last:
            raise _error(
                item, f"all values of a list must have the same type, found {first} and {last}"
            )
    raise _error(event, "the list does not end")


def _scalar(event: yaml.Event) -> Scalar:
    if not isinstance(event, yaml.ScalarEvent):
        raise _error(event, "expected a boolean, a number, a string or a list of these")
    if event.tag == "tag:yaml.org,2002:str" or event.style in ("'", '"'):
        return event.value
    if not event.value:
        raise _error(event, "there is no value; write '' for an empty string")
    return scalar(event.value)


def _check(key: yaml.ScalarEvent, pattern: str) -> None:
    """Report names that no node can have."""
    for part in pattern.removeprefix("/").split("/"):
        if not PART.fullmatch(part):
            raise _error(key, f"'{pattern}' is not a valid name of a node")


def _is_nothing(event: yaml.Event) -> bool:
    return isinstance(event, yaml.ScalarEvent) and not event.value


def _error(event: yaml.Event, message: str) -> ParameterError:
    return ParameterError(message, event.start_mark.line + 1 if event.start_mark else 1)
