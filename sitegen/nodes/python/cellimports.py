"""Find the modules that the cells of a site import."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from sitegen import workspace
from sitegen.config import notebooks
from sitegen.config.cellsources import CellSource, sources
from sitegen.model import Site
from sitegen.nodes.python.imports import Import, unconditional

EXECUTABLES = {
    notebooks.KERNEL: workspace.NOTEBOOK,
    notebooks.INTERPRETER: workspace.CELLS,
}


def imported(site: Site, executable: str) -> dict[str, Import]:
    """Return the modules that cells import which `executable` runs: one of sitegen's programs.

    A build goes on without those that it does not find; `sitegen check` reports them.
    """
    found: dict[str, Import] = {}
    for page in site.pages:
        for source in sources(site.root, page):
            if EXECUTABLES[source.node] == executable:
                for name, line in modules(source):
                    where = source.location(line)
                    found.setdefault(name, Import(where, sure=False, quiet=True))
    return found


def modules(source: CellSource) -> Iterator[tuple[str, int]]:
    """Yield the first parts of the names of imported modules, and the lines of the imports."""
    for node, _ in unconditional(source.tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name.partition(".")[0], node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module.partition(".")[0], node.lineno
