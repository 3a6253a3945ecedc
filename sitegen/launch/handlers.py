"""Collect what a launch file does while its nodes run: timers, events, and changes of state.

As in launch, the actions of a handler are evaluated after everything else, with the arguments of
the launch file as they are then: a group has ended long before the timer in it fires.
"""

from __future__ import annotations

import heapq
import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from sitegen.errors import Location, Problems, nearest
from sitegen.launch import without
from sitegen.launch.scope import Scope
from sitegen.launch.tree import REFERENCE, Action
from sitegen.model import Effect, Event, Handler


@dataclass
class Waiting:
    """A handler whose actions are not evaluated yet; `at` is when, counted from the start (s)."""

    on: Event
    inside: Sequence[Action]
    scope: Scope
    location: Location
    most: int = -1
    at: float = math.inf
    effects: list[Effect | Waiting] = field(default_factory=list)


class Handlers:
    """Those of a launch file; names in them may be ids of actions until they are finished.

    What cannot happen on a page is noted in `notes`.
    """

    def __init__(self, notes: Problems) -> None:
        self._notes = notes
        self._found: list[Waiting] = []
        self._queue: list[tuple[float, int, Waiting]] = []
        self._order = itertools.count()
        self._current: Waiting | None = None
        # The names on the page of nodes, and the full names of lifecycle nodes, by ids of actions.
        self._nodes: dict[str, str] = {}
        self._managed: dict[str, str] = {}
        # The names on the page of the lifecycle nodes, by their full names.
        self._full: dict[str, str] = {}
        self._skipped: set[str] = set()

    def wait(self, waiting: Waiting) -> None:
        """Add a handler, whose actions are evaluated later."""
        into = self._current.effects if self._current else self._found
        if waiting.on.kind == "time":
            since = self._current.at if self._current else 0.0
            waiting.at = since + waiting.on.after
        into.append(waiting)
        heapq.heappush(self._queue, (waiting.at, next(self._order), waiting))

    def do(
        self, effect: Effect, location: Location, *, on: Event | None = None, most: int = -1
    ) -> None:
        """Do something in the handler that is evaluated, or `on` an event."""
        if self._current and not on:
            self._current.effects.append(effect)
        else:
            event = on or Event("launched")
            empty = Scope(location.file, {})
            self._found.append(Waiting(event, (), empty, location, most, effects=[effect]))

    @property
    def inside(self) -> bool:
        """Whether the actions of a handler are evaluated."""
        return self._current is not None

    def started(self, name: str, action: Action) -> None:
        """Note the node that `action` starts: at once, or in the handler that is evaluated."""
        self._nodes[action.id] = name
        if self._current:
            self._current.effects.append(Effect("start", (name,)))

    def managed(self, name: str, full: str, action: Action) -> None:
        """Note a lifecycle node by its full name."""
        self._managed[action.id] = full
        self._full[full] = name

    def skipped(self, action: Action) -> None:
        """Note an action that starts nothing on the page."""
        self._skipped.add(action.id)

    def evaluate(self, evaluate: Callable[[list[Action], Scope], None], last: Scope) -> None:
        """Evaluate the actions of all handlers, in the order of time; `last` is the final scope.

        What a handler waits for may be started by another one. If nothing starts it, the actions
        of the handler are not evaluated, so their nodes are not on the page.
        """
        unknown: list[Waiting] = []
        while self._queue:
            _, _, waiting = heapq.heappop(self._queue)
            about = [name for name in waiting.on.nodes if name.startswith(REFERENCE)]
            if not all(name in self._nodes or name in self._skipped for name in about):
                unknown.append(waiting)
                continue
            if waiting.on.kind != "started" and not self._skipped.isdisjoint(about):
                self._notes.add(waiting.location, "event_handler", without.NOT_HERE)
                continue
            self._current = waiting
            evaluate(list(waiting.inside), waiting.scope.at(last))
            self._current = None
            for each in unknown:
                heapq.heappush(self._queue, (each.at, next(self._order), each))
            unknown.clear()

    def finished(self) -> tuple[Handler, ...]:
        """Return the handlers that do something on the page."""
        return tuple(self._finished(self._found))

    def _finished(self, found: Iterable[Waiting]) -> Iterator[Handler]:
        for each in found:
            on = self._event(each)
            effects = tuple(self._effects(each.effects, each.location)) if on else ()
            if on and on.kind == "launched":
                yield from map(self._at_start, effects)
            elif on and effects:
                yield Handler(on, effects, each.most)

    def _at_start(self, effect: Effect) -> Handler:
        """Return what is done at once; visitors start nodes again, and their states change anew."""
        is_change = effect.kind == "transition"
        names = tuple(self._full[full] for full in effect.nodes) if is_change else ()
        return Handler(Event("started", names) if names else Event("launched"), (effect,))

    def _event(self, each: Waiting) -> Event | None:
        """Return the event of a handler with the names of nodes, None if it cannot happen."""
        if each.on.kind == "state" and not each.on.nodes:
            return replace(each.on, nodes=tuple(self._full)) if self._full else None
        names = self._managed if each.on.kind == "state" else self._nodes
        given = [names.get(name, name) for name in each.on.nodes]
        if missing := [name for name in given if name.startswith(REFERENCE)]:
            if each.on.kind == "started" and missing[0] in self._skipped:
                # What starts after a program that is skipped starts with all others.
                return Event("launched")
            return None
        return replace(each.on, nodes=tuple(given))

    def _effects(self, effects: Iterable[Effect | Waiting], location: Location) -> Iterator[Effect]:
        for effect in effects:
            if isinstance(effect, Waiting):
                yield from (Effect("handle", handler=each) for each in self._finished([effect]))
            elif effect.kind == "transition":
                known = tuple(self._known(effect.nodes, location))
                yield from (replace(effect, nodes=(name,)) for name in known)
            else:
                given = [self._nodes.get(name, name) for name in effect.nodes]
                nodes = tuple(name for name in given if not name.startswith(REFERENCE))
                if nodes or not given:
                    yield replace(effect, nodes=nodes)

    def _known(self, names: Iterable[str], location: Location) -> Iterator[str]:
        """Yield the full names of lifecycle nodes, and note those that the file does not start."""
        for name in names:
            full = self._managed.get(name, name)
            if full in self._full:
                yield full
            elif not name.startswith(REFERENCE) or name in self._skipped:
                shown = f"no lifecycle node '{name}' in this launch file"
                advice = nearest(name, self._full) if self._full else "nothing changes its state"
                self._notes.add(location, "lifecycle_transition", f"{shown}; {advice}")
