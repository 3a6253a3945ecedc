"""Find the parts of a workspace that can run on pages, and why the others cannot."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitegen import workspace
from sitegen.commands.init.members import Member, member
from sitegen.commands.init.robots import Robot, name_of, robots
from sitegen.config.nodes import Declared, check_package
from sitegen.errors import Location, Problems, relative
from sitegen.launch import LaunchDescription, launched
from sitegen.launch.absent import names_absent
from sitegen.model import Argument, Node, Package
from sitegen.nodes.python import archives, dependencies, missing
from sitegen.nodes.python.missing import Missing
from sitegen.workspace.absent import without
from sitegen.workspace.libraries import Library
from sitegen.workspace.unsupported import unsupported_libraries

# Both naming conventions of ROS: robot.launch.py and robot_launch.py.
LAUNCH = ("launch/**/*launch.py", "launch/**/*launch.xml", "launch/**/*launch.yaml")


@dataclass(frozen=True)
class Launched:
    """A launch file of a package: `file`, its path in the package, and what it starts.

    `chosen` are the arguments that have no default, for which `init` takes their first choice.
    `windows` says whether it opens some that are widgets on a page; it is `static` if it does
    nothing while its nodes run.
    """

    package: Package
    file: str
    members: Sequence[Member]
    windows: bool
    static: bool
    chosen: Sequence[Argument] = ()


@dataclass(frozen=True)
class Runs:
    """The parts of a workspace that can run on pages.

    `robots` are those that no launch file starts. `faults` has a line for each part that cannot
    run, with the reason.
    """

    programs: Sequence[Member]
    launches: Sequence[Launched]
    robots: Sequence[Robot]
    faults: Sequence[str]


def runs(root: Path, packages: Mapping[str, Package]) -> Runs:
    """Return the programs and the launch files below `root` that can run on pages."""
    programs: list[Member] = []
    launches: list[Launched] = []
    faults: list[str] = []
    described: set[str] = set()
    unsupported = {
        name: unsupported_libraries(package, packages) for name, package in packages.items()
    }
    lacking: dict[str, Missing] = {}
    there = {**workspace.shipped_packages(), **packages}
    for name, package in packages.items():
        location = Location(package.path / "package.xml", 1)
        nodes = [
            Node(title, name, executable, location)
            for title, executable in _names(package.executables or ()).items()
        ]
        wrong = _without(root, nodes, packages, unsupported) | _faults(root, nodes, packages)
        found = _lacking(root, [node for node in nodes if node.name not in wrong], packages)
        lacking |= found
        able = [node for node in nodes if node.name not in wrong and _key(node) not in found]
        programs += [member(node, there, packages) for node in able]
        faults += wrong.values()
        for file in files(package, LAUNCH):
            path = package.path / file
            launch, problems, notes, chosen = _described(path, there, root)
            lines = [*problems.lines, *_faults(root, launch.nodes, packages).values()]
            found = {} if lines else _lacking(root, launch.nodes, packages)
            # A build leaves these out of the pages of launch files, and those that lack modules.
            wrong = {} if lines else _without(root, launch.nodes, packages, unsupported)
            faults += wrong.values()
            able = [n for n in launch.nodes if _key(n) not in found and n.name not in wrong]
            faults += notes if not lines else []
            if not able and notes and not lines:
                continue
            if not able and not lines:
                what = "opens windows, but starts" if launch.windows else "starts"
                lines = [f"{what} no node that can run in the browser"]
            if lines:
                where = relative(path, root)
                faults.append(lines[0] if lines[0].startswith(where) else f"{where}: {lines[0]}")
                continue
            lacking |= found
            members = [member(node, there, packages) for node in able]
            plain = not launch.handlers
            launches.append(Launched(package, file, members, bool(launch.windows), plain, chosen))
            described |= {name_of(node) for node in able}
    shown, unclear = robots(root, packages, there, described)
    faults = [*dict.fromkeys(faults)]
    return Runs(programs, launches, shown, [*faults, *missing.lines(lacking), *unclear])


def _described(
    file: Path, packages: Mapping[str, Package], root: Path
) -> tuple[LaunchDescription, Problems, Sequence[str], Sequence[Argument]]:
    """Return what a launch file describes, what is wrong with it, and what needs absent packages.

    The last part are the arguments that it needs and has choices for.
    """
    chosen: dict[str, Argument] = {}
    # A choice may lead to a file that needs another argument.
    while True:
        problems, notes = Problems(root), Problems(root)
        given = {each.name: each.choices[0] for each in chosen.values()}
        found = launched(file, given, packages, problems, notes)
        needed = (each for each in found.arguments if each.default is None and each.choices)
        more = {each.name: each for each in needed if each.name not in chosen}
        if not more:
            # The first line about each package is enough.
            lacking = {names_absent(line): line for line in reversed(notes.lines)}
            lines = [line for package, line in reversed(lacking.items()) if package]
            return found, problems, lines, [*chosen.values()]
        chosen |= more


def files(package: Package, patterns: Iterable[str]) -> list[str]:
    """Return the files of a package that match one of `patterns`, relative to its folder."""
    found = (file for pattern in patterns for file in package.path.glob(pattern))
    return sorted(file.relative_to(package.path).as_posix() for file in found)


def _without(
    root: Path,
    nodes: Sequence[Node],
    packages: Mapping[str, Package],
    unsupported: Mapping[str, Mapping[str, Library]],
) -> dict[str, str]:
    """Return the libraries that nodes need and no page can have, by the names of such nodes."""
    faults = {}
    for node in nodes:
        library = unsupported.get(node.package, {}).get(node.executable)
        if library:
            folder = relative(packages[node.package].path, root)
            what = f"needs '{library.name}', {without(library)}"
            faults[node.name] = f"{folder}: '{node.executable}' {what}"
    return faults


def _faults(root: Path, nodes: Sequence[Node], packages: Mapping[str, Package]) -> dict[str, str]:
    """Return the reason why a node cannot run on a page, by the names of such nodes."""
    faults = {}
    there = workspace.with_shipped(packages, (node.package for node in nodes))
    for node in nodes:
        problems = Problems(root)
        check_package(Declared(node, None), there, problems)
        if problems.lines:
            faults[node.name] = problems.lines[0]
    return faults


def _lacking(
    root: Path, nodes: Sequence[Node], packages: Mapping[str, Package]
) -> dict[str, Missing]:
    """Return the modules that nodes import and that pages lack, by the keys of such nodes."""
    there = workspace.with_shipped(packages, (node.package for node in nodes))
    problems = Problems(root)
    declared = dependencies.declared_by(packages.values())
    found: dict[str, Missing] = {}
    for node in nodes:
        setup = there[node.package].setup if node.package in there else None
        if setup and node.executable in setup.scripts:
            found[_key(node)] = {
                missing.message(module, dependencies.unavailable(module, declared)): problems.where(
                    one.location
                )
                for module, one in archives.missing_modules(node, there).items()
            }
    return {key: modules for key, modules in found.items() if modules}


def _key(node: Node) -> str:
    return f"{node.package}/{node.executable}"


def _names(executables: Iterable[str]) -> dict[str, str]:
    """Return the executables of a package by valid names of nodes."""
    names: dict[str, str] = {}
    for executable in executables:
        name = re.sub(r"\W", "_", executable.removesuffix(".py"), flags=re.ASCII)
        name = f"node_{name}" if not name or name[0].isdigit() else name
        while name in names:
            name += "_"
        names[name] = executable
    return names
