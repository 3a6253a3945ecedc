"""Values of a setup.py, and what may be done with them: nothing that runs code or fills memory."""

from __future__ import annotations

import ast
import io
import operator
import re
from collections.abc import Callable, Iterable, Iterator
from pathlib import PurePosixPath
from typing import Any

# The largest text, list or number of repetitions.
LARGEST = 100_000
PLAIN = (str, int, float, bool, type(None), PurePosixPath)
# Fields of str.format() and % without attributes, widths and precisions.
FIELDS = re.compile(r"(?:[^{}]|\{\{|\}\}|\{\w*\})*")
PERCENT = re.compile(r"(?:[^%]|%%|%(?:\(\w+\))?0?\d?[sdir])*")
CHANGING = {
    *("append", "extend", "insert", "pop", "remove", "sort", "reverse", "clear", "update"),
    *("setdefault", "add", "discard"),
}
METHODS: dict[type, set[str]] = {
    str: {
        *("strip", "lstrip", "rstrip", "split", "rsplit", "splitlines", "join", "format"),
        *("replace", "startswith", "endswith", "lower", "upper", "title", "capitalize", "find"),
        *("removeprefix", "removesuffix", "partition", "rpartition", "count", "isdigit", "index"),
    },
    list: {*CHANGING, "copy", "index", "count"} - {"update", "setdefault", "add", "discard"},
    tuple: {"index", "count"},
    dict: {"get", "items", "keys", "values", "update", "setdefault", "pop", "copy", "clear"},
    set: {
        *("add", "update", "discard", "remove", "clear", "copy", "pop"),
        *("union", "difference", "intersection"),
    },
    io.StringIO: {"read", "readlines", "readline", "close"},
}
COMPARE: dict[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
    ast.In: lambda left, right: left in right,
    ast.NotIn: lambda left, right: left not in right,
}


class Unknown:
    """A value that is known only when setup.py runs, because of an expression."""

    def __init__(self, node: ast.AST) -> None:
        text = " ".join(ast.unparse(node).split())
        self.text = text if len(text) < 60 else f"{text[:60]}…"
        self.line = getattr(node, "lineno", 1)

    def __bool__(self) -> bool:
        raise ValueError("not known")


def unknown_in(value: Any, step: Callable[[], None]) -> Unknown | None:
    """Return an unknown part of `value`; `step` is called for each of its parts."""
    waiting = [value]
    while waiting:
        one = waiting.pop()
        step()
        if isinstance(one, Unknown):
            return one
        if isinstance(one, dict):
            waiting += [*one.keys(), *one.values()]
        elif isinstance(one, list | tuple | set):
            waiting += one
    return None


def spoil(value: Any, unknown: Unknown) -> None:
    """Make a value unknown that something may have changed, under all of its names."""
    if isinstance(value, list):
        value.append(unknown)
    elif isinstance(value, dict):
        value[unknown] = unknown
    elif isinstance(value, set):
        value.add(unknown)


def items(value: Any) -> Iterable[Any]:
    """Return what a loop over `value` goes through.

    Raises: TypeError if there is nothing to go through.
    """
    if isinstance(value, str | list | tuple | dict | set | range | io.StringIO):
        return list(value)
    raise TypeError


def binary(operation: ast.operator, left: Any, right: Any) -> Any:
    """Return the result of a binary operation.

    Raises: TypeError or ValueError if there is none, or it is too large.
    """
    match operation:
        case ast.Add() if isinstance(left, str | list | tuple | int | float):
            return _bounded(left + right)
        case ast.Sub() if isinstance(left, int | float | set):
            return left - right
        case ast.BitOr() if isinstance(left, set | dict):
            return left | right
        case ast.Div() if isinstance(left, PurePosixPath | str):
            return PurePosixPath(left) / right if PurePosixPath in map(type, (left, right)) else 0
        case ast.Mult() if isinstance(left, str | list | tuple) and isinstance(right, int):
            if len(left) * right <= LARGEST:
                return left * right
        case ast.Mult() | ast.FloorDiv() if isinstance(left, int) and isinstance(right, int):
            if abs(left) <= LARGEST and abs(right) <= LARGEST:
                return left * right if isinstance(operation, ast.Mult) else left // right
        case ast.Mod() if isinstance(left, str) and PERCENT.fullmatch(left):
            parts = right.values() if isinstance(right, dict) else right
            parts = parts if not isinstance(parts, PLAIN) else [parts]
            if all(isinstance(part, PLAIN) for part in parts):
                return _bounded(left % right)
        case ast.Mod() if isinstance(left, int):
            return left % right
    raise TypeError


def method(value: Any, name: str) -> Callable[..., Any]:
    """Return the method `name` of `value`.

    Raises: TypeError if it must not be called.
    """
    kind = next((kind for kind in METHODS if isinstance(value, kind)), None)
    if kind is None or name not in METHODS[kind]:
        raise TypeError

    def call(*arguments: Any, **named: Any) -> Any:
        _check_size(value, name, arguments)
        if name == "format" and not (
            FIELDS.fullmatch(value)
            and all(isinstance(each, PLAIN) for each in (*arguments, *named.values()))
        ):
            raise TypeError
        found = getattr(value, name)(*arguments, **named)
        _bounded(value)
        return list(found) if name in ("items", "keys", "values") else _bounded(found)

    return call


def _check_size(value: Any, name: str, arguments: tuple[Any, ...]) -> None:
    """Refuse what multiplies texts.

    Raises: ValueError if the result could be too large.
    """
    if isinstance(value, str) and name in ("join", "replace", "format"):
        size = max((len(each) for each in arguments if hasattr(each, "__len__")), default=0)
        if (len(value) + 1) * (size + 1) > 100 * LARGEST:
            raise ValueError


def _bounded(value: Any) -> Any:
    if isinstance(value, str | list | tuple | dict | set) and len(value) > LARGEST:
        raise ValueError
    return value


def names_in(nodes: Iterable[ast.AST]) -> Iterator[tuple[str, bool]]:
    """Yield the names in `nodes` that may get other values, and whether they are assigned to."""
    for node in (each for top in nodes for each in ast.walk(top)):
        if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
            yield node.id, True
        elif isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name, True
        elif isinstance(node, ast.alias):
            yield (node.asname or node.name).partition(".")[0], True
        elif isinstance(node, ast.Call | ast.Subscript):
            parts = [*node.args, *node.keywords] if isinstance(node, ast.Call) else []
            root: ast.AST = node.func if isinstance(node, ast.Call) else node.value
            inside = (each for part in (root, *parts) for each in ast.walk(part))
            yield from ((each.id, False) for each in inside if isinstance(each, ast.Name))
