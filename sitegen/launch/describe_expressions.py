"""Expressions of Python launch files, which are evaluated once all arguments are known."""

from __future__ import annotations

from typing import Any
from urllib.parse import quote

from sitegen.launch.describe_actions import Condition, Text


def expression(*parts: Any) -> Text:
    """Return the substitution for a Python expression given in parts."""
    return Text(f"$(expression {' '.join(_words(parts))})")


def equal(left: Any, right: Any = None, operator: str = "==") -> Text:
    """Stand in for EqualsSubstitution."""
    return expression("'''", left, f"''' {operator} '''", "" if right is None else right, "'''")


def either(value: Any, if_value: Any = "", else_value: Any = "") -> Text:
    """Stand in for IfElseSubstitution."""
    parts = ("'''", if_value, "''' if ", _is_true(value), " else '''", else_value, "'''")
    return expression(*parts)


def _is_true(value: Any) -> tuple[Any, ...]:
    return ("('''", value, "'''.strip().lower() in ('true', '1'))")


def _configuration(name: Any) -> Text:
    return Text(f"$(var {name})")


def _words(parts: Any) -> list[str]:
    """Return parts as words: "=" marks literal text, "+" a nested substitution."""
    if isinstance(parts, (list, tuple)):
        return [word for part in parts for word in _words(part)]
    other = getattr(parts, "text", None)
    if other is not None and "$(" in other:
        return [f"+{other}"]
    return [f"={quote(str(parts) if other is None else other, safe='')}"]


MEMBERS: dict[str, Any] = {
    "PythonExpression": lambda parts, *_: expression(parts),
    "EqualsSubstitution": equal,
    "NotEqualsSubstitution": lambda left, right: equal(left, right, "!="),
    "AndSubstitution": lambda left, right: expression(_is_true(left), " and ", _is_true(right)),
    "OrSubstitution": lambda left, right: expression(_is_true(left), " or ", _is_true(right)),
    "AnySubstitution": lambda *all_: expression(
        "any([", *((*_is_true(a), ",") for a in all_), "])"
    ),
    "AllSubstitution": lambda *all_: expression(
        "all([", *((*_is_true(a), ",") for a in all_), "])"
    ),
    "NotSubstitution": lambda value: expression("not ", _is_true(value)),
    "IfElseSubstitution": either,
    "LaunchConfigurationEquals": lambda name, value: Condition(
        "if", equal(_configuration(name), value)
    ),
    "LaunchConfigurationNotEquals": lambda name, value: Condition(
        "unless", equal(_configuration(name), value)
    ),
}
