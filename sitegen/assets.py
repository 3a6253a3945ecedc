"""Collect the files of the browser runtime that a site uses."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from sitegen.model import Artifact, Build, Page, Site, Widget

RUNTIME = Path(__file__).parent / "runtime"


def runtime(site: Site) -> list[Artifact]:
    """Return the runtime's files, with only those widgets that a page shows.

    A site without nodes needs none of them.
    """
    kinds = sorted({part.kind for part in _widgets(site.pages)})
    if not kinds:
        return []
    files = [
        *RUNTIME.glob("*.js"),
        *RUNTIME.glob("workers/*.js"),
        *(RUNTIME / "widgets" / f"{kind}.js" for kind in kinds),
    ]
    return [Artifact(f"runtime/{f.relative_to(RUNTIME).as_posix()}", f) for f in sorted(files)]


def preloads(site: Site) -> dict[str, list[str]]:
    """Return, by page path, the modules that the page loads as soon as it can: all but rosMain.js.

    Named in the page's head they come at once; otherwise each would be asked for by the one before.
    """
    common = [f"runtime/{f.name}" for f in sorted(RUNTIME.glob("*.js")) if f.name != "rosMain.js"]
    kinds = {page.path: dict.fromkeys(w.kind for w in _widgets([page])) for page in site.pages}
    return {
        path: [*common, *(f"runtime/widgets/{kind}.js" for kind in shown)]
        for path, shown in kinds.items()
    }


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
