"""Determine what a visitor can do on a page, from its widgets."""

from __future__ import annotations

from sitegen.model import Page, Widget, leaves

# What widgets let visitors do, the most important first; with other widgets, they can "watch". The
# words are in the texts of themes.
ABILITIES = {
    "edit": {"editor"},
    "type": {"prompt", "notebook", "jupyter"},
    "code": {"javascript"},
    "command": {"terminal"},
    "robot": {"robot"},
    "see": {"3d"},
    "drive": {"joints", "teleop"},
    "set": {"parameters", "lifecycle"},
    "bag": {"bag"},
    "start": {"buttons", "launch"},
    "publish": {"publish", "camera"},
    "call": {"services", "actions"},
    "look": {
        "topics",
        "nodes",
        "graph",
        "tf",
        "log",
        "plot",
        "value",
        "image",
        "diagnostics",
        "own",
        "connect",
    },
}
# A longer list would not be read.
MOST = 3


def abilities(page: Page) -> list[str]:
    """Return the names of what visitors of `page` can do, at most MOST; none without widgets.

    Examples are there to be read.
    """
    parts = leaves(page.content, examples=False)
    shown = {part.kind for part in parts if isinstance(part, Widget)}
    found = [name for name, kinds in ABILITIES.items() if kinds & shown]
    return found[:MOST] or (["watch"] if shown else [])
