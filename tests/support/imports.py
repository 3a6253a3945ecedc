"""What the modules of the generator, of the runtime and of the tests import."""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence
from pathlib import Path


def imported_names(file: Path) -> set[str]:
    """Return what a Python module imports, such as `sitegen.config.load` and `json`."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.ImportFrom):
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
        elif isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
    return names


def dependents(module: str, imports: Mapping[str, Sequence[str]]) -> set[str]:
    """Return a module and all that import it, directly or through others."""
    found, new = {module}, {module}
    while new:
        new = {name for name, others in imports.items() if new & {*others}} - found
        found |= new
    return found
