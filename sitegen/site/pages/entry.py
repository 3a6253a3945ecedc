"""Write page.json, which describes what the page runs (see protocol.js)."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Mapping
from dataclasses import asdict, fields
from functools import partial
from typing import Any

from sitegen.model import Argument, Effect, Handler, Launch, Page, Programs, Site, Widget
from sitegen.site import assets
from sitegen.site.ownpanels import KIND as OWN
from sitegen.site.ownpanels import OwnPanels
from sitegen.site.pages.blocks import slots_of
from sitegen.site.prose import address

# Widgets that let visitors start a node, so that it need not start with the page.
STARTING = {"buttons", "editor", "prompt"}
# The widget that loads meshes.
VIEW = "3d"
# The widget that joins gateways.
CONNECT = "connect"
# The widget that plays bags by name.
TERMINAL = "terminal"


def page_entry(
    site: Site,
    page: Page,
    programs: Programs,
    edited: Mapping[str, Mapping[str, str]],
    resources: Mapping[str, str],
    bags: Mapping[str, str],
    own: OwnPanels,
    definitions: Mapping[str, str],
) -> dict[str, Any]:
    """Return the page's PageEntry.

    `edited` has the files of its editors by slot id, `resources` the paths in `dist/` of what its
    3D views load, by URL, `bags` those of the bags that it plays, by the path in site.yaml, and
    `own` has those of its author's modules. `definitions` are the paths of what its terminals load.
    """
    link = partial(address, page)
    known = {name: link(path) for name, path in bags.items()}
    found = {url: link(path) for url, path in resources.items()}
    defined = {name: link(path) for name, path in definitions.items()}
    starting = [widget for widget, _ in slots_of(page) if widget.kind in STARTING]
    waiting = {widget.target for widget in starting if widget.options.get("autostart") is not True}
    pressed = frozenset(waiting)
    asked = {widget.target for widget in starting} - waiting
    waiting |= {name for widget, _ in slots_of(page) for name in widget.runs} - asked
    # What is on the page only because other nodes need it has a button beside these.
    shown = {widget.target for widget, _ in slots_of(page)}
    waiting |= {need for node in page.nodes.values() for need in node.needs} - shown
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
                    **({"file": link(bags[played])} if (played := _bag(widget)) else {}),
                    **({"bags": known} if known and widget.kind == TERMINAL else {}),
                    **(defined if widget.kind == TERMINAL else {}),
                    **(_module(widget, own.modules, link) if widget.kind == OWN else {}),
                    **(_connect(page, types) if widget.kind == CONNECT else {}),
                },
            }
            for widget, slot in slots_of(page)
        ],
    }
    if page.script in own.modules:
        entry["script"] = {"file": page.script, "module": link(own.modules[page.script])}
    if own.interfaces:
        entry["interfaces"] = link(own.interfaces)
    if site.messages_from:
        entry["messagesFrom"] = list(site.messages_from)
    if assets.takes_part(site, page):
        entry["types"] = {name: _without_hash(one) for name, one in types.items()}
    if page.launch:
        entry["launch"] = _launch(page.launch, pressed)
    if page.start_from_links:
        entry["startFromLinks"] = list(page.start_from_links)
    if assets.isolates(site, page):
        entry["isolate"] = address(page, "sw.js")
    return entry


def _launch(launch: Launch, pressed: Collection[str]) -> dict[str, object]:
    """Return a launch file; those of its nodes in `pressed` start when a visitor presses Start."""
    own = [name for name in launch.nodes if name in pressed]
    return {
        "package": launch.package,
        "file": launch.file,
        "nodes": list(launch.nodes),
        **({"first": [*launch.first]} if launch.later else {}),
        **({"handlers": [_handler(each) for each in launch.handlers]} if launch.handlers else {}),
        **({"asked": own} if own else {}),
        **({"arguments": [*map(_argument, launch.arguments)]} if launch.arguments else {}),
    }


def _argument(argument: Argument) -> dict[str, str]:
    return {name: value for name, value in asdict(argument).items() if value is not None}


def _handler(handler: Handler) -> dict[str, object]:
    """Return what a launch file does at an event, without what is left open."""
    on = {name: value for name, value in asdict(handler.on).items() if value}
    return {"on": on, "effects": [*map(_effect, handler.effects)], "most": handler.most}


def _effect(effect: Effect) -> dict[str, object]:
    plain = {field.name: getattr(effect, field.name) for field in fields(effect)}
    inside = {"handler": _handler(effect.handler)} if effect.handler else {}
    return {name: value for name, value in plain.items() if value} | inside


def _connect(page: Page, types: Mapping[str, Any]) -> dict[str, object]:
    """Return the options of the widget that joins gateways, with the hashes of the page's types."""
    joined = page.connect
    if joined is None:
        return {}
    given = {name: value for name, value in asdict(joined).items() if value not in (None, "", {})}
    hashes = {
        name.removesuffix("_Request"): one["hash"] for name, one in types.items() if "hash" in one
    }
    return {"connect": given, "hashes": hashes}


def _without_hash(one: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in one.items() if name != "hash"}


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
