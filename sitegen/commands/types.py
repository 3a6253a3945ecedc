"""Write the types that editors complete the panels and scripts of a site with."""

from __future__ import annotations

from pathlib import Path

from sitegen.build import make
from sitegen.cache.folder import cache_folder
from sitegen.errors import SiteError, relative
from sitegen.interfaces.catalogue import catalogue
from sitegen.interfaces.declarations import CLIENT, declarations
from sitegen.model import Widget
from sitegen.options import Options
from sitegen.report import Report
from sitegen.site.ownpanels import KIND, uses_client

NAME = "ros.d.ts"


def write_types(folder: Path, report: Report) -> list[str]:
    """Write `ros.d.ts` beside the author's panels and scripts of a site; return what was written.

    Which messages a C++ node uses is known when it is compiled, so the nodes are built. Scripts may
    use all interfaces.

    Raises: SiteError if the site cannot be built, or has no such panel and no script.
    """
    made = make(folder, report, options=Options(draft=True, engines=("jspi",)))
    found: dict[Path, dict[str, object]] = {}
    for page in made.site.pages:
        panels = [part for part in page.leaves if isinstance(part, Widget) and part.kind == KIND]
        for panel in panels:
            types = found.setdefault((made.site.root / str(panel.options["file"])).parent, {})
            for node in page.nodes.values():
                types |= made.programs[node.program].types(node)
    scripts = {(made.site.root / page.script).parent for page in made.site.pages if page.script}
    for page in made.site.pages:
        panels = [part for part in page.leaves if isinstance(part, Widget) and part.kind == KIND]
        modules = (made.site.root / str(panel.options["file"]) for panel in panels)
        scripts |= {file.parent for file in modules if uses_client(file.read_bytes())}
    for place in scripts:
        all_types = catalogue(made.site, cache=cache_folder())
        found[place] = {**found.get(place, {}), **all_types}
    if not found:
        raise SiteError(
            [
                "no page has a panel or a script of yours; add 'panel: panels/mine.js' to its "
                "content, or 'script: scripts/mine.js' to the page"
            ]
        )
    written = []
    for place, types in sorted(found.items()):
        files = {NAME: declarations(types)}  # type: ignore[arg-type]
        if place in scripts:
            files[CLIENT.name] = CLIENT.read_text(encoding="utf-8")
        for name, text in files.items():
            (place / name).write_text(text, encoding="utf-8")
            written.append(relative(place / name, made.site.root))
    return written
