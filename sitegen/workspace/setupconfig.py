"""Read what setup.cfg and pyproject.toml give to setuptools, as arguments of setup()."""

from __future__ import annotations

import configparser
import glob
import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from sitegen.workspace.setupnames import Files

FIND = ("find:", "find_namespace:")


class UnreadableError(Exception):
    """A setup file cannot be read; `fault` has the file, the line and a message."""

    def __init__(self, file: Path, line: int, message: str) -> None:
        super().__init__(message)
        self.fault = (file, line, message)


def parsed(text: str, where: Path, line: int | None = None) -> configparser.ConfigParser:
    """Return a file of sections.

    Raises: UnreadableError if it is not valid; `line` replaces the line of the error.
    """
    parser = configparser.ConfigParser(interpolation=None)
    # Names of packages may have capitals.
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    try:
        parser.read_string(text)
    except configparser.Error as error:
        message = f"cannot be read: {error}".replace("\n", " ")
        raise UnreadableError(where, line or int(getattr(error, "lineno", 1)), message) from None
    return parser


def cfg(folder: Path, name: str = "setup.cfg") -> dict[str, Any]:
    """Return the arguments that setup.cfg, or a file with another name, gives."""
    file = folder / name
    if not file.is_file():
        return {}
    try:
        parser = parsed(file.read_text(encoding="utf-8-sig"), file)
    except UnicodeDecodeError as error:
        raise UnreadableError(file, 1, f"cannot be read: {error}") from None
    options = dict(parser["options"]) if parser.has_section("options") else {}
    given: dict[str, Any] = {}
    if parser.has_section("options.entry_points"):
        given["entry_points"] = dict(parser["options.entry_points"])
    for name in ("py_modules", "scripts"):
        if name in options:
            given[name] = _list(options[name])
    if "package_dir" in options:
        pairs = (each.partition("=") for each in _list(options["package_dir"]))
        given["package_dir"] = {name.strip(): where.strip() for name, _, where in pairs}
    packages = _list(options.get("packages", ""))
    if packages and packages[0] in FIND:
        section = "options.packages.find"
        found = dict(parser[section]) if parser.has_section(section) else {}
        namespaces = packages[0] == "find_namespace:"
        where = {key: _list(text) for key, text in found.items()}
        given |= _found(folder, where, given.get("package_dir"), namespaces=namespaces)
    elif packages:
        given["packages"] = packages
    if "include_package_data" in options:
        given["include_package_data"] = options["include_package_data"].lower() in ("1", "true")
    for name in ("package_data", "exclude_package_data"):
        if parser.has_section(f"options.{name}"):
            pairs_of = parser[f"options.{name}"].items()
            given[name] = {key.lstrip("*"): _list(text) for key, text in pairs_of}
    if parser.has_section("options.data_files"):
        files = parser["options.data_files"].items()
        given["data_files"] = [(key, _expanded(folder, _list(text))) for key, text in files]
    return given


def pyproject(folder: Path) -> dict[str, Any]:
    """Return the arguments that pyproject.toml gives."""
    file = folder / "pyproject.toml"
    if not file.is_file():
        return {}
    try:
        data = tomllib.loads(file.read_text(encoding="utf-8-sig"))
    except ValueError as error:
        found = re.search(r"line (\d+)", str(error))
        raise UnreadableError(file, int(found[1]) if found else 1, str(error)) from None
    given: dict[str, Any] = {}
    scripts = _table(data, "project").get("scripts")
    if isinstance(scripts, Mapping):
        given["entry_points"] = {
            "console_scripts": [f"{name} = {target}" for name, target in scripts.items()]
        }
    tool = _table(_table(data, "tool"), "setuptools")
    if _table(data, "project") or tool:
        given["include_package_data"] = tool.get("include-package-data", True)
    for key in ("packages", "py-modules", "package-dir", "package-data", "exclude-package-data"):
        if key in tool and not (key == "packages" and isinstance(tool[key], Mapping)):
            given[key.replace("-", "_")] = tool[key]
    if isinstance(tool.get("packages"), Mapping):
        find = _table(tool["packages"], "find")
        where = {key: value for key, value in find.items() if _names(value)}
        namespaces = find.get("namespaces", True) is not False
        given |= _found(folder, where, given.get("package_dir"), namespaces=namespaces)
    if isinstance(tool.get("data-files"), Mapping):
        files = ((key, names) for key, names in tool["data-files"].items() if _names(names))
        given["data_files"] = [(key, _expanded(folder, names)) for key, names in files]
    return given


def _found(
    folder: Path,
    find: Mapping[str, Sequence[str]],
    roots: Any,
    *,
    namespaces: bool,
) -> dict[str, Any]:
    """Return the packages below the folders `where`, and where they are."""
    packages, folders = list[str](), dict(roots) if isinstance(roots, Mapping) else {}
    for where in find.get("where") or ["."]:
        try:
            names = Files(folder, folder).packages(
                where,
                find.get("exclude") or (),
                find.get("include") or ("*",),
                namespaces=namespaces,
            )
        except (OSError, ValueError):
            file = next(f for f in ("setup.cfg", "pyproject.toml") if (folder / f).is_file())
            message = f"packages.find: no folder '{where}' in the package"
            raise UnreadableError(folder / file, 1, message) from None
        packages += names
        if where != ".":
            folders |= {name: f"{where}/{name.replace('.', '/')}" for name in names}
    return {"packages": packages, "package_dir": folders}


def _list(text: str) -> list[str]:
    """Return the items of a list, which are on lines of their own or separated by commas."""
    parts = text.splitlines() if "\n" in text else text.split(",")
    return [part.strip() for part in parts if part.strip()]


def _expanded(folder: Path, patterns: Iterable[str]) -> list[str]:
    """Return the files that match patterns; a name that is no pattern is kept."""
    found: list[str] = []
    for pattern in patterns:
        wild = glob.has_magic(pattern) and ".." not in Path(pattern).parts
        found += sorted(glob.glob(pattern, root_dir=folder, recursive=True)) if wild else [pattern]  # noqa: PTH207
    return found


def _names(value: Any) -> bool:
    return isinstance(value, list) and all(isinstance(each, str) for each in value)


def _table(data: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    found = data.get(name)
    return found if isinstance(found, Mapping) else {}
