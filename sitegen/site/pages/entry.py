"""Write page.json: what the page runs, as protocol.js describes it."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field

from sitegen.model import Node, Page, Setup, Site
from sitegen.site.pages.blocks import slots_of
from sitegen.site.prose import address

Types = Mapping[str, object]


@dataclass(frozen=True)
class Programs:
    """What the build knows of the programs that pages run.

    `modules` names, by page path, the modules inside `dist/` that the page loads beside rosMain.js;
    `types` has, by page path, the message types of pages that take part in the graph; `foreign`
    has, by page path and node, those of nodes that the ROS2WASM project compiled; `versions` has a
    digest of each program, by package, executable and engine; `archives` has one of each archive of
    Python nodes, by its path inside `dist/`; `needed` has the paths of those that a node unpacks,
    by package and executable; `sizes` has the bytes of each archive, and those of Python by "";
    `own` names the modules of the workspace that a Python node has, by package and executable;
    `lines` has those programs, by package, executable and engine, that come with their lines.
    """

    modules: Mapping[str, Sequence[str]] = field(default_factory=dict)
    types: Mapping[str, Types] = field(default_factory=dict)
    foreign: Mapping[str, Mapping[str, Types]] = field(default_factory=dict)
    versions: Mapping[tuple[str, str, str], str] = field(default_factory=dict)
    archives: Mapping[str, str] = field(default_factory=dict)
    needed: Mapping[tuple[str, str], Sequence[str]] = field(default_factory=dict)
    sizes: Mapping[str, int] = field(default_factory=dict)
    own: Mapping[tuple[str, str], Sequence[str]] = field(default_factory=dict)
    lines: Set[tuple[str, str, str]] = frozenset()


def page_json(
    site: Site, page: Page, programs: Programs, edited: Mapping[str, Mapping[str, str]]
) -> bytes:
    """Return the page's PageEntry; `edited` has the files of its editors, by their slots."""
    types = programs.types.get(page.path)
    waiting = {
        widget.target
        for widget, _ in slots_of(page)
        if (widget.kind == "buttons" and widget.options.get("autostart") is not True)
        or widget.kind == "prompt"
    }
    entry: dict[str, object] = {
        "nodes": {
            name: {
                **_program(site, page, node, programs),
                "autostart": name not in waiting,
            }
            for name, node in page.nodes.items()
        },
        "widgets": [
            {
                "kind": widget.kind,
                "element": slot.id,
                "target": widget.target,
                "options": {**widget.options, **edited.get(slot.id, {})},
            }
            for widget, slot in slots_of(page)
        ],
    }
    if types is not None:
        entry["types"] = dict(types)
    if site.isolate and any(site.setup_of(node) for node in page.nodes.values()):
        entry["isolate"] = address(page, "sw.js")
    return json.dumps(entry, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


def _program(site: Site, page: Page, node: Node, programs: Programs) -> dict[str, object]:
    if node.ros2wasm is None:
        setup = site.setup_of(node)
        how = (
            {"python": _python(page, node, setup, programs)}
            if setup
            else {"builds": _builds(site, page, node, programs)}
        )
        return {
            "package": node.package,
            "executable": node.executable,
            "arguments": node.command_line(),
            **how,
        }
    script = node.ros2wasm.script
    path = f"ros2wasm/{script.relative_to(site.root).as_posix()}"
    types = programs.foreign.get(page.path, {}).get(node.name, {})
    worker = {"script": address(page, path), "topics": dict(node.ros2wasm.types), "types": types}
    return {"package": "ros2wasm", "executable": script.name, "arguments": [], "ros2wasm": worker}


def _python(page: Page, node: Node, setup: Setup, programs: Programs) -> dict[str, object]:
    module, _, attribute = setup.scripts[node.executable].partition(":")
    paths = programs.needed.get((node.package, node.executable), ())
    # Other files have another address, so that browsers may keep these for good.
    bundles = [f"{address(page, path)}?v={programs.archives.get(path, '')}" for path in paths]
    size = sum(programs.sizes.get(path, 0) for path in ("", *paths))
    own = programs.own.get((node.package, node.executable), ())
    entry = {"bundles": bundles, "size": size, "module": module, "attribute": attribute}
    return {**entry, "own": list(own), **({"group": node.group} if node.group else {})}


def _builds(site: Site, page: Page, node: Node, programs: Programs) -> dict[str, dict[str, str]]:
    builds = {}
    for engine in ("jspi", "asyncify") if site.asyncify else ("jspi",):
        stem = address(page, f"nodes/{node.package}/{node.executable}.{engine}")
        # Another program has another address, so that browsers may keep this one for good.
        version = programs.versions.get((node.package, node.executable, engine), "")
        query = f"?v={version}" if version else ""
        builds[engine] = {"script": f"{stem}.js{query}", "wasm": f"{stem}.wasm{query}"}
        if (node.package, node.executable, engine) in programs.lines:
            builds[engine]["lines"] = f"{stem}.lines.json{query}"
    return builds
