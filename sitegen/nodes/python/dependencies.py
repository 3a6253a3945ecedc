"""Turn the imports of Python programs into wheels from PyPI and the Pyodide distribution."""

from __future__ import annotations

import hashlib
import json
import re
import tempfile
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from packaging.utils import canonicalize_name

from sitegen.cache.fetch import FetchError, fetch, mismatch
from sitegen.errors import Location, Problems
from sitegen.model import Package, Site
from sitegen.nodes.python import requirements
from sitegen.nodes.python.imports import Import
from sitegen.nodes.python.missing import Missing, message
from sitegen.nodes.python.pyodide import DOWNLOADS
from sitegen.nodes.python.wheel import Wheel, opened
from sitegen.report import Report
from sitegen.shipped import VENDOR
from sitegen.workspace import libraries
from sitegen.workspace.absent import NO_BUILD, clone
from sitegen.workspace.repositories import repository

# The index of the Pyodide distribution: its packages and their hashes.
DISTRIBUTION = VENDOR / "pyodide-packages.json"
PURE = "-none-any.whl"
LARGEST = 100_000_000
# Packages that every page has, because rclpy needs them.
THERE = {"pyyaml", "typing-extensions"}
# The prefix of ROS packages on PyPI; pages have these with rclpy and the messages.
OF_ROS = "ros-"
# The names of ROS packages whose Python modules are made from interfaces.
OF_INTERFACES = re.compile(r"_(msgs|interfaces|srvs)$")
# Repositories of ROS itself.
OWN = re.compile(r"(ros2?|ros-[\w-]+)/")
# Modules of Python that Pyodide lacks. Those of Windows are imported only there.
ABSENT = {
    *("curses", "dbm", "ensurepip", "grp", "pwd", "readline", "resource", "syslog", "tkinter"),
    *("turtle", "turtledemo", "venv"),
}
# Packages that need a window or the files of bags, or that are written in C++.
OF_C = {
    *("PyKDL", "PyQt4", "PyQt5", "PyQt6", "PySide2", "PySide6", "python_qt_binding", "qt_gui"),
    *("rosbag2_py", "rqt_gui", "rqt_gui_py"),
}
ADVICE = "add its package to the file given by 'pyodide: {requirements: requirements.txt}'"


# Package and executable.
Program = tuple[str, str]


@dataclass(frozen=True)
class Shelf:
    """Where wheels come from: the Pyodide distribution at `origin`, and the folder `cache`."""

    origin: str | Path
    cache: Path
    report: Report

    def has(self, packages: Iterable[Mapping[str, Any]]) -> bool:
        """Return whether it has packages, given by their entries; an address has all of them."""
        if not isinstance(self.origin, Path):
            return bool(self.origin)
        places = ((self.cache / one["sha256"], self.origin / one["file_name"]) for one in packages)
        return all(kept.exists() or given.exists() for kept, given in places)


@dataclass(frozen=True)
class Collected:
    """The wheels that each program needs, and the modules that the optional programs lack."""

    wheels: Mapping[Program, Sequence[Wheel]]
    missing: Mapping[Program, Missing]


def collect(
    site: Site,
    wanted: Mapping[Program, Mapping[str, Import]],
    *,
    optional: Collection[Program] = (),
    cache: Path,
    report: Report,
) -> Collected:
    """Return the wheels that each program needs.

    `wanted` maps each program to the modules that it imports from elsewhere. `report` names modules
    that are imported only conditionally and cannot be found.

    Raises: SiteError if wheels cannot be found, or modules of programs that are not `optional`,
        with the line of each import.
    """
    lock = json.loads(DISTRIBUTION.read_text())["packages"]
    origins = {module: name for name, each in lock.items() for module in each["imports"]}
    problems, notes = Problems(site.root), Problems(site.root)
    shelf = Shelf(site.pyodide.packages, cache / "wheels", report)
    declared = declared_by(site.packages.values())
    pinned = _pinned(site, lock, problems, shelf)
    given = {module for wheel in pinned for module in wheel.modules}
    own = {wheel.package for wheel in pinned}
    found: dict[Program, dict[str, Wheel]] = {program: {} for program in wanted}
    missing: dict[Program, dict[str, str]] = {}
    for program, modules in wanted.items():
        for module, (location, sure, quiet) in modules.items():
            wrong = problems if sure else notes
            names = _with_needs([origins[module]], lock) if module in origins else []
            if module in given:
                # A dependency of these is among them, or the build has reported that it is missing.
                found[program] |= {wheel.name: wheel for wheel in pinned}
            elif not names or not shelf.has([lock[name] for name in names if name not in own]):
                why = _unavailable(module, origins, lock, shelf.origin, declared)
                if sure and program in optional:
                    lacking = missing.setdefault(program, {})
                    lacking[message(module, why)] = problems.where(location)
                elif not quiet:
                    wrong.add(location, f"import {module}", why)
            else:
                others = [name for name in names if name not in own]
                try:
                    wheels = [_of_distribution(shelf, lock[name]) for name in others]
                    wheels += pinned if len(others) < len(names) else []
                    found[program] |= {wheel.name: wheel for wheel in wheels}
                except FetchError as error:
                    wrong.add(location, f"import {module}", str(error))
    problems.raise_if_any()
    for line in dict.fromkeys(notes.lines):
        report.say(f"{line} (skipped: imported only conditionally)")
    return Collected({key: list(wheels.values()) for key, wheels in found.items()}, missing)


