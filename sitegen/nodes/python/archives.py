"""Pack Python programs into archives that pages unpack: one for rclpy, one for each package."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.interfaces import generator, messages
from sitegen.interfaces.descriptions import described
from sitegen.interfaces.messages import MessageType
from sitegen.model import Node, Package, Python, Site
from sitegen.nodes import share
from sitegen.nodes.python import (
    arrays,
    bytecode,
    cellimports,
    dependencies,
    imports,
    included,
    ipython,
    syntax,
)
from sitegen.nodes.python.missing import Missing
from sitegen.nodes.python.program import Archive, PythonProgram
from sitegen.nodes.python.wheel import archived
from sitegen.report import Report
from sitegen.shipped import INTERFACES, ROS

KINDS = ("msg", "srv", "action")
# The interfaces that are most likely to be typed at a prompt.
TYPED = (
    "import example_interfaces.msg, example_interfaces.srv, geometry_msgs.msg, std_msgs.msg, "
    "std_srvs.srv"
)
# The interfaces that every rclpy node uses, besides those of its program.
SERVICES = (
    *("DescribeParameters", "GetParameterTypes", "GetParameters", "ListParameters"),
    *("SetParameters", "SetParametersAtomically"),
)
OF_RCLPY = {
    *("rcl_interfaces/msg/Log", "rcl_interfaces/msg/ParameterEvent"),
    *(f"rcl_interfaces/srv/{name}" for name in SERVICES),
    "type_description_interfaces/srv/GetTypeDescription",
}
# Those of a server or client of actions, beside its own.
OF_ACTIONS = {"action_msgs/srv/CancelGoal", "action_msgs/msg/GoalStatusArray"}
# Those that rclpy uses for programs with these words, which do not import them.
USED = {
    "rclpy.lifecycle": (
        *(f"lifecycle_msgs/srv/{name}" for name in ("GetState", "ChangeState")),
        "lifecycle_msgs/srv/GetAvailableTransitions",
        "lifecycle_msgs/msg/TransitionEvent",
    ),
    "enable_logger_service": (
        "rcl_interfaces/srv/GetLoggerLevels",
        "rcl_interfaces/srv/SetLoggerLevels",
    ),
}
COMMON = "nodes/ros.zip"
# The module of panels and bags, which only cells have.
IN_CELLS = "jupyros"
OF_CELLS = f"nodes/{IN_CELLS}.zip"
CELLS = {(workspace.SITEGEN, workspace.NOTEBOOK), (workspace.SITEGEN, workspace.CELLS)}
# The modules that Pyodide has besides those of Python itself.
IN_THE_PAGE = {"js", "pyodide", "pyodide_js", "_pyodide"}
IMPORTED = re.compile(r"\b(\w+)\.(msg|srv|action)\b")


@dataclass(frozen=True)
class Bundles:
    """The archives of a site's Python nodes, by path.

    `needed` has the paths of the archives of each program, by package and executable; `own` names
    the modules of the workspace in them; `types` has the message types of each package's nodes. A
    program with `missing` modules needs no archives.
    """

    archives: Mapping[str, bytes] = field(default_factory=dict)
    needed: Mapping[tuple[str, str], Sequence[str]] = field(default_factory=dict)
    own: Mapping[tuple[str, str], Sequence[str]] = field(default_factory=dict)
    types: Mapping[str, dict[str, MessageType]] = field(default_factory=dict)
    missing: Mapping[tuple[str, str], Missing] = field(default_factory=dict)


def python_programs(
    site: Site,
    nodes: Sequence[Node],
    *,
    optional: Collection[tuple[str, str]] = (),
    cache: Path,
    report: Report,
) -> dict[tuple[str, ...], PythonProgram]:
    """Return the Python programs among `nodes`.

    Raises: SiteError if interface definitions of the workspace are wrong, or modules are missing
        and the program, its package and executable, is not `optional`.
    """
    bundles = bundle(site, nodes, optional=optional, cache=cache, report=report)
    archives = {path: Archive(path, data) for path, data in bundles.archives.items()}
    found = {}
    for node in nodes:
        if isinstance(node.kind, Python):
            key = (node.package, node.executable)
            found[node.program] = PythonProgram(
                *key,
                target=node.kind.setup.scripts[node.executable],
                archives=[archives[path] for path in bundles.needed[key]],
                modules=bundles.own[key],
                messages=bundles.types[node.package],
                missing=bundles.missing.get(key, {}),
            )
    return found


def bundle(
    site: Site,
    nodes: Iterable[Node],
    *,
    optional: Collection[tuple[str, str]] = (),
    cache: Path,
    report: Report,
) -> Bundles:
    """Return the archives of the Python programs among `nodes`.

    Raises: SiteError if interface definitions or the syntax of a program are wrong, or modules of a
        program that is not `optional` are missing.
    """
    programs = {(node.package, node.executable) for node in nodes if isinstance(node.kind, Python)}
    if not programs:
        return Bundles()
    names = sorted({package for package, _ in programs})
    needs = {name: workspace.with_dependencies(site.packages, name) for name in names}
    problems = Problems(site.root)
    for package, executable in sorted(programs):
        syntax.check(imports.own(*_program(needs[package], executable)), problems)
    problems.raise_if_any()
    parts = {one.name: one for packages in needs.values() for one in packages}
    prefix = described(site, parts, cache=cache)
    wanted = {*_named(parts.values()), *_named_by_rclpy()}
    if workspace.SITEGEN in names:  # nobody knows what will be typed
        wanted |= set(_shares(prefix))
    brought = _rclpy()
    of_cells = {path: brought[path] for path in brought if path.split("/")[1] == IN_CELLS}
    brought = {path: brought[path] for path in brought.keys() - of_cells}
    common = {**brought, **dict(_classes(_with_nested(wanted, prefix), prefix))}
    wanted_modules = _wanted(programs, needs, common)
    small = set() if site.pyodide.packages else _content_with_ours(wanted_modules, needs)
    for program, modules in wanted_modules.items():
        if program[0] == workspace.SITEGEN:
            there = _there([*common, *of_cells])
            found = cellimports.imported(site, program[1])
            modules |= {name: one for name, one in found.items() if name not in there}
    for program in small:
        del wanted_modules[program]["numpy"]
    along = included.taken(wanted_modules, dependencies.provided(site, cache=cache, report=report))
    collected = dependencies.collect(
        site, wanted_modules, optional=optional, cache=cache, report=report
    )
    small -= collected.missing.keys()
    archives = {COMMON: archived(bytecode.added(common))}
    archives |= {arrays.PATH: archived(arrays.module())} if small else {}
    for package, executable in sorted(small):
        report.say(f"{package}/{executable}: no numpy, but the part of it that comes with sitegen")
    archives |= {_own(name): _own_archive(site, name, needs[name]) for name in names}
    needed: dict[tuple[str, str], Sequence[str]] = {}
    own: dict[tuple[str, str], Sequence[str]] = {}
    for package, executable in sorted(programs):
        if (package, executable) in collected.missing:
            needed[package, executable], own[package, executable] = (), ()
            continue
        wheels = collected.wheels[package, executable]
        others = {f"nodes/wheels/{wheel.name}.zip": wheel for wheel in wheels}
        archives |= {path: wheel.data for path, wheel in others.items()}
        ours = [arrays.PATH] if (package, executable) in small else []
        packed = {included.path(name): name for name in along[package, executable]}
        archives |= {path: included.archive(name) for path, name in packed.items()}
        ours += packed
        if (package, executable) in CELLS:
            archives[OF_CELLS] = archived(bytecode.added(of_cells))
            ours.append(OF_CELLS)
        if (package, executable) == (workspace.SITEGEN, workspace.NOTEBOOK):
            archives[ipython.PATH] = ipython.archive()
            ours.append(ipython.PATH)
        needed[package, executable] = (COMMON, *ours, *others, _own(package))
        paths = [path.split("/") for path in _installed(needs[package])]
        own[package, executable] = sorted(
            {p[1].removesuffix(".py") for p in paths if p[0] == "python"}
        )
    types = {name: _types(needs[name], prefix) for name in names}
    return Bundles(archives, needed, own, types, collected.missing)


def _own(package: str) -> str:
    return f"nodes/{package}/python.zip"


def _own_archive(site: Site, name: str, needs: Sequence[Package]) -> bytes:
    # A prompt depends on the whole workspace, whose files may be many.
    depends = needs if name != workspace.SITEGEN else []
    files = _shared([*depends, *_named_packages(site, name)]) | _installed(needs)
    return archived({path: file.read_bytes() for path, file in files.items()})


def missing_modules(node: Node, packages: Mapping[str, Package]) -> dict[str, imports.Import]:
    """Return the modules that a node always imports and that no page has by default.

    `packages` are those of the workspace and those that come with sitegen.
    """
    needs = {node.package: workspace.with_dependencies(packages, node.package)}
    described = [one.name for one in packages.values() if one.interfaces]
    own = [folder.name for folder in INTERFACES.iterdir()]
    common = [
        f"python/{name}" for name in (*bytecode.modules(), *own, *described) if name != IN_CELLS
    ]
    wanted = _wanted([(node.package, node.executable)], needs, common)
    small = _content_with_ours(wanted, needs)
    [modules] = wanted.values()
    return {
        name: one
        for name, one in modules.items()
        if one.sure and name not in included.MODULES and not (small and name == "numpy")
    }


def _wanted(
    programs: Iterable[tuple[str, str]],
    needs: Mapping[str, Sequence[Package]],
    common: Iterable[str],
) -> dict[tuple[str, str], dict[str, imports.Import]]:
    """Return the modules that each program imports and that not every page has."""
    there = _there(common)
    found = {}
    for package, executable in programs:
        program = _program(needs[package], executable)
        modules = imports.outside(*program)
        if "numpy" not in modules and (use := arrays.of_transforms(*program)):
            modules["numpy"] = use
        found[package, executable] = {
            name: path for name, path in modules.items() if name not in there
        }
    return found


def _there(common: Iterable[str]) -> set[str]:
    """Return the modules that every page with Python has; `common` are paths of modules."""
    there = {path.split("/")[1].removesuffix(".py") for path in common}
    return there | (sys.stdlib_module_names - dependencies.ABSENT) | IN_THE_PAGE


def _program(packages: Sequence[Package], executable: str) -> tuple[dict[str, Path], str]:
    """Return the files of a program of the last of `packages`, and its entry point."""
    *_, setup = (each.setup for each in packages if each.setup)
    return _installed(packages), setup.scripts[executable]


def _content_with_ours(
    wanted: Mapping[tuple[str, str], Iterable[str]], needs: Mapping[str, Sequence[Package]]
) -> set[tuple[str, str]]:
    """Return the programs for which sitegen's module can stand in for numpy."""
    return {
        (package, executable)
        for (package, executable), modules in wanted.items()
        if "numpy" in modules and arrays.enough(*_program(needs[package], executable))
    }


