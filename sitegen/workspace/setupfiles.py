"""Find the files that setuptools would install of a Python package, without running setup.py."""

from __future__ import annotations

import ast
import configparser
import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any

from sitegen.workspace import literals, setupkeys

ENTRY = re.compile(r"\s*([\w.-]+)\s*=\s*([\w.]+)\s*:\s*([\w.]+)\s*(\[.*\])?")
NOT_MODULES = {"test", "tests", "build", "install", "log", "launch", "config", "resource"}
READ = (
    *("entry_points", "scripts", "packages", "package_dir", "py_modules", "package_data"),
    "data_files",
)
# The installation folder for the programs in `scripts`.
PROGRAMS = "lib/programs"


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


class _UnreadableError(Exception):
    def __init__(self, file: Path, line: int, message: str) -> None:
        super().__init__(message)
        self.fault = (file, line, message)


def read(folder: Path) -> Listing:
    """Return what setup.py, setup.cfg and pyproject.toml of a package define."""
    listing = Listing()
    try:
        given = {**_pyproject(folder), **_cfg(folder), **_py(folder)}
        for name, value in given.items():
            if why := setupkeys.fault(name, value):
                raise _UnreadableError(_written_in(folder, name), 1, why)
        listing.scripts = dict(_scripts(folder, given.get("entry_points")))
        listing.files = dict(_files(folder, given))
        for script in given.get("scripts") or ():
            name = PurePosixPath(str(script)).name
            for installed, file in _placed(folder, f"{PROGRAMS}/{name}", folder / str(script)):
                listing.scripts[name] = installed
                listing.files[installed] = file
    except _UnreadableError as error:
        listing.fault = error.fault
    return listing


def _py(folder: Path) -> dict[str, Any]:
    """Return the relevant arguments of setup() in setup.py."""
    file = folder / "setup.py"
    if not file.is_file():
        return {}
    try:
        tree = ast.parse(file.read_bytes())
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        line = getattr(error, "lineno", None) or 1
        raise _UnreadableError(file, line, f"not valid Python: {error}") from None
    call = next((node for node in ast.walk(tree) if _is_setup(node)), None)
    if not isinstance(call, ast.Call):
        raise _UnreadableError(file, 1, "no call of setup() found")
    reader = literals.Reader(tree, folder)
    given = {}
    for keyword in call.keywords:
        if keyword.arg is None or keyword.arg in READ:
            try:
                given[keyword.arg or "**"] = reader.value(keyword.value)
            except literals.NotLiteralError as error:
                what = f"{keyword.arg or 'setup'}: '{error}' is known only when setup.py runs"
                advice = (
                    "sitegen does not run setup.py; write the value out, or move it to setup.cfg"
                )
                raise _UnreadableError(file, error.line, f"{what}; {advice}") from None
    return given


def _is_setup(node: ast.AST) -> bool:
    if not isinstance(node, ast.Call):
        return False
    name = node.func.attr if isinstance(node.func, ast.Attribute) else node.func
    return name == "setup" or (isinstance(name, ast.Name) and name.id == "setup")


def _cfg(folder: Path) -> dict[str, Any]:
    """Return the same values from setup.cfg."""
    file = folder / "setup.cfg"
    parser = configparser.ConfigParser(interpolation=None)
    try:
        parser.read(file, encoding="utf-8-sig")
    except (configparser.Error, ValueError) as error:
        line = getattr(error, "lineno", 1)
        raise _UnreadableError(file, line, f"cannot be read: {error}") from None
    given: dict[str, Any] = {}
    if parser.has_section("options.entry_points"):
        given["entry_points"] = dict(parser["options.entry_points"])
    packages = parser.get("options", "packages", fallback="").split()
    if packages and packages[0] not in ("find:", "find_namespace:"):
        given["packages"] = packages
    modules = parser.get("options", "py_modules", fallback="").split()
    if modules:
        given["py_modules"] = modules
    where = parser.get("options.packages.find", "where", fallback="")
    if where:
        given["package_dir"] = {"": where}
    if parser.has_section("options.package_data"):
        data = parser["options.package_data"]
        given["package_data"] = {name.lstrip("*"): text.split() for name, text in data.items()}
    if parser.has_section("options.data_files"):
        files = parser["options.data_files"]
        given["data_files"] = [(name, text.split()) for name, text in files.items()]
    return given


