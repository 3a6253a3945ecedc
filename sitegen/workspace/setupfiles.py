"""Find the files that setuptools would install of a Python package, without running setup.py."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any

from sitegen.workspace import setupconfig, setupkeys, setupscript
from sitegen.workspace.setupconfig import UnreadableError
from sitegen.workspace.setupexpressions import StopError
from sitegen.workspace.setupinstall import Installation, MissingError

ENTRY = re.compile(r"\s*([\w.-]+)\s*=\s*([\w.]+)\s*:\s*([\w.]+)\s*(\[.*\])?")
READ = (
    *("entry_points", "scripts", "packages", "package_dir", "py_modules", "package_data"),
    *("exclude_package_data", "include_package_data", "data_files"),
)
# The installation folder for the programs in `scripts`.
PROGRAMS = "lib/programs"
FILES = ("setup.py", "setup.cfg", "pyproject.toml")


@dataclass
class Listing:
    """The files that a package installs.

    `scripts` maps the names of executables to "module:function" or to the path of a file. `files`
    maps paths below the prefix to paths relative to the package; modules are installed to
    "python/". `fault` says what could not be read: a file, a line and a message.
    """

    scripts: dict[str, str] = field(default_factory=dict)
    files: dict[str, str] = field(default_factory=dict)
    fault: tuple[Path, int, str] | None = None


def read(folder: Path, within: Path | None = None) -> Listing:
    """Return what setup.py, setup.cfg and pyproject.toml of a package define.

    Its files may be anywhere below `within`, which is the package itself by default.
    """
    listing = Listing()
    try:
        given = {**setupconfig.pyproject(folder), **setupconfig.cfg(folder)}
        given |= _py(folder, within or folder)
        for name, value in given.items():
            if why := setupkeys.fault(name, value):
                raise UnreadableError(*_written_in(folder, name), why)
        listing.scripts = dict(_scripts(folder, given.get("entry_points")))
        installation = Installation(folder, within or folder, given)
        listing.files = dict(installation.files())
        for script in given.get("scripts") or ():
            path = f"{PROGRAMS}/{PurePosixPath(script).name}"
            for installed, file in installation.placed(path, folder / script, "scripts"):
                listing.scripts[PurePosixPath(script).name] = installed
                listing.files[installed] = file
    except UnreadableError as error:
        listing.fault = error.fault
    except MissingError as error:
        listing.fault = (*_written_in(folder, error.name, error.key), str(error))
    return listing


def programs(file: Path) -> Listing:
    """Return the programs that the setup.cfg of a CMake package defines, without their files."""
    listing = Listing()
    try:
        given = setupconfig.cfg(file.parent, file.name)
        if why := setupkeys.fault("entry_points", given.get("entry_points")):
            raise UnreadableError(file, 1, why)
        listing.scripts = dict(_scripts(file.parent, given.get("entry_points")))
    except UnreadableError as error:
        listing.fault = error.fault
    return listing


def _py(folder: Path, within: Path) -> dict[str, Any]:
    """Return the relevant arguments of setup() in setup.py."""
    file = folder / "setup.py"
    if not file.is_file():
        return {}
    try:
        tree = ast.parse(file.read_bytes())
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        line = getattr(error, "lineno", None) or 1
        raise UnreadableError(file, line, f"not valid Python: {error}") from None
    try:
        return setupscript.arguments(tree, folder, within, (*READ, "**"))
    except StopError as error:
        raise UnreadableError(file, error.line, str(error)) from None


def _scripts(folder: Path, entry_points: Any) -> Iterator[tuple[str, str]]:
    if isinstance(entry_points, str):
        where = _written_in(folder, "entry_points")[0]
        try:
            parser = setupconfig.parsed(entry_points, where, 1)
        except UnreadableError as error:
            message = f"entry_points: {error.fault[2].removeprefix('cannot be read: ')}"
            raise UnreadableError(where, 1, message) from None
        entry_points = {name: dict(parser[name]) for name in parser.sections()}
    scripts = entry_points.get("console_scripts", ()) if isinstance(entry_points, Mapping) else ()
    if isinstance(scripts, str):
        scripts = [line for line in scripts.splitlines() if line.strip()]
    elif isinstance(scripts, Mapping):
        scripts = [f"{name} = {target}" for name, target in scripts.items()]
    for text in scripts:
        match = ENTRY.fullmatch(str(text))
        if not match:
            message = (
                f"'{text}' is not a valid entry point; "
                "write it like 'talker = my_package.talker:main'"
            )
            raise UnreadableError(*_written_in(folder, "console_scripts"), message)
        yield match[1], f"{match[2]}:{match[3]}"


def _written_in(folder: Path, *words: str) -> tuple[Path, int]:
    """Return the file and line of the first of `words` that one of the setup files contains."""
    files = [folder / name for name in FILES if (folder / name).is_file()]
    for word in (form for each in words for form in (each, each.replace("_", "-"))):
        for file in files:
            lines = file.read_text(encoding="utf-8-sig", errors="replace").splitlines()
            for number, line in enumerate(lines, 1):
                if word in line:
                    return file, number
    return files[-1] if files else folder / "setup.py", 1
