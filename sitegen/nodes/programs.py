"""Turn the nodes of a site into programs that its pages can run."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from sitegen import workspace
from sitegen.model import Container, Cpp, Node, Prebuilt, Programs, Site
from sitegen.nodes import share
from sitegen.nodes.cpp import compiler
from sitegen.nodes.cpp.jobs import Job
from sitegen.nodes.cpp.program import CppProgram
from sitegen.nodes.prebuilt.resolve import Unpacked
from sitegen.nodes.prebuilt.ros2wasm import ros2wasm_programs
from sitegen.nodes.python import missing
from sitegen.nodes.python.archives import python_programs
from sitegen.nodes.python.program import PythonProgram
from sitegen.options import Options
from sitegen.report import Report
from sitegen.workspace import containers


def programs_of(
    site: Site,
    prebuilt: Unpacked,
    *,
    options: Options,
    cache: Path,
    report: Report,
) -> Programs:
    """Return the programs of all nodes of `site`; `prebuilt` has those from archives.

    A program that only launch files start may lack a module of Python or a library that no page can
    have; with `keep_going`, any may.

    Raises: SiteError if any other program cannot be made.
    """
    nodes = nodes_of(site)
    # Errors in a Python program are reported before the minutes that compiling takes.
    ros2wasm = ros2wasm_programs(site, nodes, cache=cache)
    every = {(node.package, node.executable) for node in nodes}
    optional = every if options.keep_going else _only_launched(site)
    python = python_programs(site, nodes, optional=optional, cache=cache, report=report)

    engines = engines_of(site, options)
    own = compiler.compile_nodes(
        jobs_of(site, nodes, cache=cache) if options.compile else [],
        engines,
        root=site.root,
        workspace=site.workspace,
        cache=cache,
        report=report,
        options=options,
        optional=optional,
    )
    builds = {**own.builds, **prebuilt.builds}
    opening = {name for name, forms in builds.items() if share.opens_files(forms)}
    opened = share.share_of(site, opening, prebuilt.share)
    cpp = {
        node.program: CppProgram(
            node.package,
            node.executable,
            engines,
            builds.get((node.package, node.executable), ()),
            own.faults.get((node.package, node.executable), ""),
            own.licences,
            opened if node.program in opening else None,
        )
        for node in nodes
        if isinstance(node.kind, Cpp | Container | Prebuilt)
    }
    return {**ros2wasm, **python, **cpp}


def nodes_of(site: Site) -> list[Node]:
    """Return the nodes that the pages run, one for each program."""
    return list({n.program: n for page in site.pages for n in page.nodes.values()}.values())


def left_out(programs: Programs) -> list[str]:
    """Return a line for each module that Python programs lack, which cannot start."""
    python = (one for one in programs.values() if isinstance(one, PythonProgram))
    return missing.lines({one.name: one.missing for one in python})


def _only_launched(site: Site) -> set[tuple[str, str]]:
    """Return the programs, by package and executable, of nodes that only launch files start."""
    found: dict[bool, set[tuple[str, str]]] = {True: set(), False: set()}
    for page in site.pages:
        launched = {*page.launch.nodes, *page.launch.others} if page.launch else set()
        for name, node in page.nodes.items():
            found[name in launched].add((node.package, node.executable))
    return found[True] - found[False]


def engines_of(site: Site, options: Options) -> Sequence[str]:
    """Return the engines that C++ programs of `site` are built for."""
    engines = ("jspi", "asyncify") if site.asyncify else ("jspi",)
    return tuple(one for one in engines if not options.engines or one in options.engines)


def jobs_of(site: Site, nodes: Sequence[Node], *, cache: Path) -> list[Job]:
    """Return the jobs of the compiler, one for each package."""
    executables: dict[str, list[str]] = {}
    jobs = []
    for node in nodes:
        if isinstance(node.kind, Container):
            made = containers.package(node.executable, node.kind, site.packages, cache)
            *before, package = workspace.with_plugins(site.packages, made)
            jobs.append(Job(package, (node.executable,), tuple(before)))
        elif isinstance(node.kind, Cpp):
            executables.setdefault(node.package, []).append(node.executable)
    for name, wanted in executables.items():
        *before, package = workspace.with_plugins(site.packages, site.packages[name])
        jobs.append(Job(package, tuple(wanted), tuple(before)))
    return jobs