def provided(site: Site, *, cache: Path, report: Report) -> set[str]:
    """Return the modules that `pyodide` in site.yaml provides, or an empty set."""
    lock = json.loads(DISTRIBUTION.read_text())["packages"]
    file = site.pyodide.requirements
    wheels = (
        requirements.pinned(file, site.root, cache=cache / "wheels", report=report) if file else ()
    )
    known = {module for each in lock.values() for module in each["imports"]}
    return {module for wheel in wheels for module in wheel.modules} | (
        known if site.pyodide.packages else set()
    )


def unavailable(module: str, declared: Collection[str] = ()) -> str:
    """Return the message about a module that no page has without configuration.

    `declared` are the packages that those of the workspace depend on.
    """
    lock = json.loads(DISTRIBUTION.read_text())["packages"]
    origins = {name: each for each, of in lock.items() for name in of["imports"]}
    return _unavailable(module, origins, lock, "", declared)


def declared_by(packages: Iterable[Package]) -> set[str]:
    """Return the names of the packages that `packages` depend on, by their package.xml."""
    return {name for package in packages for name in package.depends}


def _unavailable(
    module: str,
    origins: Mapping[str, str],
    lock: Mapping[str, Any],
    origin: str | Path,
    declared: Collection[str],
) -> str:
    if module in libraries.NEVER or module in ABSENT | OF_C:
        return f"needs '{module}', {NO_BUILD}"
    # Other packages for ROS share names with those of PyPI.
    known = repository(module)
    if known and (OF_INTERFACES.search(module) or module in declared or OWN.match(known.name)):
        return f"needs package '{module}', {clone(module)}"
    if module not in origins or (not origin and lock[origins[module]]["file_name"].endswith(PURE)):
        return f"module '{module}' is not available in the browser; {ADVICE}, or remove the import"
    return _advice(origins[module], lock, origin)


def _advice(name: str, lock: Mapping[str, Any], origin: str | Path) -> str:
    """Return the message about a package of the distribution that is not at `origin`."""
    files = [lock[each]["file_name"] for each in _with_needs([name], lock)]
    if isinstance(origin, Path):
        absent = ", ".join(file for file in files if not (origin / file).exists())
        where = "the folder of 'pyodide: packages'"
        return f"'{name}' is not in {where}; add {absent} from {DOWNLOADS}"
    return (
        f"'{name}' needs a build for Pyodide; write 'pyodide: {{packages: {DOWNLOADS}}}' in "
        f"site.yaml, or give a folder with {', '.join(files)} from there"
    )


def _pinned(site: Site, lock: Mapping[str, Any], problems: Problems, shelf: Shelf) -> list[Wheel]:
    """Return the wheels that the author pinned, and those of the distribution that they need."""
    file = site.pyodide.requirements
    if file is None:
        return []
    wheels = requirements.pinned(file, site.root, cache=shelf.cache, report=shelf.report)
    there = {wheel.package for wheel in wheels}
    names: list[str] = []
    for wheel in wheels:
        location = Location(file, _line(file, wheel.package))
        for need in sorted(wheel.needs - there - THERE):
            if need.startswith(OF_ROS):
                continue
            if need in lock and site.pyodide.packages:
                names.append(need)
                continue
            compiled = need in lock and not lock[need]["file_name"].endswith(PURE)
            how = _advice(need, lock, shelf.origin) if compiled else "add it to this file"
            problems.add(location, wheel.package, f"it needs '{need}'; {how}")
    for name in _with_needs(names, lock):
        if name not in there:
            try:
                wheels.append(_of_distribution(shelf, lock[name]))
            except FetchError as error:
                problems.add(Location(file, 1), name, str(error))
    return wheels


def _line(file: Path, package: str) -> int:
    """Return the location of `package` in a requirements file."""
    lines = file.read_text(encoding="utf-8-sig").splitlines()
    names = (canonicalize_name(re.split(r"[\[=; ]", line.strip())[0]) for line in lines)
    return next((n for n, name in enumerate(names, 1) if name == package), 1)


def _with_needs(names: Iterable[str], lock: Mapping[str, Any]) -> list[str]:
    found: dict[str, None] = {}
    waiting = list(names)
    while waiting:
        one = waiting.pop()
        if one not in found:
            found[one] = None
            # Their spelling varies: prompt_toolkit is prompt-toolkit.
            waiting += map(canonicalize_name, lock[one]["depends"])
    return list(found)


def _of_distribution(shelf: Shelf, entry: Mapping[str, Any]) -> Wheel:
    """Return a package of the Pyodide distribution.

    Raises: FetchError if it cannot be downloaded or read, or if its hash is wrong.
    """
    name, sha256, origin = entry["file_name"], entry["sha256"], shelf.origin
    kept = shelf.cache / sha256
    if not kept.exists():
        kept.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=kept.parent) as temporary:
            file = Path(temporary) / name
            if isinstance(origin, Path):
                _copy(origin / name, sha256, file)
            else:
                with shelf.report.during(name, "downloading"):
                    fetch(f"{origin}{name}", sha256, file, largest=LARGEST)
            file.replace(kept)
    return opened(name, kept)


def _copy(source: Path, sha256: str, to: Path) -> None:
    try:
        data = source.read_bytes()
    except OSError as error:
        raise FetchError(
            f"{source}: {error.strerror}; the distribution must be Pyodide release 314"
        ) from None
    found = hashlib.sha256(data).hexdigest()
    if found != sha256:
        raise FetchError(mismatch(source.name, found))
    to.write_bytes(data)
