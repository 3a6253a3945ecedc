"""Put packages in the order in which they are built."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitegen.errors import SiteError
from sitegen.model import Package

PLUGINS = "pluginlib"


def with_dependencies(packages: Mapping[str, Package], name: str) -> list[Package]:
    """Return the package `name` after all packages of the workspace that it depends on."""
    ordered: dict[str, Package] = {}
    _visit(packages, name, (), ordered)
    return list(ordered.values())


def with_plugins(packages: Mapping[str, Package], name: str) -> list[Package]:
    """Return the package `name` after all that its programs are made of.

    Those are the packages it depends on and, if it may load plugins, those that have some for any
    of these or for itself. They depend on it, so it is among them, too, as what they need.
    """
    *before, package = with_dependencies(packages, name)
    known = {name, *(each.name for each in before)}
    linked = [
        each.name
        for each in packages.values()
        if PLUGINS in known and each.name not in known and known & set(each.plugins)
    ]
    needs = {each.name: each for each in before}
    for one in linked:
        needs |= {each.name: each for each in with_dependencies(packages, one)}
    return [*needs.values(), replace(package, linked=tuple(linked))]


def _visit(
    packages: Mapping[str, Package], name: str, above: tuple[str, ...], ordered: dict[str, Package]
) -> None:
    if name in above:
        circle = " → ".join([*above[above.index(name) :], name])
        message = f"packages depend on each other in a circle, {circle}; remove one <depend>"
        raise SiteError([f"package.xml of '{name}': {message}"])
    if name in ordered or name not in packages:
        return
    for depend in packages[name].depends:
        _visit(packages, depend, (*above, name), ordered)
    ordered[name] = packages[name]
