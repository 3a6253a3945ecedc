"""A launch file as it is written: actions with attributes, in XML and YAML alike."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from sitegen.errors import Location


@dataclass(frozen=True)
class Action:
    """An action like `node` or `group`: its attributes as text, and what stands inside of it."""

    kind: str
    attributes: dict[str, str]
    location: Location
    inside: list[Action] = field(default_factory=list)

    def of_kind(self, *kinds: str) -> Iterator[Action]:
        """Yield what stands inside and is of one of these kinds."""
        return (each for each in self.inside if each.kind in kinds)


class UnreadableError(Exception):
    """A launch file cannot be read: where, and why."""

    def __init__(self, location: Location, message: str) -> None:
        super().__init__(message)
        self.location = location
