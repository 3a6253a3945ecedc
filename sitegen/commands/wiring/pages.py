"""Find the endpoints of each page that have no counterpart."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from sitegen.commands.wiring import commands, programs, python, widgets
from sitegen.commands.wiring.common import is_common
from sitegen.commands.wiring.endpoint import (
    ACTION,
    ACTION_CLIENT,
    CLIENT,
    OPPOSITE,
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    Endpoint,
    Program,
)
from sitegen.commands.wiring.names import of_nodes, resolved
from sitegen.config import notebooks
from sitegen.config.cellsources import sources
from sitegen.errors import Problems, nearest
from sitegen.model import Node, Page, Prebuilt, Ros2wasm, Site, Widget

# An action without a client is for visitors, who have a panel for it, as is a service.
_CHECKED = (SUBSCRIPTION, PUBLISHER, CLIENT, ACTION_CLIENT)


class _Side(NamedTuple):
    """An endpoint, and the name of its node or widget in messages."""

    who: str
    endpoint: Endpoint


def warnings(site: Site) -> list[str]:
    """Return what does not work between the nodes and widgets of each page, a line each.

    There is no warning about what only running the programs would tell.
    """
    problems = Problems(site.root)
    known: dict[tuple[str, str], Program] = {}
    for page in site.pages:
        # A translation has the nodes of its original.
        if page.original in (None, page.path):
            _look_at(page, site, known, problems)
    return problems.lines


def _look_at(
    page: Page, site: Site, known: dict[tuple[str, str], Program], problems: Problems
) -> None:
    own, some_unknown = widgets.endpoints(w for w in page.leaves if isinstance(w, Widget))
    # Scripts and cells, and what is beyond a gateway, may be the other side of anything.
    # What a visitor may type into a terminal is unknown, but not what the texts say of the page.
    unclear = bool(page.scripts or page.connect) or _has(page, notebooks.JAVASCRIPT)
    some_unknown = some_unknown or unclear
    sides = [_Side("this widget", endpoint) for endpoint in own]
    heard = False
    nodes: set[str] | None = set()
    cells = _cells(page, site)
    for name, node in page.nodes.items():
        if name in cells:
            continue
        key = (node.package, node.executable)
        if key not in known:
            known[key] = _program(site, node)
        found = of_nodes(known[key], node)
        nodes = None if nodes is None or found is None else nodes | found
        program = resolved(known[key], node)
        unclear = unclear or program.open
        some_unknown = some_unknown or unclear
        sides += (_Side(f"'{name}'", endpoint) for endpoint in program.endpoints)
        heard = heard or any(each.kind == SUBSCRIPTION for each in program.endpoints)
    typed = [_Side("this cell", one) for program in cells.values() for one in program.endpoints]
    some_unknown = some_unknown or any(program.open for program in cells.values())
    # A visitor may let a cell be the other side of anything.
    checked = typed if cells else sides
    sides += typed
    for side in checked:
        kind = side.endpoint.kind
        # A page that contains only talkers is intended.
        if side.endpoint.sure and not some_unknown and (kind != PUBLISHER or heard):
            _check_other_side(page, side, sides, problems)
    _check_types(sides, problems)
    unclear = unclear or bool(cells)
    if _has(page, "terminal"):
        endpoints = {name for side in sides for name in side.endpoint.names}
        names = commands.Names(None if unclear else endpoints, None if unclear else nodes)
        commands.check(page, site, names, problems)


def _has(page: Page, kind: str) -> bool:
    return any(isinstance(part, Widget) and part.kind == kind for part in page.leaves)


def _cells(page: Page, site: Site) -> dict[str, Program]:
    """Return what the cells of a page tell, by the node that runs them."""
    found = {node.name: Program() for node in notebooks.kernels(page.content)}
    for source in sources(site.root, page):
        program = resolved(python.read_cells(source), page.nodes[source.node])
        found[source.node].take(program)
    return found


def _program(site: Site, node: Node) -> Program:
    package = site.packages.get(node.package)
    if isinstance(node.kind, Prebuilt | Ros2wasm) or package is None:
        return Program(open=True)
    return programs.read(package, node.executable)


def _check_other_side(page: Page, side: _Side, sides: Iterable[_Side], problems: Problems) -> None:
    endpoint = side.endpoint
    opposite = (each.endpoint for each in sides if each.endpoint.kind == OPPOSITE[endpoint.kind])
    others = {name for each in opposite for name in each.names}
    known = {*endpoint.names, widgets.ANY} & others
    if endpoint.kind not in _CHECKED or known or is_common(endpoint.name):
        return
    does, missing, way = {
        SUBSCRIPTION: (
            "subscribes to",
            "which has no publisher",
            "a node that publishes it or a publish widget",
        ),
        PUBLISHER: (
            "publishes",
            "which has no subscription",
            "a node that subscribes to it or a topics widget",
        ),
        CLIENT: ("calls", "which has no server", "a node that provides it"),
        ACTION_CLIENT: ("sends goals to", "which has no server", "a node that provides it"),
    }[endpoint.kind]
    close = nearest(endpoint.name, sorted(name for name in others if not is_common(name)))
    advice = close if close.startswith("did") else f"add {way}, or remap the name"
    where = f"on page /{page.path}, {missing}"
    key = {CLIENT: "service", ACTION_CLIENT: "action"}.get(endpoint.kind, "topic")
    problems.add(endpoint.location, key, f"{side.who} {does} '{endpoint.name}' {where}; {advice}")


def _check_types(sides: Iterable[_Side], problems: Problems) -> None:
    sure = [side for side in sides if side.endpoint.sure and side.endpoint.type]
    for one, other in _pairs(sure):
        if one.endpoint.type != other.endpoint.type:
            key = {SERVICE: "service", ACTION: "action"}.get(one.endpoint.kind, "topic")
            name, there = other.endpoint.name, problems.where(one.endpoint.location)
            message = (
                f"'{name}' is {other.endpoint.type} for {other.who}, "
                f"but {one.endpoint.type} for {one.who} ({there}); use the same type for both"
            )
            problems.add(other.endpoint.location, key, message)


def _pairs(sides: list[_Side]) -> Iterator[tuple[_Side, _Side]]:
    """Yield each publisher or server, with the subscribers or clients of the same name."""
    for one in sides:
        if one.endpoint.kind in (PUBLISHER, SERVICE, ACTION):
            wanted = (OPPOSITE[one.endpoint.kind], one.endpoint.name)
            yield from ((one, o) for o in sides if (o.endpoint.kind, o.endpoint.name) == wanted)
