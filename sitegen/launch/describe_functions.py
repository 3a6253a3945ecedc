"""The functions in Python launch files that are called with the launch arguments.

The arguments are known only when the description is evaluated. So the file is run anew for each
call, with all calls that led to it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from sitegen.launch.describe_actions import Context, Described, text

# In the order in which the file creates them, which is the same in every run.
CALLS: list[Callable[[Context], Any]] = []


def function(
    *,
    function: Callable[..., Any],
    args: Iterable[Any] | None = None,
    kwargs: Mapping[str, Any] | None = None,
    condition: Any = None,
    **_: Any,
) -> Described:
    """Stand in for OpaqueFunction."""
    CALLS.append(lambda context: function(context, *(args or ()), **(kwargs or {})))
    return Described("function", number=len(CALLS) - 1, condition=condition)


def called(number: int, variables: Mapping[str, str]) -> Described:
    """Return what a function describes, preceded by the arguments that it sets."""
    context = Context(variables)
    found = CALLS[number](context)
    fresh = context.launch_configurations.items() - dict(variables).items()
    lets = [Described("let", name=name, value=text(value)) for name, value in sorted(fresh)]
    given = found if isinstance(found, (list, tuple)) else [found] if found is not None else []
    return Described("launch", [*lets, *given])


def perform_substitutions(context: Context, given: Any) -> str:
    """Stand in for the function of that name."""
    return context.perform_substitution(given)


def normalized(given: Any) -> list[Any]:
    """Stand in for normalize_to_list_of_substitutions."""
    return list(given) if isinstance(given, (list, tuple)) else [given]


MEMBERS: dict[str, Any] = {
    "OpaqueFunction": function,
    "LaunchContext": Context,
    "perform_substitutions": perform_substitutions,
    "normalize_to_list_of_substitutions": normalized,
}