def _installed(packages: Iterable[Package]) -> dict[str, Path]:
    """Return the files of a package and of the packages that it needs, by path."""
    setups = (package.setup for package in packages if package.setup)
    return {path: file for setup in setups for path, file in setup.files.items()}


def _shared(packages: Iterable[Package]) -> dict[str, Path]:
    """Return what packages install to `share/`, by path, without meshes and their textures."""
    files = {path: file for package in packages for path, file in package.share.items()}
    return {
        path: file
        for path, file in files.items()
        if not path.lower().endswith(share.MESHES) and "/meshes/" not in path
    }


def _named_packages(site: Site, package: str) -> list[Package]:
    """Return the packages that the arguments of the Python nodes of a package name."""
    nodes = (node for page in site.pages for node in page.nodes.values())
    own = (node for node in nodes if node.package == package and isinstance(node.kind, Python))
    names = {name for node in own for name in share.named(node)}
    return [site.packages[name] for name in sorted(names & site.packages.keys())]


def _rclpy() -> dict[str, bytes]:
    """Return rclpy and all modules that it imports, except message classes, by path."""
    given = {share.name for share in generator.shares([ROS])}
    return {
        path: content for path, content in bytecode.brought() if path.split("/")[1] not in given
    }


def _shares(prefix: Path) -> dict[str, Path]:
    return {share.name: share for share in generator.shares([ROS, prefix])}


