"""Evaluate the expressions of launch files, a part of Python that can do nothing but compute."""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from sitegen.workspace.setupvalues import COMPARE

# Launch files of strangers must not fill the memory or keep a build busy.
LONGEST, MOST_BITS, DEEPEST = 100_000, 4096, 50
PLAIN = (abs, all, any, bool, float, int, len, max, min, round, sorted, str, sum)
# These take time or memory that grows with the value of their arguments.
GROWING = ("comb", "factorial", "isqrt", "lcm", "perm", "prod")
LARGEST_ARGUMENT = 1000
MATH = {name: each for name, each in vars(math).items() if not name.startswith("_")}
NAMES: Mapping[str, Any] = {**MATH, **{each.__name__: each for each in PLAIN}}
# A width or a precision, as in '%9999d' or '%*d'.
WIDE = re.compile(r"%[^%a-zA-Z]*(\d{4}|\*)")
METHODS = frozenset(
    {"capitalize", "casefold", "count", "endswith", "find", "index", "isalnum", "isalpha"}
    | {"isdigit", "isnumeric", "join", "lower", "lstrip", "partition", "removeprefix"}
    | {"removesuffix", "replace", "rpartition", "rsplit", "rstrip", "split", "startswith"}
    | {"strip", "swapcase", "title", "upper"}
)
BINARY: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.LShift: operator.lshift,
    ast.RShift: operator.rshift,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
}
UNARY: Mapping[type[ast.unaryop], Callable[[Any], Any]] = {
    ast.Invert: operator.invert,
    ast.Not: operator.not_,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
}


class ExpressionError(Exception):
    """An expression is not supported, or its value is too large."""


def value_of(expression: str) -> Any:
    """Return the value of a Python expression.

    It may use numbers, texts, lists, tuples, dictionaries, operators, the names of `math`, plain
    functions such as `len`, and methods of texts such as `upper`.

    Raises: ExpressionError, or what Python raises for a wrong expression, such as SyntaxError.
    """
    if len(expression) > LONGEST:
        raise ExpressionError("the expression is too long")
    try:
        return _value(ast.parse(expression.strip(), mode="eval").body, 0)
    except (RecursionError, MemoryError):  # ast.parse() raises these for deep nesting
        raise ExpressionError("the expression is nested too deeply") from None


def _value(node: ast.expr, depth: int) -> Any:
    if depth > DEEPEST:
        raise ExpressionError("the expression is nested too deeply")

    def value(inside: ast.expr) -> Any:
        return _value(inside, depth + 1)

    found: Any
    match node:
        case ast.Constant(value=bool() | int() | float() | str() | None as constant):
            found = constant
        case ast.Name(id=name):
            found = _named(name)
        case ast.Attribute(value=ast.Name(id="math"), attr=name) if name in MATH:
            found = MATH[name]
        case ast.BinOp(left=left, op=sign, right=right):
            found = _combined(sign, value(left), value(right))
        case ast.UnaryOp(op=sign, operand=operand):
            found = UNARY[type(sign)](value(operand))
        case ast.BoolOp(op=sign, values=parts):
            found = _joined(sign, parts, value)
        case ast.Compare(left=left, ops=signs, comparators=others):
            found = _compared(value(left), signs, map(value, others))
        case ast.IfExp(test=test, body=yes, orelse=no):
            found = value(yes) if value(test) else value(no)
        case ast.List(elts=parts):
            found = [value(part) for part in parts]
        case ast.Tuple(elts=parts):
            found = tuple(value(part) for part in parts)
        case ast.Dict(keys=keys, values=parts) if None not in keys:
            found = {value(k): value(part) for k, part in zip(keys, parts, strict=True) if k}
        case ast.Subscript(value=many, slice=ast.Slice(lower=low, upper=high, step=step)):
            found = value(many)[
                slice(*(value(part) if part else None for part in (low, high, step)))
            ]
        case ast.Subscript(value=many, slice=at):
            found = value(many)[value(at)]
        case ast.Call(func=function, args=arguments, keywords=[]):
            found = _called(function, [value(argument) for argument in arguments], value)
        case _:
            raise ExpressionError(f"'{ast.unparse(node)}' is not supported in launch files")
    return _limited(found)


def _named(name: str) -> Any:
    if name not in NAMES:
        raise NameError(f"name '{name}' is not defined")
    return NAMES[name]


def _combined(sign: ast.operator, left: Any, right: Any) -> Any:
    if isinstance(left, int) and isinstance(right, int):
        bits = {
            ast.Pow: max(left.bit_length(), 1) * max(right, 0),
            ast.LShift: left.bit_length() + max(right, 0),
        }
        if bits.get(type(sign), 0) > MOST_BITS:
            raise ExpressionError("the value is too large")
    elif isinstance(sign, ast.Mult):
        times, many = (left, right) if isinstance(left, int) else (right, left)
        if isinstance(times, int) and _size(many) * times > LONGEST:
            raise ExpressionError("the value is too large")
    elif (
        isinstance(sign, ast.Mod)
        and isinstance(left, str)
        and (WIDE.search(left) or left.count("%") * _size(right) > LONGEST)
    ):
        raise ExpressionError("the value is too large")
    return BINARY[type(sign)](left, right)


def _joined(sign: ast.boolop, parts: Sequence[ast.expr], value: Callable[[ast.expr], Any]) -> Any:
    """Return the value of parts with `and` or `or`, the later ones only if they matter."""
    found = None
    for part in parts:
        found = value(part)
        if bool(found) is isinstance(sign, ast.Or):
            break
    return found


def _compared(left: Any, signs: Sequence[ast.cmpop], others: Any) -> bool:
    for sign, right in zip(signs, others, strict=True):
        if not COMPARE[type(sign)](left, right):
            return False
        left = right
    return True


def _called(function: ast.expr, arguments: list[Any], value: Callable[[ast.expr], Any]) -> Any:
    if isinstance(function, ast.Attribute) and function.attr in METHODS:
        text = value(function.value)
        if isinstance(text, str):
            return _of_text(text, function.attr, arguments)
    called = value(function)
    if not callable(called):
        raise TypeError(f"'{ast.unparse(function)}' is not a function")
    if getattr(called, "__name__", "") in GROWING:
        several = (one if isinstance(one, list | tuple) else [one] for one in arguments)
        flat = [each for one in several for each in one]
        if any(isinstance(each, int) and each > LARGEST_ARGUMENT for each in flat):
            raise ExpressionError("the value is too large")
    return called(*arguments)


def _of_text(text: str, method: str, arguments: Sequence[Any]) -> Any:
    # The largest results: each letter is replaced, or `text` stands between all items.
    largest = (len(text) + 1) * max(map(_size, arguments), default=0)
    if method in ("replace", "join") and largest > 10 * LONGEST:
        raise ExpressionError("the value is too large")
    return getattr(text, method)(*arguments)


def _limited(value: Any) -> Any:
    """Return `value` if its size is reasonable."""
    if _size(value) > LONGEST:
        raise ExpressionError("the value is too large")
    return value


def _size(value: Any) -> int:
    """Return about how many letters a value has as text, with all that it contains."""
    match value:
        case str():
            return len(value)
        case int():
            return 1 + value.bit_length() // 3
        case list() | tuple():
            return sum(map(_size, value)) + len(value)
        case dict():
            return _size([*value.keys(), *value.values()])
        case _:
            return 1
