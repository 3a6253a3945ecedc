"""Write page.json, which describes what the page runs (see protocol.js)."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Mapping
from dataclasses import asdict
from functools import partial
from typing import Any

from sitegen import workspace
from sitegen.config.notebooks import JAVASCRIPT
from sitegen.interfaces.messages import hashes_of, without_hashes
from sitegen.launch.written import launch_entry
from sitegen.model import Launch, Node, Page, Prebuilt, Programs, Site, Widget
from sitegen.site import assets
from sitegen.site.launches import Reading
from sitegen.site.ownpanels import KIND as OWN
from sitegen.site.ownpanels import OwnPanels
from sitegen.site.pages.blocks import slots_of
from sitegen.site.prose import address

# Widgets that let visitors start a node, so that it need not start with the page.
STARTING = {"buttons", "editor", "prompt"}
# The widgets that load meshes: the view, and those whose cells may show one.
MESHES = {"3d", *assets.CELLS}
# The widget that joins gateways.
CONNECT = "connect"
# The widget that plays bags by name.
TERMINAL = "terminal"
# The module of a docked one, which loads it when a visitor runs a command.
DOCK = "dock"


def page_entry(
    site: Site,
    page: Page,
    programs: Programs,
    edited: Mapping[str, Mapping[str, str]],
    resources: Mapping[str, str],
    bags: Mapping[str, str],
    own: OwnPanels,
    cell_modules: Mapping[str, str],
    definitions: Mapping[str, str],
) -> dict[str, Any]:
    """Return the page's PageEntry.

    `edited` has the files of its editors by slot id, `resources` the paths in `dist/` of what its
    3D views load, by URL, `bags` those of the bags that it plays, by the path in site.yaml, and
    `own` has those of its author's modules. `cell_modules` are those that its cells of JavaScript
    can import, below `runtime/` by name. `definitions` are the paths of what its terminals and
    the panels below its cells load.
    """
    link = partial(address, page)
    known = {name: link(path) for name, path in bags.items()}
    found = {url: link(path) for url, path in resources.items()}
    defined = {name: link(path) for name, path in definitions.items()}
    shown_in_editors = {widget.target for widget, _ in slots_of(page) if widget.kind == "editor"}
    starting = [widget for widget, _ in slots_of(page) if widget.kind in STARTING]
    waiting = {widget.target for widget in starting if widget.options.get("autostart") is not True}
    pressed = frozenset(waiting)
    asked = {widget.target for widget in starting} - waiting
    waiting |= {name for widget, _ in slots_of(page) for name in widget.runs} - asked
    # What is on the page only because other nodes need it has a button beside these.
    shown = {widget.target for widget, _ in slots_of(page)}
    waiting |= {need for node in page.nodes.values() for need in node.needs} - shown
    waiting |= set(page.launch.others if page.launch else ())
    later = page.launch.later - pressed if page.launch else frozenset()
    waiting |= later
    described = (programs[node.program].types(node) for node in page.nodes.values())
    types: dict[str, Any] = {name: one for each in described for name, one in each.items()}
    entry: dict[str, Any] = {
        "nodes": {
            name: {
                **programs[node.program].entry(node, link),
                "autostart": name not in waiting,
                **({"later": True} if name in later else {}),
                **({"needs": list(node.needs)} if node.needs else {}),
                **({"foreign": True} if _is_foreign(node, shown_in_editors) else {}),
            }
            for name, node in page.nodes.items()
        },
        "widgets": [
            {
                "kind": DOCK if widget.is_docked else widget.kind,
                "element": slot.id,
                "target": widget.target,
                "options": {
                    **widget.options,
                    **edited.get(slot.id, {}),
                    **({"resources": found} if found and widget.kind in MESHES else {}),
                    **({"file": link(bags[played])} if (played := _bag(widget)) else {}),
                    **({"bags": known} if known and widget.kind == TERMINAL else {}),
                    **_definitions(widget, defined),
                    **({"modules": cell_modules} if widget.kind == JAVASCRIPT else {}),
                    **(_module(widget, own.modules, link) if widget.kind == OWN else {}),
                    **(_connect(page, types) if widget.kind == CONNECT else {}),
                },
            }
            for widget, slot in slots_of(page)
        ],
    }
    scripts = [name for name in page.scripts if name in own.modules]
    if scripts:
        entry["scripts"] = [{"file": name, "module": link(own.modules[name])} for name in scripts]
    if own.interfaces:
        entry["interfaces"] = link(own.interfaces)
    if own.texts:
        entry["texts"] = link(own.texts)
    if site.messages_from:
        entry["messagesFrom"] = list(site.messages_from)
    if assets.takes_part(site, page):
        entry["types"] = without_hashes(types)
    if page.launch:
        entry["launch"] = launch_entry(page.launch, pressed)
    if page.start_from_links:
        entry["startFromLinks"] = list(page.start_from_links)
    if assets.isolates(site, page):
        entry["isolate"] = address(page, "sw.js")
    return entry


def _is_foreign(node: Node, edited: Collection[str]) -> bool:
    """Return whether not only the author decides what a node runs.

    It is from an archive, or runs code of visitors or of links: a prompt, cells, a kernel, or one
    of the nodes `edited` on the page.
    """
    is_prebuilt = isinstance(node.kind, Prebuilt)
    return is_prebuilt or node.package == workspace.SITEGEN or node.name in edited


def again_entry(launch: Launch, files: Reading, link: Callable[[str], str]) -> dict[str, object]:
    """Return what the page needs to read its launch file anew."""
    return {
        "reader": link(files.reader.path),
        "files": link(files.files.path),
        "path": f"{launch.package}/{launch.path}",
        "given": dict(launch.given),
        "environment": dict(launch.environment),
    }


def _connect(page: Page, types: Mapping[str, Any]) -> dict[str, object]:
    """Return the options of the widget that joins gateways, with the hashes of the page's types."""
    joined = page.connect
    if joined is None:
        return {}
    given = {name: value for name, value in asdict(joined).items() if value not in (None, "", {})}
    return {"connect": given, "hashes": hashes_of(types)}


def _definitions(widget: Widget, paths: Mapping[str, str]) -> Mapping[str, str]:
    """Return what a widget loads of the definitions of interfaces."""
    if widget.kind in {*assets.CELLS, JAVASCRIPT}:
        return {"interfaces": paths["interfaces"]}
    return paths if widget.kind == TERMINAL else {}


def _bag(widget: Widget) -> str:
    """Return the path of the bag that a widget plays, or nothing."""
    return str(widget.options.get("file") or "") if widget.kind == "bag" else ""


def _module(
    widget: Widget, modules: Mapping[str, str], link: Callable[[str], str]
) -> dict[str, object]:
    file = str(widget.options["file"])
    return {"module": link(modules[file])} if file in modules else {}


def written(entry: Mapping[str, Any]) -> bytes:
    """Return a PageEntry as the text of page.json."""
    return json.dumps(entry, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()
