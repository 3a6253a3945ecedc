"""The substitutions that compare and combine values, such as $(and …) and $(equals …)."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable

from sitegen.launch.types import typed


def _is_true(text: str) -> bool:
    return bool(typed(text, "bool"))


def _shown(value: bool) -> str:
    return str(value).lower()


def equal(left: str, right: str) -> bool:
    """Return whether two texts are equal as booleans, as numbers, or letter by letter."""
    booleans = ("true", "false", "1", "0")
    if left.lower() in booleans and right.lower() in booleans:
        return (left.lower() in ("true", "1")) == (right.lower() in ("true", "1"))
    try:
        return math.isclose(float(left), float(right))
    except ValueError:
        return left == right


def chosen(condition: str, if_value: str, else_value: str = "") -> str:
    """Return one of two texts."""
    return if_value if _is_true(condition) else else_value


def anonymous(name: str) -> str:
    """Return a name that no other node is likely to have, the same one in each build."""
    digest = hashlib.sha256(name.encode()).hexdigest()[:8]
    return f"{name}_{digest}".translate(str.maketrans(".-:", "___"))


SUBSTITUTIONS: dict[str, Callable[..., str]] = {
    "not": lambda value: _shown(not _is_true(value)),
    "and": lambda left, right: _shown(_is_true(left) & _is_true(right)),
    "or": lambda left, right: _shown(_is_true(left) | _is_true(right)),
    "any": lambda *values: _shown(any([_is_true(value) for value in values])),
    "all": lambda *values: _shown(all([_is_true(value) for value in values])),
    "equals": lambda left, right: _shown(equal(left, right)),
    "not_equals": lambda left, right: _shown(not equal(left, right)),
    "if": chosen,
    "anon": anonymous,
}
