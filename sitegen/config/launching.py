"""The launch file of a page, and the widgets of what it starts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from sitegen.config.document import Value
from sitegen.config.layout import staged
from sitegen.config.nodes import Declared
from sitegen.errors import Problems
from sitegen.model import Handler, Part, Widget, leaves

# The widget that shows what the launch file does.
KIND = "launch"
# The most nodes whose consoles are in one grid with a 3D view.
FEW = 3


def with_panel(
    parts: Sequence[Part], given: Value | None, handlers: Iterable[Handler], problems: Problems
) -> list[Part]:
    """Return the content with the panel of the launch file `given`, if it has something to do."""
    shown = [part for part in leaves(parts) if isinstance(part, Widget) and part.kind == KIND]
    if not given:
        for widget in shown:
            message = "this page has no launch file; give it one with the key 'launch' of the page"
            problems.add(widget.location, KIND, message)
    elif not shown and any(_acts(handler) for handler in handlers):
        return [*parts, Widget(KIND, "", {}, given.location)]
    return list(parts)


def _acts(handler: Handler) -> bool:
    """Return whether a handler does more than writing to the log."""
    return any(
        effect.kind != "log" and (not effect.handler or _acts(effect.handler))
        for effect in handler.effects
    )


def panels(windows: Sequence[Part], nodes: Mapping[str, Declared]) -> tuple[list[Part], list[Part]]:
    """Return what a launch file shows, and the panels of its nodes, for a page without content.

    If there are many nodes, a 3D view that is the only window is on a stage, with these panels.
    """
    kinds = [part.kind for part in windows if isinstance(part, Widget)]
    if kinds != ["3d"] or len(nodes) <= FEW:
        return [*windows], [*_turtles(nodes), *_controls(nodes)]
    places = [(name, node.location) for name, (node, _) in nodes.items()]
    stage = staged(tuple(windows), places, places[0][1], autostart=True, consoles="beside")
    return [stage, *_turtles(nodes)], []


def _turtles(nodes: Mapping[str, Declared]) -> Iterator[Widget]:
    for node, _ in nodes.values():
        if (node.package, node.executable) == ("turtlesim", "turtlesim_node"):
            full = f"{node.namespace.rstrip('/')}/{node.remap.get('__node', 'turtlesim')}"
            options = {"kind": "turtlesim", "window": f"{full}/window"}
            yield Widget("robot", "", options, node.location)


def _controls(nodes: Mapping[str, Declared]) -> Iterator[Widget]:
    for name, (node, _) in nodes.items():
        yield Widget("buttons", name, {"autostart": True}, node.location)
        yield Widget("console", name, {"lines": 1000}, node.location)
