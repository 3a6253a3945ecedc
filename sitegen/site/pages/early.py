"""Find what the HTML of a page asks for itself, so that nodes start as soon as possible."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from sitegen.model import Page, Programs, Site
from sitegen.site import assets
from sitegen.site.prose import address

# Nearly all browsers take this build; a page cannot know in time whether this one does.
ENGINE = "jspi"


def modules(
    site: Site, page: Page, programs: Programs, entry: Mapping[str, Any] | None
) -> list[str]:
    """Return the addresses of the modules that `page` runs or starts workers with.

    They would otherwise be asked for one after the other.
    """
    if not entry:
        return []
    started = [name for name, node in entry["nodes"].items() if node["autostart"]]
    workers = (programs[page.nodes[name].program].worker for name in started)
    paths = [*(f"runtime/workers/{worker}.js" for worker in workers), *assets.preloads(site, page)]
    scripts = (build["script"] for build in _builds(entry))
    return list(dict.fromkeys([*(address(page, path) for path in paths), *scripts]))


def programs(entry: Mapping[str, Any] | None) -> list[str]:
    """Return the addresses of the WebAssembly that starts by itself."""
    return list(dict.fromkeys(build["wasm"] for build in _builds(entry))) if entry else []


def _builds(entry: Mapping[str, Any]) -> Iterator[Mapping[str, str]]:
    for node in entry["nodes"].values():
        if node["autostart"] and ENGINE in node.get("builds", {}):
            yield node["builds"][ENGINE]
