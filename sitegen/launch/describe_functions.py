"""The functions that launch files in Python hand over, to be called with the arguments at hand.

What those are is known to who goes through the description. So the file is run anew for each call,
with the calls that led to it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from sitegen.launch.describe_actions import Context, Described, text

# In the order in which the file makes them, the same in every run.
CALLS: list[Callable[[Context], Any]] = []


def function(
    *,
    function: Callable[..., Any],
    args: Iterable[Any] | None = None,
    kwargs: Mapping[str, Any] | None = None,
    condition: Any = None,
    **_: Any,
) -> Described:
    """Stand for OpaqueFunction."""
    CALLS.append(lambda context: function(context, *(args or ()), **(kwargs or {})))
    return Described("function", number=len(CALLS) - 1, condition=condition)


def called(number: int, variables: Mapping[str, str]) -> Described:
    """Return what a function describes; arguments that it sets come first."""
    context = Context(variables)
    found = CALLS[number](context)
    fresh = context.launch_configurations.items() - dict(variables).items()
    lets = [Described("let", name=name, value=text(value)) for name, value in sorted(fresh)]
    given = found if isinstance(found, (list, tuple)) else [found] if found is not None else []
    return Described("launch", [*lets, *given])


def perform_substitutions(context: Context, given: Any) -> str:
    """Stand for the function of that name."""
    return context.perform_substitution(given)


def normalized(given: Any) -> list[Any]:
    """Stand for normalize_to_list_of_substitutions."""
    return list(given) if isinstance(given, (list, tuple)) else [given]


MEMBERS: dict[str, Any] = {
    "OpaqueFunction": function,
    "LaunchContext": Context,
    "perform_substitutions": perform_substitutions,
    "normalize_to_list_of_substitutions": normalized,
}
