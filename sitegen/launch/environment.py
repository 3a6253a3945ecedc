"""The environment variables that a launch file sets for its nodes."""

from __future__ import annotations

import os
from collections.abc import Mapping

from sitegen.workspace.manifest import ENVIRONMENT

# A page shows the values of its launch file to everyone, so the environment of the author's
# computer is not read, except for what ROS is configured with.
PUBLIC = ("ROS_", "RMW_", "RCUTILS_")


class Environment:
    """What a launch file has changed so far; the value of an unset variable is None.

    `given` is what the author of the page sets before, to which it can be reset.
    """

    def __init__(self, given: Mapping[str, str | None] | None = None) -> None:
        self._given = dict(given or {})
        self.changes = dict(self._given)

    def copy(self) -> Environment:
        """Return the same, which does not follow later changes."""
        copied = self.fresh()
        copied.changes = dict(self.changes)
        return copied

    def fresh(self) -> Environment:
        """Return what there was before the launch file changed it."""
        return Environment(self._given)

    def __contains__(self, name: str) -> bool:
        """Return whether a launch file may ask for the variable."""
        return name in self.changes or name.startswith(PUBLIC)

    def value(self, name: str) -> str | None:
        """Return the value of a variable, None if it is not set."""
        if name in self.changes or name not in self:
            return self.changes.get(name)
        return ENVIRONMENT.get(name, os.environ.get(name))

    def append(self, name: str, value: str, separator: str, *, prepend: bool) -> None:
        """Append a value to that of a variable, or put it before."""
        before = self.value(name)
        parts = [value] if before is None else [value, before] if prepend else [before, value]
        self.changes[name] = separator.join(parts)

    def of_node(self, own: Mapping[str, str], *, alone: bool) -> dict[str, str]:
        """Return the variables of a node with some of its own, or with these `alone`."""
        inherited = {} if alone else self.changes
        return {name: value for name, value in {**inherited, **own}.items() if value is not None}