def _pyproject(folder: Path) -> dict[str, Any]:
    """Return the same values from pyproject.toml."""
    file = folder / "pyproject.toml"
    if not file.is_file():
        return {}
    try:
        data = tomllib.loads(file.read_text(encoding="utf-8-sig"))
    except ValueError as error:
        found = re.search(r"line (\d+)", str(error))
        raise _UnreadableError(file, int(found[1]) if found else 1, str(error)) from None
    given: dict[str, Any] = {}
    scripts = _table(data, "project").get("scripts")
    if isinstance(scripts, Mapping):
        given["entry_points"] = {
            "console_scripts": [f"{name} = {target}" for name, target in scripts.items()]
        }
    tool = _table(_table(data, "tool"), "setuptools")
    for key, name in (
        ("packages", "packages"),
        ("py-modules", "py_modules"),
        ("package-dir", "package_dir"),
        ("package-data", "package_data"),
    ):
        if isinstance(tool.get(key), list) or (key != "packages" and key in tool):
            given[name] = tool[key]
    if isinstance(tool.get("data-files"), Mapping):
        given["data_files"] = list(tool["data-files"].items())
    return given


def _table(data: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    found = data.get(name)
    return found if isinstance(found, Mapping) else {}


def _scripts(folder: Path, entry_points: Any) -> Iterator[tuple[str, str]]:
    if isinstance(entry_points, str):
        parser = configparser.ConfigParser(interpolation=None, delimiters=("=",))
        try:
            parser.read_string(entry_points)
        except configparser.Error as error:
            message = f"entry_points: {error}".replace("\n", " ")
            raise _UnreadableError(_written_in(folder, "entry_points"), 1, message) from None
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
            raise _UnreadableError(_written_in(folder, "console_scripts"), 1, message)
        yield match[1], f"{match[2]}:{match[3]}"


def _written_in(folder: Path, word: str) -> Path:
    names = (folder / name for name in ("setup.py", "setup.cfg", "pyproject.toml"))
    files = [file for file in names if file.is_file()]
    return next((file for file in files if word in file.read_text(errors="replace")), files[-1])


def _files(folder: Path, given: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield the installed path of each file, and its path in the package."""
    roots = given.get("package_dir") or {}
    top = folder / str(roots.get("", "src" if (folder / "src").is_dir() else "."))
    packages = given.get("packages")
    if packages is None:
        packages = list(_discovered(top))
    for name in packages:
        source = folder / roots[name] if name in roots else top / name.replace(".", "/")
        patterns = ["*.py", *_patterns(given, name), *_patterns(given, "")]
        for file in sorted({file for pattern in patterns for file in source.glob(pattern)}):
            installed = f"python/{name.replace('.', '/')}/{file.relative_to(source).as_posix()}"
            yield from _placed(folder, installed, file)
    for module in given.get("py_modules") or ():
        path = f"{module.replace('.', '/')}.py"
        yield from _placed(folder, f"python/{path}", top / path)
    for target, names in given.get("data_files") or ():
        for name in names:
            yield from _placed(folder, f"{target}/{PurePosixPath(name).name}", folder / name)


def _patterns(given: Mapping[str, Any], package: str) -> list[str]:
    data = given.get("package_data") or {}
    return [str(pattern) for pattern in data.get(package, data.get("*", ()) if not package else ())]


def _discovered(top: Path) -> Iterator[str]:
    """Yield the packages that setuptools discovers automatically."""
    for file in sorted(top.rglob("__init__.py")):
        parts = file.relative_to(top).parts[:-1]
        if parts and parts[0] not in NOT_MODULES and not any(p.startswith(".") for p in parts):
            yield ".".join(parts)


def _placed(folder: Path, installed: str, file: Path) -> Iterator[tuple[str, str]]:
    path = PurePosixPath(installed)
    inside = file.resolve().is_relative_to(folder.resolve())
    if file.is_file() and inside and not path.is_absolute() and ".." not in path.parts:
        yield path.as_posix(), file.relative_to(folder).as_posix()
