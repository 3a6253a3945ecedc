"""Begin a site: write a site.yaml for a ROS 2 workspace that is there already."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from sitegen import workspace
from sitegen.errors import Problems, SiteError
from sitegen.model import Package
from sitegen.report import Report

FILE = "site.yaml"


def init(folder: Path, report: Report) -> None:
    """Write a site.yaml that builds, a page for each package; one that is there stays as it is."""
    file = folder / FILE
    if file.exists():
        raise SiteError([f"{file} exists already; remove it, or edit it"])
    problems = Problems(folder.resolve())
    packages = workspace.scan(folder.resolve(), problems=problems)
    problems.raise_if_any()
    shown = {name: package for name, package in packages.items() if package.executables}
    if not shown:
        raise SiteError([_nothing(folder, packages)])
    file.write_text("\n".join(_lines(folder.resolve().name, shown)) + "\n", encoding="utf-8")
    for name, package in shown.items():
        report.say(f"  /{name}/  {', '.join(package.executables or ())}")
    for name, package in packages.items():
        if package.executables is None:
            report.say(f"  {name}: only CMake can tell its executables; add those that you want")
    report.say(f"wrote {file}; now: sitegen serve")


def _nothing(folder: Path, packages: Mapping[str, Package]) -> str:
    if not packages:
        return f"{folder.resolve()}: no ROS package here or below; name the folder of a workspace"
    names = ", ".join(packages)
    return f"{folder.resolve()}: no package has an executable that could run on a page: {names}"


def _lines(title: str, packages: Mapping[str, Package]) -> Iterator[str]:
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
