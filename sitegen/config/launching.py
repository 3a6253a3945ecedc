"""The launch file of a page, and the widgets of what it starts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from sitegen.config.document import Value
from sitegen.config.nodes import Declared
from sitegen.errors import Problems
from sitegen.model import Handler, Part, Widget, leaves

# The widget that shows what the launch file does.
KIND = "launch"


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


def panels(nodes: Mapping[str, Declared]) -> Iterator[Widget]:
    """Yield buttons and a console for each node that a launch file starts, and its window."""
    for node, _ in nodes.values():
        if (node.package, node.executable) == ("turtlesim", "turtlesim_node"):
            full = f"{node.namespace.rstrip('/')}/{node.remap.get('__node', 'turtlesim')}"
            options = {"kind": "turtlesim", "window": f"{full}/window"}
            yield Widget("robot", "", options, node.location)
    for name, (node, _) in nodes.items():
        yield Widget("buttons", name, {"autostart": True}, node.location)
        yield Widget("console", name, {"lines": 1000}, node.location)
