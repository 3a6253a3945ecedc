"""Evaluate the actions of a launch file that wait for an event, or act on running nodes."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import cast

from sitegen.errors import Problems
from sitegen.launch import without
from sitegen.launch.handlers import Handlers, Waiting
from sitegen.launch.names import joined
from sitegen.launch.scope import Scope
from sitegen.launch.substitutions import SubstitutionError
from sitegen.launch.texts import Texts
from sitegen.launch.tree import Action
from sitegen.launch.types import typed
from sitegen.model import Effect, Event, Node
from sitegen.model.launch import EventKind

# Natively, a program is started again at once; on a page, one that fails would keep it busy (s).
SHORTEST_RESPAWN = 1.0
CONFIGURE, ACTIVATE = 1, 3
LEVELS = ("debug", "info", "warning", "error")


class Events:
    """Evaluates them with `texts`, and adds notes to `notes`."""

    def __init__(self, texts: Texts, notes: Problems) -> None:
        self._texts = texts
        self._notes = notes
        self.handlers = Handlers(notes)
        self.actions: dict[str, Callable[[Action, Scope], object]] = {
            "change_state": self._change_state,
            "event_handler": self._handler,
            "lifecycle_transition": self._transitions,
            "log": self._log,
            **{f"log_{level}": partial(self._log, level=level) for level in LEVELS},
            "ros_timer": self._timer,
            "shutdown": self._shutdown,
            "stop": self._stop,
            "timer": self._timer,
        }

    def of_node(self, node: Node, action: Action, scope: Scope) -> None:
        """Add what is done when a node starts and when it ends."""
        handlers, location = self.handlers, action.location
        handlers.started(node.name, action)
        if action.kind == "lifecycle_node":
            full = f"{node.namespace}/{node.remap['__node']}"
            handlers.managed(node.name, full, action)
            if self._texts.is_true(action, "autostart", scope):
                change = Effect("transition", (full,), ids=(CONFIGURE, ACTIVATE))
                handlers.do(change, location, on=Event("started", (node.name,)))
        exited = Event("exited", (node.name,))
        for end in action.of_kind("on_exit"):
            if why := end.attributes.get("why"):
                self._notes.add(location, "on_exit", why)
            else:
                handlers.wait(Waiting(exited, end.inside, scope, location))
        if "on_exit" in action.attributes:
            if (given := self._texts.text(action, "on_exit", scope)) != "shutdown":
                raise ValueError(f"'on_exit' is 'shutdown' or is left out, not '{given}'")
            handlers.do(Effect("shutdown"), location, on=exited)
        if self._texts.is_true(action, "respawn", scope):
            self._respawn(node, action, scope)

    def _respawn(self, node: Node, action: Action, scope: Scope) -> None:
        given = self._texts.text(action, "respawn_delay", scope)
        delay = typed(given, "float") if given else 0
        if delay < 0:
            raise ValueError(f"'respawn_delay' is not a non-negative number: {given}")
        most = self._texts.text(action, "respawn_max_retries", scope)
        on = Event("ended", (node.name,), max(delay, SHORTEST_RESPAWN))
        count = max(typed(most, "int"), -1) if most else -1
        self.handlers.do(Effect("start", (node.name,)), action.location, on=on, most=count)

    def _timer(self, action: Action, scope: Scope) -> None:
        period = typed(self._texts.needed(action, "period", scope), "float")
        everyones = dict(each for each in scope.parameters if isinstance(each, tuple))
        is_simulated = everyones.get("use_sim_time") is True
        on = Event("time", after=period, ros_time=action.kind == "ros_timer" and is_simulated)
        self.handlers.wait(Waiting(on, action.inside, scope, action.location, most=1))

    def _handler(self, action: Action, scope: Scope) -> None:
        if why := action.attributes.get("why"):
            self._notes.add(action.location, action.kind, why)
            return
        text = partial(self._texts.text, action, scope=scope)
        target = action.attributes.get("target")
        on = Event(
            cast(EventKind, action.attributes["event"]),
            nodes=(target,) if target else (),
            transition=text("transition"),
            start_state=text("start_state"),
            goal_state=text("goal_state"),
        )
        most = 1 if self._texts.is_true(action, "once", scope) else -1
        self.handlers.wait(Waiting(on, action.inside, scope, action.location, most))

    def _shutdown(self, action: Action, scope: Scope) -> None:
        reason = self._texts.text(action, "reason", scope)
        if self.handlers.inside:
            self.handlers.do(Effect("shutdown", text=reason), action.location)
        else:
            self._notes.add(action.location, action.kind, without.SHUTDOWN)

    def _stop(self, action: Action, scope: Scope) -> None:
        if nodes := self._meant(action, scope):
            self.handlers.do(Effect("stop", nodes), action.location)

    def _change_state(self, action: Action, scope: Scope) -> None:
        number = typed(self._texts.needed(action, "transition", scope), "int")
        if nodes := self._meant(action, scope):
            self.handlers.do(Effect("transition", nodes, ids=(number,)), action.location)

    def _meant(self, action: Action, scope: Scope) -> tuple[str, ...]:
        """Return the node that an event is for, by its name or by the id of its action."""
        if why := action.attributes.get("why"):
            self._notes.add(action.location, action.kind, why)
            return ()
        if "target" in action.attributes:
            return (action.attributes["target"],)
        return (joined("", self._texts.needed(action, "node", scope)),)

    def _transitions(self, action: Action, scope: Scope) -> None:
        texts = self._texts
        ids = tuple(
            typed(texts.needed(each, "value", scope), "int")
            for each in action.of_kind("transition_id")
        )
        for each in action.of_kind("lifecycle_node_name"):
            name = joined("", texts.needed(each, "value", scope))
            self.handlers.do(Effect("transition", (name,), ids=ids), action.location)

    def _log(self, action: Action, scope: Scope, *, level: str = "info") -> None:
        level = action.attributes.get("level", level).lower()
        try:
            text = self._texts.text(action, "message", scope)
        except (SubstitutionError, ValueError) as error:
            self._notes.add(action.location, action.kind, f"this line is left out: {error}")
        else:
            shown = self._texts.on_page(text)
            self.handlers.do(Effect("log", text=shown, level=level), action.location)
