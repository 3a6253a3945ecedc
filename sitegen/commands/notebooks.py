"""Find imports and types in the cells of a site that their kernels do not have."""

from __future__ import annotations

import ast
import io
import sys
import zipfile
from collections.abc import Collection, Iterator

from sitegen import workspace
from sitegen.cache.folder import cache_folder
from sitegen.config import notebooks
from sitegen.config.cellsources import CellSource, sources
from sitegen.errors import Problems
from sitegen.model import Site
from sitegen.nodes.python import bytecode, cellimports, dependencies, ipython
from sitegen.nodes.python.archives import IN_THE_PAGE
from sitegen.report import Report
from sitegen.shipped import INTERFACES

KINDS = ("msg", "srv", "action")


def warnings(site: Site, report: Report) -> list[str]:
    """Return what is wrong with the imports of cells, a line each."""
    problems = Problems(site.root)
    found = [source for page in site.pages for source in sources(site.root, page)]
    if not found:
        return []
    packages = {**workspace.shipped_packages(), **site.packages}
    types = workspace.interfaces(packages, KINDS)
    known = _everywhere(site, types)
    known |= dependencies.provided(site, cache=cache_folder(), report=report)
    labs = known | (_of_ipython() if any(s.node == notebooks.KERNEL for s in found) else set())
    for source in found:
        _check_modules(source, labs if source.node == notebooks.KERNEL else known, problems)
        _check_types(source, types, problems)
    return problems.lines


def _check_modules(source: CellSource, known: Collection[str], problems: Problems) -> None:
    for name, line in cellimports.modules(source):
        if name not in known:
            message = dependencies.unavailable(name)
            problems.add(source.location(line), f"import {name}", message)


def _check_types(source: CellSource, types: Collection[str], problems: Problems) -> None:
    for written, line in _types(source.tree):
        if written not in types:
            message = workspace.unknown_interface(written, types)
            problems.add(source.location(line), "import", message)


def _types(tree: ast.Module) -> Iterator[tuple[str, int]]:
    """Yield the types that cells import by name, in the form of ROS."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            package, _, kind = node.module.partition(".")
            if kind in KINDS:
                names = (alias.name for alias in node.names if alias.name != "*")
                yield from ((f"{package}/{kind}/{name}", node.lineno) for name in names)


def _everywhere(site: Site, types: Collection[str]) -> set[str]:
    """Return the modules that every kernel of the site has."""
    setups = [one.setup for one in site.packages.values() if one.setup]
    own = {path.split("/")[1] for one in setups for path in one.files if path.startswith("python/")}
    described = {name.partition("/")[0] for name in types}
    described |= {folder.name for folder in INTERFACES.iterdir()}
    known = {name.removesuffix(".py") for name in (*own, *bytecode.modules())}
    of_python = sys.stdlib_module_names - dependencies.ABSENT
    return known | described | of_python | IN_THE_PAGE


def _of_ipython() -> set[str]:
    with zipfile.ZipFile(io.BytesIO(ipython.archive())) as archive:
        return {name.split("/")[1].removesuffix(".py") for name in archive.namelist()}
