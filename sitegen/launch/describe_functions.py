"""The functions in Python launch files that are called with the launch arguments.

The arguments are known only when the description is evaluated. So the file is run anew for each
call, with all calls that led to it. The same holds for substitutions that a file, or a module of
the workspace, defines itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from sitegen.launch.describe_actions import RUN, Context, Described, Text, inside_of, pairs

# The functions, each called with the context and keyword arguments, and the lines of their actions,
# in the order in which the file creates them, which is the same in every run.
CALLS: list[tuple[Callable[..., Any], int]] = []


def function(
    *,
    function: Callable[..., Any],
    args: Iterable[Any] | None = None,
    kwargs: Mapping[str, Any] | None = None,
    condition: Any = None,
    **_: Any,
) -> Described:
    """Stand in for OpaqueFunction."""

    def call(context: Context) -> Any:
        return function(context, *(args or ()), **(kwargs or {}))

    return _noted("function", call, condition=condition)


def each(input_values: Any, *, function: Callable[..., Any], condition: Any = None) -> Described:
    """Stand in for ForEach."""
    call = _without_context(function)
    return _noted("for_each", call, values=input_values, condition=condition)


def loop(
    length: Any, *, function: Callable[..., Any], name: str | None = None, condition: Any = None
) -> Described:
    """Stand in for ForLoop."""
    call = _without_context(function)
    return _noted("for", call, len=length, name=name, condition=condition)


def _without_context(function: Callable[..., Any]) -> Callable[..., Any]:
    return lambda _, **given: function(**given)


def _noted(kind: str, call: Callable[..., Any], **attributes: Any) -> Described:
    described = Described(kind, number=len(CALLS), **attributes)
    CALLS.append((call, described.line))
    return described


def called(
    number: int,
    variables: Mapping[str, str],
    environment: Mapping[str, str | None],
    given: Mapping[str, Any],
) -> Described:
    """Return what a function describes, preceded by what it sets."""
    context = Context(variables, environment)
    call, RUN.line = CALLS[number]
    found = call(context, **given)
    fresh = context.launch_configurations.items() - dict(variables).items()
    sets = pairs("let", sorted(fresh))
    changed = context.environment.items() - environment.items()
    sets += pairs("set_env", sorted(changed))
    listed = found if isinstance(found, (list, tuple)) else [found] if found is not None else []
    return Described("launch", [*sets, *listed])


class Substitution(Text):
    """The base class of substitutions that are defined outside of launch: they perform themselves.

    Each has a number, by the order in which the file uses them, which is the same in every run.
    """

    def __init__(self) -> None:
        """Leave everything to the derived class."""

    def written(self) -> str:
        """Return the substitution as a text that is expanded later."""
        # Their classes may compare them in other ways.
        if all(each is not self for each in RUN.substitutions):
            RUN.substitutions.append(self)
        number = next(at for at, each in enumerate(RUN.substitutions) if each is self)
        return f"$(perform {number})"

    def describe(self) -> str:
        """Return a description for log messages."""
        return type(self).__name__

    def perform(self, context: Context) -> str:
        """Fail: the derived class has a method of its own."""
        raise NotImplementedError("it has no method perform()")


def perform_substitutions(context: Context, given: Any) -> str:
    """Stand in for the function of that name."""
    return context.perform_substitution(given)


MEMBERS: dict[str, Any] = {
    "ForEach": each,
    "ForLoop": loop,
    "OpaqueFunction": function,
    "Substitution": Substitution,
    "LaunchContext": Context,
    "perform_substitutions": perform_substitutions,
    "normalize_to_list_of_substitutions": inside_of,
}
