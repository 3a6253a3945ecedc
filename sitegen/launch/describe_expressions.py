"""What launch files in Python have for expressions, evaluated once all arguments are known."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any
from urllib.parse import quote


def members(
    substitution: Callable[[str], Any], condition: Callable[[str, Any], Any]
) -> dict[str, Any]:
    """Return what stands for their names, made of `substitution` and `condition`."""

    def expression(*parts: Any) -> Any:
        return substitution(f"$(expression {' '.join(_words(parts))})")

    def is_true(value: Any) -> tuple[Any, ...]:
        return ("('''", value, "'''.strip().lower() in ('true', '1'))")

    def equal(left: Any, right: Any = None, operator: str = "==") -> Any:
        return expression("'''", left, f"''' {operator} '''", "" if right is None else right, "'''")

    def either(value: Any, if_value: Any = "", else_value: Any = "") -> Any:
        parts = ("'''", if_value, "''' if ", is_true(value), " else '''", else_value, "'''")
        return expression(*parts)

    def configuration(name: Any) -> Any:
        return substitution(f"$(var {name})")

    return {
        "PythonExpression": lambda parts, *_: expression(parts),
        "EqualsSubstitution": equal,
        "NotEqualsSubstitution": lambda left, right: equal(left, right, "!="),
        "AndSubstitution": lambda left, right: expression(is_true(left), " and ", is_true(right)),
        "OrSubstitution": lambda left, right: expression(is_true(left), " or ", is_true(right)),
        "AnySubstitution": lambda *all_: expression(
            "any([", *((*is_true(a), ",") for a in all_), "])"
        ),
        "AllSubstitution": lambda *all_: expression(
            "all([", *((*is_true(a), ",") for a in all_), "])"
        ),
        "NotSubstitution": lambda value: expression("not ", is_true(value)),
        "IfElseSubstitution": either,
        "LaunchConfigurationEquals": lambda name, value: condition(
            "if", equal(configuration(name), value)
        ),
        "LaunchConfigurationNotEquals": lambda name, value: condition(
            "unless", equal(configuration(name), value)
        ),
    }


def _words(parts: Any) -> list[str]:
    """Return parts as words: behind "=" what stands there, behind "+" another substitution."""
    if isinstance(parts, (list, tuple)):
        return [word for part in parts for word in _words(part)]
    other = getattr(parts, "text", None)
    if other is not None and "$(" in other:
        return [f"+{other}"]
    return [f"={quote(str(parts) if other is None else other, safe='')}"]
