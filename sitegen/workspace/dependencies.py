"""Order packages for the build."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from graphlib import CycleError, TopologicalSorter

from sitegen.errors import SiteError
from sitegen.model import Package

PLUGINS = "pluginlib"
# Programs that depend on these open libraries with nodes of behavior trees.
TREES = ("behaviortree_cpp", "behaviortree_cpp_v3")


def with_dependencies(packages: Mapping[str, Package], name: str) -> list[Package]:
    """Return the package `name` after all packages of the workspace that it depends on.

    Raises: SiteError if packages depend on each other in a cycle.
    """
    graph: dict[str, list[str]] = {}
    waiting = [name] if name in packages else []
    while waiting:
        one = waiting.pop(0)
        if one not in graph:
            graph[one] = [each for each in packages[one].depends if each in packages]
            waiting += graph[one]
    try:
        return [packages[one] for one in TopologicalSorter(graph).static_order()]
    except CycleError as error:
        cycle = error.args[1][::-1]  # from a package to what it depends on
        message = f"packages depend on each other in a cycle: {' → '.join(cycle)}"
        raise SiteError([f"package.xml of '{cycle[0]}': {message}; remove one <depend>"]) from None


def with_plugins(packages: Mapping[str, Package], package: Package) -> list[Package]:
    """Return `package` after all packages that its programs are made of.

    These are the packages that it depends on and, if it may load plugins, the packages that have
    plugins for any of these or for itself, and those that have plugins for such plugins. Packages
    with plugins for it depend on it, so it is also built as one of their dependencies.
    """
    before = (with_dependencies(packages, name) for name in package.depends)
    needs = {each.name: each for one in before for each in one}
    linked: list[str] = []

    def more() -> Iterator[str]:
        known = {package.name, *needs}
        bases = known if PLUGINS in known else {*needs} & {*TREES}
        for each in packages.values():
            if each.name not in known and bases & {*each.plugins}:
                yield each.name

    while found := list(more()):
        linked += found
        for one in found:
            needs |= {each.name: each for each in with_dependencies(packages, one)}
    return [*needs.values(), replace(package, linked=tuple(linked))]


def closure(package: Package, packages: Mapping[str, Package]) -> list[Package]:
    """Return the packages among `packages` that `package` depends on, in build order."""
    names = set(package.depends)
    for one in reversed(list(packages.values())):
        names |= set(one.depends) if one.name in names else set()
    return [one for name, one in packages.items() if name in names]
