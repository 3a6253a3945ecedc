"""Find the modules that a Python program imports, directly or through its own modules."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from sitegen.errors import Location

# A program that catches one of these exceptions works without the module.
CAUGHT = {"ImportError", "ModuleNotFoundError", "Exception"}


class Import(NamedTuple):
    """The location of an import, and whether it always runs: not if it is conditional.

    A build says nothing of one that is `quiet`.
    """

    location: Location
    sure: bool
    quiet: bool = False


def outside(files: Mapping[str, Path], program: str) -> dict[str, Import]:
    """Return the modules from elsewhere that a program requires.

    `files` are the files of its package and of the packages that it needs, by path below the
    prefix; `program` is an entry point ("module:function") or the path of a file.
    """
    return _walk(files, program)[0]


def own(files: Mapping[str, Path], program: str) -> list[Path]:
    """Return the files of a program: its own module, and those that it imports from `files`."""
    return _walk(files, program)[1]


def _walk(files: Mapping[str, Path], program: str) -> tuple[dict[str, Import], list[Path]]:
    """Return the modules from elsewhere, and the files of the program's own modules."""
    modules = {_name(path): file for path, file in files.items() if _is_module(path)}
    if program in files:
        # As Python does, it finds the modules beside the program.
        folder = PurePosixPath(program).parent
        beside = {
            path: file for path, file in files.items() if PurePosixPath(path).parent == folder
        }
        modules |= {PurePosixPath(path).stem: f for path, f in beside.items() if f.suffix == ".py"}
    found: dict[str, Import] = {}
    waiting = [name for name in [program.partition(":")[0]] if name in modules]
    seen: dict[str, Path] = {}
    if program in files:
        seen[program] = files[program]
        _sort(program, files[program], modules, waiting, found)
    while waiting:
        name = waiting.pop()
        if name not in seen:
            seen[name] = modules[name]
            _sort(name, modules[name], modules, waiting, found)
    return found, list(seen.values())


def names_of(module: str, files: Mapping[str, Path], program: str) -> set[str]:
    """Return the names of `module` that a program uses, with "*" if that cannot be determined."""
    found: set[str] = set()
    for file in _walk(files, program)[1]:
        try:
            tree = ast.parse(file.read_bytes())
        except (SyntaxError, ValueError):
            continue
        known: set[str] = set()
        for node in ast.walk(tree):
            if isinstance(node, ast.Import):
                known |= {each.asname or each.name for each in node.names if each.name == module}
                inside = any(each.name.startswith(f"{module}.") for each in node.names)
                found |= {"*"} if inside else set()
            elif isinstance(node, ast.ImportFrom) and node.module:
                if node.module == module and not node.level:
                    found |= {each.name for each in node.names}
                elif node.module.startswith(f"{module}."):
                    found.add("*")
        names = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
        of = [node for node in ast.walk(tree) if isinstance(node, ast.Attribute)]
        of = [node for node in of if isinstance(node.value, ast.Name) and node.value.id in known]
        found |= {node.attr for node in of}
        # The module is passed on as a whole, so its uses cannot be determined.
        if len(of) < sum(node.id in known for node in names):
            found.add("*")
    return found


def _is_module(path: str) -> bool:
    return path.startswith("python/") and path.endswith(".py")


def _name(path: str) -> str:
    parts = PurePosixPath(path).with_suffix("").parts[1:]
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _sort(
    name: str,
    file: Path,
    modules: Mapping[str, Path],
    waiting: list[str],
    found: dict[str, Import],
) -> None:
    """Classify the imports of one module; the program's own modules are added to `waiting`."""
    package = name if file.name == "__init__.py" else name.rpartition(".")[0]
    for module, line, sure in imported(file, package):
        above = module.split(".")
        own = [".".join(above[: n + 1]) for n in range(len(above))]
        here = [each for each in own if each in modules]
        if above[0] in modules or here:
            waiting += here
        else:
            known = found.get(above[0])
            if known is None or (sure and not known.sure):
                found[above[0]] = Import(Location(file, line), sure)


def imported(file: Path, package: str = "") -> Iterator[tuple[str, int, bool]]:
    """Yield the full names of imported modules, their lines, and whether they always run.

    A name imported from a package may be a module or not.
    """
    try:
        tree = ast.parse(file.read_bytes())
    except (SyntaxError, ValueError):
        return  # reported by syntax.check()
    for node, sure in unconditional(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, node.lineno, sure) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = package.split(".") if node.level else []
            above = above[: len(above) - node.level + 1] if node.level else above
            base = ".".join([*filter(None, above), *filter(None, [node.module])])
            if base:
                yield base, node.lineno, sure
                yield from ((f"{base}.{alias.name}", node.lineno, sure) for alias in node.names)


def unconditional(
    tree: ast.AST, *, within: bool = False, sure: bool = True
) -> Iterator[tuple[ast.AST, bool]]:
    """Yield the nodes below `tree` that are not type checks, and whether they always run.

    `within` says whether `tree` is in a function.
    """
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.Try) and any(_catches(each) for each in node.handlers):
            for part in (*node.handlers, *node.orelse, *node.finalbody):
                yield from unconditional(part, within=within, sure=sure)
            continue
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test):
            continue
        yield node, sure
        yield from unconditional(
            node,
            within=within or isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef),
            sure=sure and not (within and isinstance(node, ast.If)),
        )


def _catches(handler: ast.ExceptHandler) -> bool:
    if handler.type is None:
        return True
    names = (each.id for each in ast.walk(handler.type) if isinstance(each, ast.Name))
    return bool(CAUGHT & set(names))