def _classes(packages: Iterable[str], prefix: Path) -> Iterator[tuple[str, bytes]]:
    """Yield the message classes of `packages`, by path."""
    for package in packages:
        for root in (prefix / "python", bytecode.PAGE):
            files = sorted((root / package).rglob("*.py"))
            for file in files:
                text = bytecode.with_our_numpy(file.read_bytes())
                yield f"python/{file.relative_to(root).as_posix()}", text
            if files:
                break


def _named(packages: Iterable[Package]) -> Iterator[str]:
    """Yield the packages whose messages `packages` may use: declared or imported ones."""
    for package in packages:
        yield package.name
        yield from package.depends
        for text in _sources(package):
            yield from (match[1] for match in IMPORTED.finditer(text))


def _named_by_rclpy() -> Iterator[str]:
    for file in (bytecode.PAGE / "rclpy").rglob("*.py"):
        yield from (match[1] for match in IMPORTED.finditer(file.read_text(encoding="utf-8")))


def _sources(package: Package) -> Iterator[str]:
    scripts = package.setup.scripts.values() if package.setup else ()
    for path, file in (package.setup.files if package.setup else {}).items():
        if file.suffix == ".py" or path in scripts:
            yield file.read_text(encoding="utf-8-sig", errors="replace")


def _with_nested(names: Iterable[str], prefix: Path) -> list[str]:
    """Return those of `names` that define interfaces, and all packages nested in these."""
    shares = _shares(prefix)
    found: set[str] = set()
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name in found or name not in shares:
            continue
        found.add(name)
        for kind in KINDS:
            for file in (shares[name] / kind).glob("*.json"):
                nested = re.findall(r'"nested_type_name": *"(\w+)/', file.read_text())
                waiting += dict.fromkeys(nested)
    return sorted(found)


