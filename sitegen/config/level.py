"""Determine the level of interaction of a page from its widgets."""

from __future__ import annotations

from collections.abc import Iterable

from sitegen.model import Widget

# Widgets with which visitors control everything that a program can do.
FULL = (
    *("prompt", "terminal", "editor", "parameters", "3d", "bag", "notebook", "jupyter"),
    "javascript",
)
LEVELS = {
    "I1": "consoles only",
    "I2": "buttons for one node",
    "I3": "buttons for several nodes",
    "I4": "panels for the whole graph",
    "I5": "a prompt, a terminal, an editor, cells, notebooks, parameters, a 3D view or a bag",
}


def offered(widgets: Iterable[Widget]) -> str:
    """Return the level that these widgets offer."""
    kinds = [(widget.kind, widget.target) for widget in widgets]
    if any(kind in FULL for kind, _ in kinds):
        return "I5"
    # The panel of a launch file starts nodes, as buttons do.
    if any(not target and kind != "launch" for kind, target in kinds):
        return "I4"
    buttons = {target for kind, target in kinds if kind == "buttons"}
    return list(LEVELS)[min(len(buttons), 2)] if kinds else ""


def fault(declared: str, offers: str) -> str:
    """Return the message about a declared level that differs from the offered one, else ""."""
    if declared == offers:
        return ""
    if not offers:
        return "a page without nodes has no level; add a console or remove the key"
    ways = {
        "I1": "remove the buttons",
        "I2": "add buttons for one node" if offers == "I1" else "leave buttons for one node only",
        "I3": "add buttons for another node" if offers == "I2" else "add buttons for several nodes",
        "I4": f"remove {', '.join(FULL)}" if offers == "I5" else "add a panel, like 'topics:'",
        "I5": "add a prompt, a terminal, an editor, notebooks, parameters, a 3D view or a bag",
    }
    way = "remove the panels" if offers == "I4" and declared in ways else ways.get(declared)
    offer = f"the page offers {offers} ({LEVELS[offers]})"
    if not way:
        return f"no level '{declared}', {offer}; write 'level: {offers}'"
    return f"{offer}, not {declared} ({LEVELS[declared]}); {way}, or write 'level: {offers}'"
