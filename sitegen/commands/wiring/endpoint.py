"""The endpoints of a program as its sources tell them."""

from __future__ import annotations

from dataclasses import dataclass, field

from sitegen.errors import Location

PUBLISHER, SUBSCRIPTION, SERVICE, CLIENT = "publisher", "subscription", "service", "client"
KINDS = (PUBLISHER, SUBSCRIPTION, SERVICE, CLIENT)


@dataclass(frozen=True)
class Endpoint:
    """A publisher, subscription, service or client that a source or a widget creates.

    `type` is like std_msgs/msg/String, or empty if it is unknown. An endpoint that is not `sure`
    may exist or not: it causes no warning, but it may be the counterpart of others. It may have one
    of the names in `instead` in place of its own.
    """

    kind: str
    name: str
    type: str
    location: Location
    sure: bool = True
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
    stands for one that is known only at run time.
    """

    endpoints: list[Endpoint] = field(default_factory=list)
    open: bool = False
    renames: bool = False
    names: set[str | None] = field(default_factory=set)
    namespaces: set[str | None] = field(default_factory=set)

    def take(self, other: Program) -> None:
        """Add what another source of the same program tells."""
        self.endpoints += other.endpoints
        self.open = self.open or other.open
        self.renames = self.renames or other.renames
        self.names |= other.names
        self.namespaces |= other.namespaces
