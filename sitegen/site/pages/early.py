"""Find the URLs that the HTML of a page requests at once, so that nodes start soon."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sitegen.model import Page, Programs, Site
from sitegen.site import assets
from sitegen.site.prose import address


@dataclass(frozen=True)
class Early:
    """A program that starts with the page: the URLs of one of its builds."""

    engine: str
    script: str
    wasm: str


def modules(
    site: Site, page: Page, programs: Programs, entry: Mapping[str, Any] | None
) -> list[str]:
    """Return the URLs of the modules that `page` runs or starts workers with.

    Otherwise the browser would discover and request them one after the other.
    """
    if not entry:
        return []
    started = (name for name, node in entry["nodes"].items() if node["autostart"])
    workers = (programs[page.nodes[name].program].worker for name in started)
    paths = [*(f"runtime/workers/{worker}.js" for worker in workers), *assets.preloads(site, page)]
    own = [widget["options"].get("module") for widget in entry["widgets"]]
    own += (script["module"] for script in entry.get("scripts", ()))
    return [*(address(page, path) for path in dict.fromkeys(paths)), *filter(None, own)]


def programs(entry: Mapping[str, Any] | None) -> list[Early]:
    """Return the builds of the C++ programs that start with the page."""
    nodes = entry["nodes"].values() if entry else ()
    found = (
        Early(engine, build["script"], build["wasm"])
        for node in nodes
        if node["autostart"]
        for engine, build in node.get("builds", {}).items()
    )
    return list(dict.fromkeys(found))
