"""What actions of a launch file set for those after them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from sitegen.launch import python
from sitegen.launch.environment import Environment
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
    environment: Environment = field(default_factory=Environment)
    # The variables of the loops around.
    loop: Mapping[str, str] = field(default_factory=dict)
    depth: int = 0
    # The number of times that a file or a function had been read before.
    reading: int = 0
    # The functions of the launch file that led to the current actions.
    calls: tuple[python.Call, ...] = ()
    # What was set aside for later: the environment, and the rest.
    environments: list[Environment] = field(default_factory=list)
    configurations: list[Scope] = field(default_factory=list)

    @property
    def is_python(self) -> bool:
        """Whether a Python file describes the actions; texts have escapes in other files only."""
        return self.file.suffix == ".py"

    def inner(self) -> Scope:
        """Return the scope of a group: as in launch_ros, what is added to rules does not end."""
        return replace(
            self,
            variables=dict(self.variables),
            environment=self.environment.copy(),
            remaps=self.remaps or {},
            parameters=self.parameters or [],
        )

    def of_group(self, *, scoped: bool, forwarding: bool) -> Scope:
        """Return the scope of a group; without `forwarding`, nothing is set in it."""
        if not scoped:
            return self
        fresh = Scope(Path(), {}, environment=self.environment.fresh())
        return self.inner() if forwarding else self.at(fresh)

    def at(self, other: Scope) -> Scope:
        """Return another state at this point of the launch file."""
        return replace(
            other,
            file=self.file,
            loop=self.loop,
            depth=self.depth,
            reading=self.reading,
            calls=self.calls,
        )

    def restore(self, other: Scope) -> None:
        """Set the arguments, the namespace and the rules to those of another scope."""
        kept = dict(other.variables)
        self.variables.clear()
        self.variables.update(kept)
        self.namespace, self.remaps, self.parameters = (
            other.namespace,
            other.remaps,
            other.parameters,
        )