def _types(packages: Iterable[Package], prefix: Path) -> dict[str, MessageType]:
    """Return the message types that modules of `packages` import, and the types nested in them."""
    shares = _shares(prefix)
    names = set(OF_RCLPY)
    for package in packages:
        if package.name == workspace.SITEGEN:
            names |= set(_imported(TYPED, shares))
        for text in _sources(package):
            names |= set(_imported(text, shares))
            names |= {one for word, ones in USED.items() if word in text for one in ones}
    if any("/action/" in name for name in names):
        names |= OF_ACTIONS
    parts = {"srv": ("_Request", "_Response"), "msg": ("",), "action": ("",)}
    every = (name + part for name in names for part in parts.get(name.split("/")[1], ()))
    return messages.types(every, [prefix])


def _imported(text: str, shares: Mapping[str, Path]) -> Iterator[str]:
    """Yield the interfaces that a module imports; for a package imported as a whole, all of it."""
    try:
        tree = ast.parse(text)
    except SyntaxError:
        return  # reported by syntax.check()
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            package, _, kind = node.module.partition(".")
            if package in shares and kind in KINDS:
                yield from (f"{package}/{kind}/{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import):
            for alias in node.names:
                package, _, kind = alias.name.partition(".")
                if package in shares and kind in KINDS:
                    files = (shares[package] / kind).glob("*.json")
                    yield from (f"{package}/{kind}/{file.stem}" for file in files)
