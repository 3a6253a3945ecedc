"""Begin a site: write a site.yaml for a ROS 2 workspace that is there already."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from sitegen import workspace
from sitegen.errors import Problems, SiteError
from sitegen.github import workflows
from sitegen.model import Package
from sitegen.report import Report

FILE = "site.yaml"
LAUNCH = ("launch/**/*.launch.py", "launch/**/*.launch.xml", "launch/**/*.launch.yaml")
ROBOTS = ("urdf/**/*.urdf", "urdf/**/*.xacro")
# Of each kind, no more are listed.
LISTED = 12


def init(folder: Path, report: Report, *, github: bool = False) -> None:
    """Write a site.yaml that builds, a page for each package; one that is there stays as it is.

    For `github`, write workflows for the site, too; then a site.yaml may be there already.
    """
    # What is in the way is told before anything is written.
    files = workflows(folder.resolve()) if github else {}
    if not github or not (folder / FILE).exists():
        _write_site(folder, report)
    for file, text in files.items():
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        report.say(f"wrote {file}")
    source = "Settings → Pages of the repository"
    then = f"push, and choose GitHub Actions at {source}" if github else "sitegen serve"
    report.say(f"now: {then}")


def _write_site(folder: Path, report: Report) -> None:
    file = folder / FILE
    if file.exists():
        raise SiteError([f"{file} exists already; remove it, or edit it"])
    problems = Problems(folder.resolve())
    packages = workspace.scan(folder.resolve(), problems=problems)
    problems.raise_if_any()
    shown = {name: package for name, package in packages.items() if package.executables}
    if not shown:
        raise SiteError([_nothing(folder, packages)])
    lines = _lines(folder.resolve().name, shown, packages)
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    for name, package in shown.items():
        report.say(f"  /{name}/  {', '.join(package.executables or ())}")
    for name, package in packages.items():
        if package.executables is None:
            report.say(f"  {name}: only CMake can tell its executables; add those that you want")
    report.say(f"wrote {file}")


def _nothing(folder: Path, packages: Mapping[str, Package]) -> str:
    if not packages:
        return f"{folder.resolve()}: no ROS package here or below; name the folder of a workspace"
    names = ", ".join(packages)
    return f"{folder.resolve()}: no package has an executable that could run on a page: {names}"


def _lines(
    title: str, packages: Mapping[str, Package], all_of_them: Mapping[str, Package]
) -> Iterator[str]:
    names = _node_names(packages)
    yield "# What is on the site. Every key is described in docs/site-yaml.md of sitegen;"
    yield "# `sitegen serve` shows the site while you edit, and says what is wrong with it."
    yield "site:"
    yield f"  title: {_text(title.replace('_', ' ').replace('-', ' ').capitalize())}"
    yield "  # Where it will live, for previews of links that people share:"
    yield "  # url: https://me.github.io/my-robot/"
    yield "workspace: ."
    yield ""
    yield "# The programs that pages run. A node can also have a namespace, remaps and arguments:"
    yield "#   {package: …, executable: …, namespace: /demo, remap: {chatter: /chatter}}"
    yield "nodes:"
    for (owner, executable), name in names.items():
        yield f"  {name}: {{package: {owner}, executable: {executable}}}"
    yield ""
    yield "# The pages, in the order of the navigation; `markdown` is text or a file (.md)."
    yield "pages:"
    yield "  - path: /"
    yield "    title: Welcome"
    yield "    content:"
    yield "      - markdown: |"
    yield "          Programs of a robot, running in your browser."
    yield ""
    yield from (f"          - [{name}]({name}/)" for name in packages)
    for package in packages.values():
        yield from _page(package, [names[package.name, each] for each in package.executables or ()])
    yield from _also(all_of_them.values())


def _page(package: Package, nodes: Sequence[str]) -> Iterator[str]:
    yield ""
    yield f"  - path: {package.name}/"
    yield f"    title: {_text(package.name)}"
    yield "    content:"
    yield f"      - markdown: {_text(f'What {package.name} does, in a sentence.')}"
    for node in nodes:
        yield f"      # Without buttons, {node} would start with the page."
        yield f"      - buttons: {node}"
        yield f"      - console: {node}"
    yield "      # Who says what to whom; also try services, publish, nodes, graph and log."
    yield "      - topics:"


def _also(packages: Collection[Package]) -> Iterator[str]:
    """Yield comments about what the workspace has beside executables."""
    launch = {package.name: _files(package, LAUNCH) for package in packages}
    robots = {package.name: _files(package, ROBOTS) for package in packages}
    interfaces = {package.name: sorted(package.interfaces) for package in packages}
    yield from _listed(
        launch,
        "# Launch files of the workspace. No page runs one yet: name the nodes that they start",
        "# above, with the same namespaces, remaps and arguments.",
    )
    yield from _listed(robots, "# Robot descriptions, which no page shows yet:")
    yield from _listed(interfaces, "# Messages, services and actions, which all nodes may use:")


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


def _node_names(packages: Mapping[str, Package]) -> dict[tuple[str, str], str]:
    """Return a name for each executable: its own, with that of its package where two have it."""
    all_of_them = [(p.name, e) for p in packages.values() for e in p.executables or ()]
    often = Counter(executable for _, executable in all_of_them)
    return {
        (package, executable): executable if often[executable] == 1 else f"{package}_{executable}"
        for package, executable in all_of_them
    }


def _text(text: str) -> str:
    """Write text so that YAML reads it as text, whatever it is."""
    return json.dumps(text, ensure_ascii=False)
