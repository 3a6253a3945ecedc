"""What the modules of the generator, of the runtime and of the tests import."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path


def imported_names(file: Path) -> set[str]:
    """Return what a Python module imports, such as `sitegen.config.load` and `json`."""
    return _names(ast.walk(ast.parse(file.read_text())))


def imported_first(file: Path) -> set[str]:
    """Return what a Python module imports before it is imported itself.

    Imports in functions come later, and those for types never.
    """
    return _names(_at_once(ast.parse(file.read_text())))


def _at_once(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the statements that run when a module is imported."""
    for child in ast.iter_child_nodes(node):
        match child:
            case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.Lambda():
                continue
            case ast.If(test=ast.Name("TYPE_CHECKING")):
                continue
            case _:
                yield child
                yield from _at_once(child)


def _names(nodes: Iterable[ast.AST]) -> set[str]:
    names: set[str] = set()
    for node in nodes:
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
