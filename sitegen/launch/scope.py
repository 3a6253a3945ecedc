"""What actions of a launch file set for those after them."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

from sitegen.launch import python
from sitegen.rclyaml import Value


@dataclass
class Scope:
    """The state at one point of a launch file."""

    file: Path
    variables: dict[str, str]
    namespace: str = ""
    remaps: dict[str, str] = field(default_factory=dict)
    # Those of all nodes: names with values, and parameter files.
    parameters: list[tuple[str, Value] | Path] = field(default_factory=list)
    depth: int = 0
    # The functions of the launch file that led to the current actions.
    calls: tuple[python.Call, ...] = ()

    def inner(self) -> Scope:
        """Return the scope of a group: as in launch_ros, what is added to rules does not end."""
        return replace(
            self,
            variables=dict(self.variables),
            remaps=self.remaps or {},
            parameters=self.parameters or [],
        )

    def of_group(self, *, scoped: bool, forwarding: bool) -> Scope:
        """Return the scope of a group; without `forwarding`, nothing is set in it."""
        if not scoped:
            return self
        empty = Scope(self.file, {}, depth=self.depth, calls=self.calls)
        return self.inner() if forwarding else empty
