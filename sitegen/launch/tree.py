"""A launch file as a tree of actions with attributes, the same for XML and YAML."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from sitegen.errors import Location

# What the id of an action begins with, unlike the name of a node.
REFERENCE = "#"


@dataclass(frozen=True)
class Exact:
    """A string in which nothing is expanded."""

    text: str


# The value of a parameter as YAML and Python files give it; `str` is text with substitutions.
Given = bool | int | float | str | Exact | list["Given"]


@dataclass(frozen=True)
class Action:
    """An action like `node` or `group`: its attributes as text, and the actions inside it.

    `value` is that of a parameter, if the file gives it a type. `id` is that of an action in a
    Python file, to which other actions may refer.
    """

    kind: str
    attributes: dict[str, str]
    location: Location
    inside: list[Action] = field(default_factory=list)
    value: Given | None = None
    id: str = ""

    def of_kind(self, *kinds: str) -> Iterator[Action]:
        """Yield the actions inside it that are of one of these kinds."""
        return (each for each in self.inside if each.kind in kinds)


class UnreadableError(Exception):
    """A launch file cannot be read; says where and why."""

    def __init__(self, location: Location, message: str) -> None:
        super().__init__(message)
        self.location = location
