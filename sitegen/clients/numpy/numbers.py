"""The functions of numpy for single numbers, for programs that use no arrays of numpy.

Results are numpy's for floats; functions of whole numbers that return whole numbers return
Python's. Sequences raise a TypeError, because their results would be arrays.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from math import e as e
from math import inf, nan, pi
from typing import Any, SupportsFloat

__all__ = [
    *("arccos", "arcsin", "arctan", "arctan2", "clip", "cos", "deg2rad", "degrees", "e", "exp"),
    *("hypot", "inf", "isfinite", "isinf", "isnan", "log", "log10", "nan", "pi", "rad2deg"),
    *("radians", "sign", "sin", "sqrt", "tan"),
]

ADVICE = (
    "this page has only numpy's functions of single numbers; the build adds numpy itself with "
    "'pyodide: packages' in site.yaml"
)


class Number(float):
    """A float that divides by zero and raises to powers as numpy's do, without their warnings."""

    def __repr__(self) -> str:
        return f"np.float64({float(self)!r})"

    def __str__(self) -> str:
        return float.__repr__(self)

    __hash__ = float.__hash__


def _divided(a: float, b: float) -> float:
    if b:
        return a / b
    return nan if not a or a != a else math.copysign(inf, a) * math.copysign(1, b)


def _floor_divided(a: float, b: float) -> float:
    return a // b if b else _divided(a, b)


def _remainder(a: float, b: float) -> float:
    return a % b if b else nan


def _power(a: float, b: float) -> float:
    try:
        return math.pow(a, b)
    except OverflowError:
        return -inf if a < 0 and b % 2 == 1 else inf
    except ValueError:
        # 0 to a negative power, or a root of a negative number.
        if a:
            return nan
        return math.copysign(inf, a) if b % 2 == 1 else inf


def _operator(result: Callable[[float, float], float], *, swapped: bool) -> Callable[..., Any]:
    def operate(self: float, other: object) -> Any:
        if not isinstance(other, int | float):
            return NotImplemented
        a, b = float(self), float(other)
        return Number(result(b, a) if swapped else result(a, b))

    return operate


for _name, _result in {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "truediv": _divided,
    "floordiv": _floor_divided,
    "mod": _remainder,
    "pow": _power,
}.items():
    setattr(Number, f"__{_name}__", _operator(_result, swapped=False))
    setattr(Number, f"__r{_name}__", _operator(_result, swapped=True))
for _name in ("neg", "pos", "abs"):
    _of_float = getattr(float, f"__{_name}__")
    setattr(Number, f"__{_name}__", lambda self, of=_of_float: Number(of(self)))


def _number(value: SupportsFloat) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool):
        raise TypeError(f"'{type(value).__name__}' is not a number: {ADVICE}")
    return float(value)


def _function(function: Callable[..., float]) -> Callable[..., Number]:
    """Return a function that gives NaN where Python raises, as numpy does."""

    def of_numbers(*values: SupportsFloat) -> Number:
        given = [_number(value) for value in values]
        try:
            return Number(function(*given))
        except ValueError:
            return Number(nan)
        except OverflowError:
            return Number(inf)

    return of_numbers


def _of_logarithm(function: Callable[[float], float]) -> Callable[..., Number]:
    return _function(lambda x: function(x) if x else -inf)


def _test(function: Callable[[float], bool]) -> Callable[[SupportsFloat], bool]:
    return lambda value: function(_number(value))


sin, cos, tan = _function(math.sin), _function(math.cos), _function(math.tan)
arcsin, arccos, arctan = _function(math.asin), _function(math.acos), _function(math.atan)
arctan2, hypot = _function(math.atan2), _function(math.hypot)
deg2rad = radians = _function(lambda x: x * (pi / 180))
rad2deg = degrees = _function(lambda x: x * (180 / pi))
exp, sqrt = _function(math.exp), _function(math.sqrt)
log, log10 = _of_logarithm(math.log), _of_logarithm(math.log10)
isnan, isinf, isfinite = _test(math.isnan), _test(math.isinf), _test(math.isfinite)


def sign(value: float) -> float:
    """Return -1, 0 or 1, or NaN, as a number like `value`."""
    number = _number(value)
    found = nan if number != number else float((number > 0) - (number < 0))
    return int(found) if isinstance(value, int) else Number(found)


def clip(value: float, low: float, high: float) -> float:
    """Return `value`, or the limit that it exceeds; a float if any of the three is one."""
    every = [_number(value), _number(low), _number(high)]
    if any(one != one for one in every):
        return Number(nan)
    found = min(max(value, low), high)
    return int(found) if all(isinstance(one, int) for one in (value, low, high)) else Number(found)
