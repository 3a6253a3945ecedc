"""Write the types that editors complete the panels and scripts of a site with."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

from sitegen.build import Made, make
from sitegen.cache.folder import cache_folder
from sitegen.errors import SiteError, relative
from sitegen.interfaces.catalogue import catalogue
from sitegen.interfaces.declarations import CLIENT, client_declarations, declarations
from sitegen.model import Widget
from sitegen.options import Options
from sitegen.report import Report
from sitegen.site.ownpanels import KIND, ROSLIB, uses_client

NAME = "ros.d.ts"
# How the files begin.
MARK = "// Written by `sitegen types`"


def write_types(folder: Path, report: Report) -> list[str]:
    """Write `ros.d.ts` beside the author's panels and scripts of a site; return what was written.

    Which messages a C++ node uses is known when it is compiled, so the nodes are built. Scripts may
    use all interfaces.

    Raises: SiteError if the site cannot be built, or has no such panel and no script.
    """
    made = make(folder, report, options=Options(draft=True, engines=("jspi",)))
    found = declared(made, lambda _: True)
    if not found:
        raise SiteError(
            [
                "no page has a panel or a script of yours; add 'panel: panels/mine.js' to its "
                "content, or 'script: scripts/mine.js' to the page"
            ]
        )
    for file, text in found.items():
        file.write_text(text, encoding="utf-8")
    return [relative(file, made.site.root) for file in found]


def outdated(made: Made) -> dict[Path, str]:
    """Return the present text of each file that `write_types` wrote with another one before.

    Raises: SiteError if definitions of the workspace are wrong.
    """
    found = declared(made, lambda file: _read(file).startswith(MARK))
    return {file: text for file, text in found.items() if text != _read(file)}


def declared(made: Made, wanted: Callable[[Path], bool]) -> dict[Path, str]:
    """Return the text of those files with types for a site that are `wanted`.

    Raises: SiteError if definitions of the workspace are wrong.
    """
    panels: dict[Path, dict[str, object]] = {}
    pages = made.site.pages
    scripts = {(made.site.root / name).parent for page in pages for name in page.scripts}
    for page in pages:
        for part in page.leaves:
            if not isinstance(part, Widget) or part.kind != KIND:
                continue
            file = made.site.root / str(part.options["file"])
            types = panels.setdefault(file.parent, {})
            for node in page.nodes.values():
                types |= made.programs[node.program].types(node)
            if uses_client(file.read_bytes()):
                scripts.add(file.parent)
    everything = cache(lambda: catalogue(made.site, cache=cache_folder()))
    roslib = any(artifact.path == ROSLIB for artifact in made.artifacts)
    texts = {}
    for place in sorted({*panels, *scripts}):
        if wanted(place / NAME):
            own = panels.get(place, {})
            types = {**own, **everything()} if place in scripts else own
            texts[place / NAME] = declarations(types)  # type: ignore[arg-type]
        if place in scripts and wanted(place / CLIENT.name):
            texts[place / CLIENT.name] = client_declarations(roslib=roslib)
    return texts


def _read(file: Path) -> str:
    """Return the text of a file, or nothing if it cannot be read."""
    try:
        return file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return ""
