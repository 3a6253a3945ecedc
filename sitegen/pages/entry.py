"""Write page.json: what the page runs, as protocol.js describes it."""

from __future__ import annotations

import json
from collections.abc import Mapping

from sitegen.model import Node, Page, Site
from sitegen.pages.blocks import slots_of
from sitegen.prose import address


# A digest of each form of a program, by package, executable and engine.
Versions = Mapping[tuple[str, str, str], str]


def page_json(
    site: Site, page: Page, types: Mapping[str, object] | None, versions: Versions
) -> bytes:
    """Return the page's PageEntry; `types` are the message types of a page with panels."""
    waiting = {
        widget.target
        for widget, _ in slots_of(page)
        if widget.kind == "buttons" and widget.options.get("autostart") is not True
    }
    entry: dict[str, object] = {
        "nodes": {
            name: {
                "package": node.package,
                "executable": node.executable,
                "arguments": node.command_line(),
                "autostart": name not in waiting,
                "builds": _builds(site, page, node, versions),
            }
            for name, node in page.nodes.items()
        },
        "widgets": [
            {
                "kind": widget.kind,
                "element": slot.id,
                "target": widget.target,
                "options": dict(widget.options),
            }
            for widget, slot in slots_of(page)
        ],
    }
    if types is not None:
        entry["types"] = dict(types)
    return json.dumps(entry, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


def _builds(site: Site, page: Page, node: Node, versions: Versions) -> dict[str, dict[str, str]]:
    builds = {}
    for engine in ("jspi", "asyncify") if site.asyncify else ("jspi",):
        stem = address(page, f"nodes/{node.package}/{node.executable}.{engine}")
        # Another program has another address, so that browsers may keep this one for good.
        version = versions.get((node.package, node.executable, engine), "")
        query = f"?v={version}" if version else ""
        builds[engine] = {"script": f"{stem}.js{query}", "wasm": f"{stem}.wasm{query}"}
    return builds
