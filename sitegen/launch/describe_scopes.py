"""Arguments, groups, includes and the substitutions that read them, in Python launch files."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Mapping
from typing import Any

from sitegen.launch.describe_actions import Described, Text, pairs, text


def argument(
    name: Any,
    *,
    default_value: Any = None,
    description: Any = None,
    choices: Iterable[Any] | None = None,
    condition: Any = None,
) -> Described:
    """Describe an argument of the launch file."""
    inside = [Described("choice", value=choice) for choice in choices or ()]
    return Described(
        "arg",
        inside,
        name=name,
        default=default_value,
        description=description,
        condition=condition,
    )


def boolean(
    name: Any, *, default_value: Any = None, description: Any = None, condition: Any = None
) -> Described:
    """Describe an argument that is a boolean."""
    return Described(
        "bool_arg",
        name=name,
        default=default_value,
        description=description,
        condition=condition,
    )


def group(
    actions: Iterable[Any],
    *,
    scoped: Any = True,
    forwarding: Any = True,
    launch_configurations: Mapping[Any, Any] | None = None,
    condition: Any = None,
) -> Described:
    """Describe a group, with the arguments that it sets."""
    inside = [*pairs("keep", (launch_configurations or {}).items()), *actions]
    return Described("group", inside, scoped=scoped, forwarding=forwarding, condition=condition)


def include(
    launch_description_source: Any,
    *,
    launch_arguments: Any = (),
    condition: Any = None,
    **_: Any,
) -> Described:
    """Describe an included launch file; its arguments are pairs or keywords."""
    given = launch_arguments.items() if isinstance(launch_arguments, Mapping) else launch_arguments
    inside = pairs("arg", given or ())
    return Described("include", inside, file=launch_description_source, condition=condition)


def environment(name: Any, *, default_value: Any = None) -> Text:
    """Stand in for EnvironmentVariable."""
    default = "" if default_value is None else f" '{text(default_value)}'"
    return Text(f"$(env {text(name)}{default})")


def configuration(variable_name: Any, default: Any = None, **_: Any) -> Text:
    """Stand in for LaunchConfiguration."""
    given = "" if default is None else f" {shlex.quote(text(default))}"
    return Text(f"$(var {text(variable_name)}{given})")


def setting(name: Any, *, default: Any = None) -> Text:
    """Stand in for the substitution Parameter, a parameter that was set for all nodes."""
    parts = default if isinstance(default, (list, tuple)) else [default]
    whole = "".join(part.written() if isinstance(part, Text) else str(part) for part in parts)
    return Text(f"$(param {text(name)}{'' if default is None else f' {shlex.quote(whole)}'})")


def command(command: Any, **_: Any) -> Text:
    """Stand in for Command; its parts are joined to one command line."""
    line = text(command)
    quote = '"' if "'" in line else "'"
    return Text(f"$(command {quote}{line}{quote})")
