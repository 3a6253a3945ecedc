"""Write page.json, which describes what the page runs (see protocol.js)."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import partial
from typing import Any

from sitegen.model import Page, Programs, Python, Site
from sitegen.site import assets
from sitegen.site.pages.blocks import slots_of
from sitegen.site.prose import address

# Widgets that let visitors start a node, so that it need not start with the page.
STARTING = {"buttons", "editor", "prompt"}
# The widget that loads meshes.
VIEW = "3d"


def page_entry(
    site: Site,
    page: Page,
    programs: Programs,
    edited: Mapping[str, Mapping[str, str]],
    resources: Mapping[str, str],
) -> dict[str, Any]:
    """Return the page's PageEntry.

    `edited` has the files of its editors by slot id, `resources` the paths in `dist/` of what its
    3D views load, by URL.
    """
    link = partial(address, page)
    found = {url: link(path) for url, path in resources.items()}
    starting = [widget for widget, _ in slots_of(page) if widget.kind in STARTING]
    waiting = {widget.target for widget in starting if widget.options.get("autostart") is not True}
    # What is on the page only because other nodes need it has a button beside these.
    shown = {widget.target for widget, _ in slots_of(page)}
    waiting |= {need for node in page.nodes.values() for need in node.needs} - shown
    entry: dict[str, Any] = {
        "nodes": {
            name: {
                **programs[node.program].entry(node, link),
                "autostart": name not in waiting,
                **({"needs": list(node.needs)} if node.needs else {}),
            }
            for name, node in page.nodes.items()
        },
        "widgets": [
            {
                "kind": widget.kind,
                "element": slot.id,
                "target": widget.target,
                "options": {
                    **widget.options,
                    **edited.get(slot.id, {}),
                    **({"resources": found} if found and widget.kind == VIEW else {}),
                },
            }
            for widget, slot in slots_of(page)
        ],
    }
    if assets.takes_part(page):
        nodes = page.nodes.values()
        types = (programs[node.program].types(node) for node in nodes)
        entry["types"] = {name: one for each in types for name, one in each.items()}
    if page.start_from_links:
        entry["startFromLinks"] = True
    if site.isolate and any(isinstance(node.kind, Python) for node in page.nodes.values()):
        entry["isolate"] = address(page, "sw.js")
    return entry


def written(entry: Mapping[str, Any]) -> bytes:
    """Return a PageEntry as the text of page.json."""
    return json.dumps(entry, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()
