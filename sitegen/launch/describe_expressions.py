"""Expressions of Python launch files, which are evaluated once all arguments are known."""

from __future__ import annotations

from functools import partial
from typing import Any
from urllib.parse import quote

from sitegen.launch.describe_actions import Condition, Text


def evaluated(*parts: Any) -> Text:
    """Return the substitution for a Python expression given in parts."""
    return Text(f"$(expression {' '.join(_words(parts))})")


def applied(name: str, *arguments: Any) -> Text:
    """Return a substitution with these arguments."""
    words = " , ".join(" ".join(_words(argument)) for argument in arguments)
    return Text(f"$(apply {name} {words})")


def equal(left: Any, right: Any = None, name: str = "equals") -> Text:
    """Stand in for EqualsSubstitution."""
    return applied(name, *(_shown(value) for value in (left, right)))


def _shown(value: Any) -> Any:
    if isinstance(value, bool):
        return str(value).lower()
    return "" if value is None else value


def compared(kind: str, launch_configuration_name: Any, expected_value: Any) -> Condition:
    """Stand in for LaunchConfigurationEquals, and for its opposite."""
    return Condition(kind, equal(Text(f"$(var {launch_configuration_name})"), expected_value))


def _words(parts: Any) -> list[str]:
    """Return parts as words: "=" marks literal text, "+" a nested substitution."""
    if isinstance(parts, (list, tuple)):
        return [word for part in parts for word in _words(part)]
    words = parts.written() if isinstance(parts, Text) else str(parts)
    if isinstance(parts, Text) and "$(" in words:
        return [f"+{words}"]
    return [f"={quote(words, safe='')}"]


def looped(name: Any, *, default_value: Any = None) -> Text:
    """Stand in for ForEachVar."""
    return applied("for_var", name, *([] if default_value is None else [default_value]))


# Files give arguments by the names that they have in launch.
MEMBERS: dict[str, Any] = {
    "ForEachVar": looped,
    "ForLoopIndex": lambda name: applied("index", name),
    "PathJoinSubstitution": lambda substitutions: applied("path_join", *substitutions),
    "StringJoinSubstitution": lambda substitutions, delimiter="": applied(
        "string_join", delimiter, *substitutions
    ),
    "PythonExpression": lambda expression, python_modules=(): evaluated(expression),
    "EqualsSubstitution": equal,
    "NotEqualsSubstitution": lambda left, right: equal(left, right, "not_equals"),
    "AndSubstitution": lambda left, right: applied("and", left, right),
    "OrSubstitution": lambda left, right: applied("or", left, right),
    "AnySubstitution": lambda *all_: applied("any", *all_),
    "AllSubstitution": lambda *all_: applied("all", *all_),
    "NotSubstitution": lambda value: applied("not", value),
    "BooleanSubstitution": lambda value: applied("not", applied("not", value)),
    "IfElseSubstitution": lambda condition, if_value="", else_value="": applied(
        "if", condition, if_value, else_value
    ),
    "AnonName": lambda name: applied("anon", name),
    "LaunchConfigurationEquals": partial(compared, "if"),
    "LaunchConfigurationNotEquals": partial(compared, "unless"),
}
