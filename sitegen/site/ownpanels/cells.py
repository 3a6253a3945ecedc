"""Check the cells of JavaScript of a page, and collect what they import."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from sitegen.config.notebooks import JAVASCRIPT
from sitegen.errors import Problems
from sitegen.model import Artifact, Page, Widget
from sitegen.site.ownpanels.files import CLIENTS, client_artifacts
from sitegen.site.ownpanels.module import parsed


def cell_modules(page: Page, problems: Problems) -> tuple[Mapping[str, str], Sequence[Artifact]]:
    """Return the modules of sitegen that cells of `page` can import, and their files.

    The modules are the main one and what the author's cells import: their paths below `runtime/` by
    name. Syntax errors, and imports that cells cannot have, are reported.
    """
    cells = [part for part in page.leaves if isinstance(part, Widget) and part.kind == JAVASCRIPT]
    names = {"sitegen"} if cells else set[str]()
    for cell in cells:
        module = parsed(str(cell.options["text"]).encode())
        wanted = [one for one in module.references if one.kind != "url"]
        names |= {one.name for one in wanted}
        faults = [
            (one.line, f"cells cannot import '{one.name}'; they can import {', '.join(CLIENTS)}")
            for one in wanted
            if one.name not in CLIENTS
        ]
        if module.fault:
            line, what = module.fault
            faults = [(line, f"syntax error: {what}")]
        for line, what in faults:
            place = replace(cell.location, line=cell.location.line + line - 1)
            problems.add(place, "js ros", what)
    known = {name: CLIENTS[name] for name in sorted(names & CLIENTS.keys())}
    return known, client_artifacts(known)
