"""Collect the files of the browser runtime that a site uses."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from sitegen.model import Artifact, Build, Page, Site, Widget

RUNTIME = Path(__file__).parent / "runtime"

# Widgets that only start programs and show what they print; all others take part in the graph.
PLAIN = {"buttons", "console"}
# The bundles in runtime/vendor that widgets use, beside the one that reads messages.
VENDOR: dict[str, list[str]] = {}


def takes_part(page: Page) -> bool:
    """Return whether a widget of `page` takes part in the graph."""
    return any(widget.kind not in PLAIN for widget in _widgets([page]))


def runtime(site: Site) -> list[Artifact]:
    """Return the runtime's files, with only those widgets that a page shows.

    A site without nodes needs none of them.
    """
    kinds = sorted({part.kind for part in _widgets(site.pages)})
    if not kinds:
        return []
    files = [
        *RUNTIME.glob("*.js"),
        *RUNTIME.glob("participant/*.js"),
        *RUNTIME.glob("workers/*.js"),
        *(RUNTIME / "widgets" / f"{kind}.js" for kind in kinds),
    ]
    if any(map(takes_part, site.pages)):
        vendor = {name for kind in kinds for name in VENDOR.get(kind, [])} | {"cdr"}
        files += RUNTIME.glob("messages/*.js")
        files += [RUNTIME / "vendor" / f"{name}.js" for name in vendor]
        files.append(RUNTIME / "vendor" / "licenses.txt")
    else:
        files.remove(RUNTIME / "pageClient.js")
    return [Artifact(f"runtime/{f.relative_to(RUNTIME).as_posix()}", f) for f in sorted(files)]


def preloads(site: Site) -> dict[str, list[str]]:
    """Return, by page path, the modules that the page loads as soon as it can: all but rosMain.js.

    Named in the page's head they come at once; otherwise each would be asked for by the one before.
    """
    loads = {}
    for page in site.pages:
        kinds = dict.fromkeys(widget.kind for widget in _widgets([page]))
        files = ["graph.js", "nodeProcess.js", "protocol.js"]
        if takes_part(page):
            files += ["pageClient.js", "participant/participant.js", "messages/codec.js"]
            files.append("vendor/cdr.js")
        files += [f"widgets/{kind}.js" for kind in kinds]
        loads[page.path] = [f"runtime/{file}" for file in files] if kinds else []
    return loads


def programs(builds: Iterable[tuple[tuple[str, str], Sequence[Build]]]) -> list[Artifact]:
    """Return the compiled nodes."""
    artifacts = []
    for (package, executable), forms in builds:
        for build in forms:
            stem = f"nodes/{package}/{executable}.{build.engine}"
            artifacts.append(Artifact(f"{stem}.js", build.script))
            artifacts.append(Artifact(f"{stem}.wasm", build.wasm))
    return artifacts


def _widgets(shown: Iterable[Page]) -> Iterable[Widget]:
    return (part for page in shown for part in page.content if isinstance(part, Widget))
