"""What sources say about the endpoints of a program, and what they leave open."""

from __future__ import annotations

from dataclasses import dataclass, field

from sitegen.errors import Location

PUBLISHER, SUBSCRIPTION, SERVICE, CLIENT = "publisher", "subscription", "service", "client"
KINDS = (PUBLISHER, SUBSCRIPTION, SERVICE, CLIENT)


@dataclass(frozen=True)
class Endpoint:
    """A publisher, subscription, service or client as a source or a widget makes it.

    `type` is like std_msgs/msg/String, empty where the source does not tell. One that is not `sure`
    may be there or not: nothing is wrong with it, but it may be the other side of others.
    """

    kind: str
    name: str
    type: str
    location: Location
    sure: bool = True


@dataclass
class Program:
    """What the sources of a program tell.

    `open` says that it may have endpoints that they do not tell, `renames` that it may give its
    endpoints other names than it writes. `names` are those of its nodes, `namespaces` theirs; None
    stands for one that only running the program would tell.
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
