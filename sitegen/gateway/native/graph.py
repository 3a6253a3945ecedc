"""Read the graph of ROS 2, and tell what comes and goes."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Container, Iterator
from typing import Any

from sitegen.gateway.native.endpoint import Endpoint, Kind, Qos
from sitegen.gateway.native.types import from_profile

SERVICES = Qos()
Changes = tuple[list[Endpoint], list[Endpoint]]
# What a service, client or node is known by: its kind, its node, and its name.
_Place = tuple[Kind, str, str]


class Graph:
    """The graph as `node` sees it, without the endpoints of this process, which `own` has.

    Everything is called in the thread of ROS.
    """

    def __init__(self, node: Any) -> None:
        self._node = node
        self.own: dict[str, Endpoint] = {}
        self._own_gids: dict[bytes, str] = {}
        self._mine: Counter[_Place] = Counter()
        self._known: dict[str, Endpoint] = {}
        self._reading: Iterator[list[Endpoint]] | None = None
        self._found: dict[str, Endpoint] = {}
        self._spent = 0.0
        # The time that the last reading took (s).
        self.took = 0.0

    def owner(self, gid: bytes) -> str | None:
        """Return the party whose publisher has this gid, if it is of this process."""
        key = self._own_gids.get(gid)
        endpoint = self.own.get(key) if key else None
        return endpoint.owner if endpoint else None

    def gids(self, name: str, kind: Kind) -> set[bytes]:
        """Return the gids of the publishers or subscriptions of a topic."""
        return {bytes(info.endpoint_gid) for info in self._infos(name, kind)}

    def add(self, endpoint: Endpoint, gids_before: set[bytes] | None = None) -> Endpoint:
        """Add an endpoint of this process; its gid is the one that is new on its topic."""
        if gids_before is not None:
            now = {
                bytes(info.endpoint_gid)
                for info in self._infos(endpoint.name, endpoint.kind)
                if _node_of(info.node_namespace, info.node_name) == endpoint.node
            }
            new = sorted(now - gids_before - self._own_gids.keys())
            if new:
                endpoint = _with_gid(endpoint, new[0])
                self._own_gids[new[0]] = endpoint.key
        self.own[endpoint.key] = endpoint
        self._mine[_place(endpoint)] += 1
        return endpoint

    def remove(self, key: str) -> None:
        """Remove an endpoint of this process."""
        endpoint = self.own.pop(key, None)
        if endpoint is None:
            return
        place = _place(endpoint)
        self._mine[place] -= 1
        if not self._mine[place]:
            del self._mine[place]
        if endpoint.gid:
            self._own_gids.pop(endpoint.gid, None)

    def changes(self, limit: float) -> Changes | None:
        """Read on for `limit` (s), as messages wait meanwhile.

        Return the endpoints that have come and gone since the last reading when this one is
        complete, before that None.
        """
        begun = time.monotonic()
        if self._reading is None:
            self._reading, self._found, self._spent = self._read(), {}, 0.0
        try:
            for endpoints in self._reading:
                self._found.update((endpoint.key, endpoint) for endpoint in endpoints)
                if time.monotonic() - begun >= limit:
                    self._spent += time.monotonic() - begun
                    return None
        except Exception:
            self._reading = None
            raise
        self._reading = None
        self.took = self._spent + time.monotonic() - begun
        return self._compare(self._found)

    def _compare(self, present: dict[str, Endpoint]) -> Changes:
        come = [present[key] for key in present.keys() - self._known.keys()]
        gone = [self._known[key] for key in self._known.keys() - present.keys()]
        self._known = present
        # Nodes come before their endpoints, and go after them.
        come.sort(key=lambda endpoint: (endpoint.kind != "node", endpoint.key))
        gone.sort(key=lambda endpoint: (endpoint.kind == "node", endpoint.key))
        return come, gone

    def _read(self) -> Iterator[list[Endpoint]]:
        """Find all endpoints, in steps, between which those of this process may change."""
        own_node = self._node.get_fully_qualified_name()
        nodes = {
            _node_of(namespace, name): (name, namespace)
            for name, namespace in self._node.get_node_names_and_namespaces()
        }
        nodes.pop(own_node, None)
        # Of what goes between two steps, the graph may still tell.
        ours = set(self._mine)
        for full, (name, namespace) in nodes.items():
            at = ("node", full, full)
            node = Endpoint(f"node {full}", "node", full, full, "", "", SERVICES)
            foreign = [] if at in ours or at in self._mine else [node]
            yield foreign + self._services(full, name, namespace, ours)
        for topic, _ in self._node.get_topic_names_and_types():
            yield self._ends(topic, "publisher", nodes) + self._ends(topic, "subscription", nodes)
        # Those that belong to nobody, the gateway's shared subscriptions, are not shown.
        yield [endpoint for endpoint in self.own.values() if endpoint.owner is not None]

    def _ends(self, topic: str, kind: Kind, nodes: Container[str]) -> list[Endpoint]:
        found = []
        for info in self._infos(topic, kind):
            gid = bytes(info.endpoint_gid)
            node = _node_of(info.node_namespace, info.node_name)
            # An endpoint is discovered before its node.
            if gid in self._own_gids or node not in nodes:
                continue
            key, qos = f"{kind} {gid.hex()}", from_profile(info.qos_profile)
            digest = str(info.topic_type_hash)
            found.append(Endpoint(key, kind, node, topic, info.topic_type, digest, qos, gid))
        return found

    def _services(
        self, full: str, name: str, namespace: str, ours: Container[_Place]
    ) -> list[Endpoint]:
        kinds: tuple[tuple[Kind, Any], ...] = (
            ("service", self._node.get_service_names_and_types_by_node),
            ("client", self._node.get_client_names_and_types_by_node),
        )
        endpoints = []
        for kind, ask in kinds:
            try:
                found = ask(name, namespace)
            except Exception:
                # The node has gone since.
                continue
            for service, types in found:
                if (kind, full, service) in ours or (kind, full, service) in self._mine:
                    continue
                for type_name in types:
                    key = f"{kind} {full} {service} {type_name}"
                    endpoints.append(Endpoint(key, kind, full, service, type_name, "", SERVICES))
        return endpoints

    def _infos(self, topic: str, kind: str) -> Any:
        if kind == "publisher":
            return self._node.get_publishers_info_by_topic(topic)
        return self._node.get_subscriptions_info_by_topic(topic)


def _place(endpoint: Endpoint) -> _Place:
    return endpoint.kind, endpoint.node, endpoint.name


def _node_of(namespace: str, name: str) -> str:
    return f"{namespace.rstrip('/')}/{name}"


def _with_gid(endpoint: Endpoint, gid: bytes) -> Endpoint:
    fields = {**endpoint.__dict__, "gid": gid}
    return Endpoint(**fields)
