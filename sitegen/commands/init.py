"""Write a site.yaml for a ROS 2 workspace, with a page for each package and launch file."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import yaml

from sitegen import workspace
from sitegen.commands import installed, schema
from sitegen.commands.github import workflows
from sitegen.config.nodes import Declared, check_package
from sitegen.config.paths import segment
from sitegen.errors import Location, Problems, SiteError, relative
from sitegen.launch import Window, launched
from sitegen.model import Node, Package
from sitegen.nodes.python import archives, dependencies
from sitegen.report import Report
from sitegen.workspace.absent import absent, advice
from sitegen.workspace.unsupported import unsupported_libraries

FILE = "site.yaml"
# Both naming conventions of ROS: robot.launch.py and robot_launch.py.
LAUNCH = ("launch/**/*launch.py", "launch/**/*launch.xml", "launch/**/*launch.yaml")
ENDING = re.compile(r"[._]?launch\.(py|xml|yaml)$")
ROBOTS = ("urdf/**/*.urdf", "urdf/**/*.xacro")
# At most this many of each kind are listed.
LISTED = 12


@dataclass(frozen=True)
class Runs:
    """The parts of a workspace that can run on pages.

    `packages` are those with executables; `launch` maps paths of pages to launch files; `faults`
    has a line for each part that cannot run, with the reason.
    """

    packages: Sequence[Package]
    launch: Mapping[str, Path]
    faults: Sequence[str]


def init(folder: Path, report: Report, *, github: bool = False) -> None:
    """Write a site.yaml and its pages; existing files are left unchanged.

    For `github`, also write workflows; then a site.yaml may exist already.
    """
    # Errors are reported before anything is written.
    what = installed.requirement() if github else None
    files = workflows(folder.resolve(), what) if what else {}
    if not github or not (folder / FILE).exists():
        _write_site(folder, report)
    for file, text in files.items():
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        report.say(f"wrote {file}")
    if what:
        report.say(f"the workflows install {what.text}")
    if what and what.note:
        report.say(f"check SITEGEN in both workflows: {what.note}", "warning")
    source = "Settings → Pages of the repository"
    then = f"push, and choose GitHub Actions at {source}" if github else "sitegen serve"
    report.say(f"now: {then}")


def _write_site(folder: Path, report: Report) -> None:
    file = folder / FILE
    if file.exists():
        raise SiteError([f"{file} already exists; remove or edit it"])
    schema.check_free(folder)
    root = folder.resolve()
    problems = Problems(root)
    packages = workspace.scan(root, problems=problems)
    problems.raise_if_any()
    links = Problems(root)
    workspace.report_outside(root, links)
    runs = _runs(root, packages)
    runs = replace(runs, faults=[*runs.faults, *links.lines])
    if not runs.packages and not runs.launch:
        raise SiteError([_nothing(root, packages), *runs.faults])
    file.write_text("\n".join(_lines(root, runs, packages)) + "\n", encoding="utf-8")
    for package in runs.packages:
        report.say(f"  /{segment(package.name)}/  {', '.join(package.executables or ())}")
    for path, launch in runs.launch.items():
        report.say(f"  /{path}  {relative(launch, root)}")
    for name, package in packages.items():
        if package.executables is None:
            report.say(f"  {name}: its executables are known only to CMake; add the ones you want")
    for fault in runs.faults:
        report.say(f"  skipped: {fault}")
    for package in packages.values():
        for name in absent(package, packages):
            report.say(f"  {package.name}: needs '{name}', {advice(name)}", "warning")
    report.say(f"wrote {file}")
    report.say(f"wrote {schema.write(folder)}")


def _runs(root: Path, packages: Mapping[str, Package]) -> Runs:
    shown: list[Package] = []
    launch: dict[str, Path] = {}
    faults: list[str] = []
    missing = {name: unsupported_libraries(package) for name, package in packages.items()}
    for name, package in packages.items():
        location = Location(package.path / "package.xml", 1)
        nodes = [Node(each, name, each, location) for each in package.executables or ()]
        wrong = _faults(root, nodes, packages, missing)
        running = tuple(node.executable for node in nodes if node.name not in wrong)
        if running:
            shown.append(replace(package, executables=running))
        faults += dict.fromkeys(wrong.values())
        for file in _files(package, LAUNCH):
            problems = Problems(root)
            path = package.path / file
            windows: list[Window] = []
            there = {**workspace.shipped_packages(), **packages}
            started = launched(path, {}, there, problems, opened=windows)
            lines = [*problems.lines, *_faults(root, started, packages, missing).values()]
            if not started and not lines:
                what = "opens windows, but starts" if windows else "starts"
                lines = [f"{what} no node that can run in the browser"]
            if lines:
                where = relative(path, root)
                faults.append(lines[0] if lines[0].startswith(where) else f"{where}: {lines[0]}")
            else:
                launch[_page_path(package.name, file, launch)] = path
    return Runs(shown, launch, faults)


def _faults(
    root: Path,
    nodes: Sequence[Node],
    packages: Mapping[str, Package],
    missing: Mapping[str, Mapping[str, str]],
) -> dict[str, str]:
    """Return the reason why a node cannot run on a page, by the names of such nodes."""
    faults = {}
    there = workspace.with_shipped(packages, (node.package for node in nodes))
    for node in nodes:
        problems = Problems(root)
        check_package(Declared(node, None), there, problems)
        setup = there[node.package].setup if node.package in there else None
        what = missing.get(node.package, {}).get(node.executable)
        if what:
            folder = relative(packages[node.package].path, root)
            message = f"'{node.executable}' needs '{what}', which is not available in the browser"
            faults[node.name] = f"{folder}: {message}"
            continue
        if not problems.lines and setup and node.executable in setup.scripts:
            for module, (location, _) in archives.missing_modules(node, there).items():
                problems.add(location, f"import {module}", dependencies.unavailable(module))
        if problems.lines:
            faults[node.name] = problems.lines[0]
    return faults


def _page_path(package: str, file: str, taken: Collection[str]) -> str:
    """Return the path of the page for a launch file, which is at `file` in its package."""
    stem = ENDING.sub("", file.removeprefix("launch/")) or "launch"
    path = "/".join(segment(part) for part in (package, *stem.split("/"))) + "/"
    kind = Path(file).suffix.removeprefix(".")
    return path if path not in taken else f"{path.removesuffix('/')}-{kind}/"


def _nothing(folder: Path, packages: Mapping[str, Package]) -> str:
    if not packages:
        return f"{folder}: no ROS package found in this folder; give the folder of a workspace"
    names = ", ".join(packages)
    return f"{folder}: no package has an executable that can run in the browser: {names}"


def _lines(root: Path, runs: Runs, all_of_them: Mapping[str, Package]) -> Iterator[str]:
    title = root.name.replace("_", " ").replace("-", " ").capitalize()
    paths = [*(f"{segment(package.name)}/" for package in runs.packages), *runs.launch]
    yield schema.MODELINE
    yield "# The contents of the site. docs/site-yaml.md of sitegen describes every key;"
    yield "# `sitegen serve` shows the site while you edit it, and reports any errors."
    yield "site:"
    yield f"  title: {_text(title)}"
    yield "  # The address of the site, for link previews:"
    yield "  # url: https://me.github.io/my-robot/"
    yield "workspace: ."
    yield ""
    yield "# The pages, in navigation order; `markdown` is text or the name of a file (.md)."
    yield "pages:"
    yield "  - path: /"
    yield "    title: Welcome"
    yield "    content:"
    yield "      - markdown: |"
    yield "          ROS 2 nodes, running in your browser."
    yield ""
    yield from (f"          - [{path.removesuffix('/')}]({path})" for path in paths)
    for package in runs.packages:
        yield from _page(package, first=package is runs.packages[0])
    for path, launch in runs.launch.items():
        yield from _launch_page(path, relative(launch, root), first=path == next(iter(runs.launch)))
    yield from _also(all_of_them.values(), runs.faults)


def _page(package: Package, *, first: bool) -> Iterator[str]:
    nodes = _node_names(package)
    yield ""
    yield f"  - path: {segment(package.name)}/"
    yield f"    title: {_name(package.name)}"
    if first:
        yield "    # The nodes that the page runs. A node can have more keys:"
        yield "    #   {package: …, executable: …, namespace: /demo, remap: {chatter: /chatter}}"
    yield "    nodes:"
    for name, executable in nodes.items():
        yield f"      {name}: {{package: {_name(package.name)}, executable: {_name(executable)}}}"
    yield "    content:"
    yield f"      - markdown: {_text(f'Describe {package.name} in a sentence.')}"
    if first:
        yield "      # A node without buttons starts when the page opens."
    for name in nodes:
        yield f"      - buttons: {name}"
        yield f"      - console: {name}"
    if first:
        yield "      # All topics and messages; also try services, publish, nodes, graph and log."
    yield "      - topics:"


def _launch_page(path: str, file: str, *, first: bool) -> Iterator[str]:
    yield ""
    yield f"  - path: {path}"
    yield f"    title: {_name(path.removesuffix('/').rpartition('/')[2])}"
    if first:
        yield "    # Every node that this file starts, with buttons and a console. Its arguments:"
        yield "    #   launch_arguments: {robot_name: fox}"
    yield f"    launch: {_name(file)}"


def _also(packages: Collection[Package], faults: Sequence[str]) -> Iterator[str]:
    """Yield comments about the parts of the workspace that do not run."""
    robots = {package.name: _files(package, ROBOTS) for package in packages}
    interfaces = {package.name: sorted(package.interfaces) for package in packages}
    if faults:
        yield from ("", "# Skipped, because it cannot run in the browser as it is:")
        yield from (f"#   {fault}" for fault in faults)
    yield from _listed(robots, "# Robot descriptions, for nodes such as robot_state_publisher:")
    yield from _listed(interfaces, "# Messages, services and actions that all nodes can use:")


def _files(package: Package, patterns: Iterable[str]) -> list[str]:
    found = (file for pattern in patterns for file in package.path.glob(pattern))
    return sorted(file.relative_to(package.path).as_posix() for file in found)


def _listed(files: Mapping[str, Sequence[str]], *heading: str) -> Iterator[str]:
    if any(files.values()):
        yield from ("", *heading)
    for name, found in files.items():
        if found:
            more = f" and {len(found) - LISTED} more" if len(found) > LISTED else ""
            yield f"#   {name}: {', '.join(found[:LISTED])}{more}"


def _node_names(package: Package) -> dict[str, str]:
    """Return the executables of a package by valid names of nodes."""
    names: dict[str, str] = {}
    for executable in package.executables or ():
        name = re.sub(r"\W", "_", executable.removesuffix(".py"), flags=re.ASCII)
        name = f"node_{name}" if not name or name[0].isdigit() else name
        while name in names:
            name += "_"
        names[name] = executable
    return names


def _name(name: str) -> str:
    """Return a name as YAML, in quotes only if it needs them."""
    plain = re.fullmatch(r"[A-Za-z][\w./-]*", name, re.ASCII) and yaml.safe_load(name) == name
    return name if plain else _text(name)


def _text(text: str) -> str:
    """Return text as a YAML string."""
    return json.dumps(text, ensure_ascii=False)
