"""What a launch file starts, and what it does while its nodes run."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal

# "launched": the nodes that start at once run; "time": `after` seconds later, or after the event
# that the handler is inside of; "started", "exited": a node; "ended": a node that nobody stopped;
# "state": a lifecycle node; "shutdown": the launch file stops all nodes.
EventKind = Literal["launched", "time", "started", "exited", "ended", "state", "shutdown"]
EffectKind = Literal["start", "stop", "shutdown", "transition", "log", "handle"]


@dataclass(frozen=True)
class Event:
    """What a handler waits for.

    `nodes` are the names of the nodes that it is about, for "state" with their namespaces, or empty
    for all. With `ros_time`, the time is that of `/clock`, if a node publishes it. Empty states and
    transitions are any.
    """

    kind: EventKind
    nodes: tuple[str, ...] = ()
    after: float = 0
    ros_time: bool = False
    transition: str = ""
    start_state: str = ""
    goal_state: str = ""


@dataclass(frozen=True)
class Effect:
    """One thing that a launch file does while its nodes run.

    "transition" calls for the transitions `ids`, in their order, of the lifecycle nodes `nodes`,
    and "handle" waits for the event of another handler. `text` is a reason, or a line of the log;
    names between U+E000 and U+E001 in it, such as `event.returncode`, are what the event says.
    """

    kind: EffectKind
    nodes: tuple[str, ...] = ()
    text: str = ""
    level: str = ""
    ids: tuple[int, ...] = ()
    handler: Handler | None = None


@dataclass(frozen=True)
class Handler:
    """What a launch file does at an event, at most `most` times; -1 is always."""

    on: Event
    effects: tuple[Effect, ...]
    most: int = -1


@dataclass(frozen=True)
class Argument:
    """An argument that a launch file declares; a `default` of None makes it necessary.

    Without `choices`, any value is right.
    """

    name: str
    default: str | None = None
    description: str = ""
    choices: tuple[str, ...] = ()


@dataclass(frozen=True)
class Launch:
    """The launch file of a page: its package (or ""), its name, and the nodes that it starts.

    `arguments` are those that it and the files that it includes declare, `given` the values that
    the author gives, as are the variables in `environment`. `path` is that in the share folder of
    the package. `others` are nodes that it starts with other arguments only.
    """

    package: str
    file: str
    nodes: tuple[str, ...]
    handlers: tuple[Handler, ...] = ()
    arguments: tuple[Argument, ...] = ()
    given: Mapping[str, str] = field(default_factory=dict)
    environment: Mapping[str, str] = field(default_factory=dict)
    path: str = ""
    others: tuple[str, ...] = ()

    @property
    def first(self) -> tuple[str, ...]:
        """The nodes that start at once."""
        return tuple(name for name in self.nodes if name not in self.later)

    @property
    def later(self) -> frozenset[str]:
        """The nodes that handlers start."""
        return frozenset(started_by(self.handlers))


def started_by(handlers: Iterable[Handler]) -> Iterator[str]:
    """Yield the names of the nodes that handlers start first; what has ended ran before."""
    for handler in (each for each in handlers if each.on.kind != "ended"):
        for effect in handler.effects:
            if effect.kind == "start":
                yield from effect.nodes
            if effect.handler:
                yield from started_by([effect.handler])
