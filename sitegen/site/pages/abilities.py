"""Say what a visitor can do on a page, by its widgets."""

from __future__ import annotations

from sitegen.model import Page, Widget

# What each kind of widget lets visitors do, the most telling first. The words are in the texts of
# themes.
ABILITIES = {
    "edit": {"editor"},
    "type": {"prompt"},
    "robot": {"robot"},
    "start": {"buttons"},
    "publish": {"publish"},
    "call": {"services"},
    "look": {"topics", "nodes", "graph", "log"},
    "watch": {"console"},
}
# More than these would not be read.
MOST = 3


def abilities(page: Page) -> list[str]:
    """Return the names of what visitors of `page` can do, at most MOST; none without widgets."""
    shown = {widget.kind for widget in page.leaves if isinstance(widget, Widget)}
    found = [name for name, kinds in ABILITIES.items() if kinds & shown]
    # Who can do something else is not told that they can watch.
    return [name for name in found[:MOST] if name != "watch" or found == ["watch"]]
