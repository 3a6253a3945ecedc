"""Determine the level of interaction of a page from its widgets."""

from __future__ import annotations

from collections.abc import Iterable

from sitegen.model import Widget

LEVELS = {
    "I1": "consoles only",
    "I2": "buttons for one node",
    "I3": "buttons for several nodes",
    "I4": "panels for the whole graph",
    "I5": "a Python prompt or an editor",
}


def offered(widgets: Iterable[Widget]) -> str:
    """Return the level that these widgets offer."""
    kinds = [(widget.kind, widget.target) for widget in widgets]
    if any(kind in ("prompt", "editor") for kind, _ in kinds):
        return "I5"
    if any(not target for _, target in kinds):
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
        "I4": "remove the prompt and the editors"
        if offers == "I5"
        else "add a panel, like 'topics:'",
        "I5": "add a prompt or an editor",
    }
    way = "remove the panels" if offers == "I4" and declared in ways else ways.get(declared)
    offer = f"the page offers {offers} ({LEVELS[offers]})"
    if not way:
        return f"no level '{declared}', {offer}; write 'level: {offers}'"
    return f"{offer}, not {declared} ({LEVELS[declared]}); {way}, or write 'level: {offers}'"
