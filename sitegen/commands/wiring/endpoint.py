"""The endpoints of a program as its sources tell them."""

from __future__ import annotations

from dataclasses import dataclass, field

from sitegen.errors import Location

# What programs use besides endpoints: they declare parameters, have managed nodes, publish
# transforms, or parse options of their command line.
PARAMETERS, LIFECYCLE, TRANSFORMS, OPTIONS = "parameters", "lifecycle", "transforms", "options"
PUBLISHER, SUBSCRIPTION, SERVICE, CLIENT = "publisher", "subscription", "service", "client"
ACTION, ACTION_CLIENT = "action", "action client"
# The kinds that clients create by a function of the node: create_publisher and so on.
KINDS = (PUBLISHER, SUBSCRIPTION, SERVICE, CLIENT)
# The kind of the endpoints that a kind communicates with.
OPPOSITE = {
    **{PUBLISHER: SUBSCRIPTION, SUBSCRIPTION: PUBLISHER},
    **{SERVICE: CLIENT, CLIENT: SERVICE},
    **{ACTION: ACTION_CLIENT, ACTION_CLIENT: ACTION},
}


@dataclass(frozen=True)
class Endpoint:
    """An endpoint of a topic, a service or an action that a source or a widget creates.

    `type` is like std_msgs/msg/String, or empty if it is unknown. An endpoint that is not `sure`
    may exist or not: it causes no warning, but it may be the counterpart of others. A `foreign` one
    may belong to another program of the package. It may have one of the names in `instead` in place
    of its own.
    """

    kind: str
    name: str
    type: str
    location: Location
    sure: bool = True
    foreign: bool = False
    instead: frozenset[str] = frozenset()

    @property
    def names(self) -> frozenset[str]:
        """All names that it may have."""
        return self.instead | {self.name}


@dataclass
class Program:
    """What the sources of a program tell.

    An `open` program may have endpoints that are not known; one that `renames` may create its
    endpoints under other names. `names` are the names of its nodes, `namespaces` theirs; None
    stands for one that is known only at run time. `uses` names what else it does: PARAMETERS,
    LIFECYCLE, TRANSFORMS or OPTIONS. `arguments` are the arguments that it reads, by position from
    1, and whether each is a number.
    """

    endpoints: list[Endpoint] = field(default_factory=list)
    open: bool = False
    renames: bool = False
    names: set[str | None] = field(default_factory=set)
    namespaces: set[str | None] = field(default_factory=set)
    uses: set[str] = field(default_factory=set)
    arguments: dict[int, bool] = field(default_factory=dict)

    def take(self, other: Program) -> None:
        """Add what another source of the same program tells."""
        self.endpoints += other.endpoints
        self.open = self.open or other.open
        self.renames = self.renames or other.renames
        self.names |= other.names
        self.namespaces |= other.namespaces
        self.uses |= other.uses
        for position, is_number in other.arguments.items():
            self.arguments[position] = self.arguments.get(position, False) or is_number
