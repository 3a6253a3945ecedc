"""Read the graph of ROS 2, and tell what comes and goes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sitegen.gateway.native.endpoint import Endpoint, Kind, Qos
from sitegen.gateway.native.types import from_profile

SERVICES = Qos()


class Graph:
    """The graph as `node` sees it, without the endpoints of this process, which `own` has.

    Everything is called in the thread of ROS.
    """

    def __init__(self, node: Any) -> None:
        self._node = node
        self.own: dict[str, Endpoint] = {}
        self._own_gids: dict[bytes, str] = {}
        self._known: dict[str, Endpoint] = {}

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
        return endpoint

    def remove(self, key: str) -> None:
        """Remove an endpoint of this process."""
        endpoint = self.own.pop(key, None)
        if endpoint and endpoint.gid:
            self._own_gids.pop(endpoint.gid, None)

    def changes(self) -> tuple[list[Endpoint], list[Endpoint]]:
        """Return the endpoints that have come and gone since the last call."""
        present = {endpoint.key: endpoint for endpoint in self._read()}
        come = [present[key] for key in present.keys() - self._known.keys()]
        gone = [self._known[key] for key in self._known.keys() - present.keys()]
        self._known = present
        # Nodes come before their endpoints, and go after them.
        come.sort(key=lambda endpoint: (endpoint.kind != "node", endpoint.key))
        gone.sort(key=lambda endpoint: (endpoint.kind == "node", endpoint.key))
        return come, gone

    def _read(self) -> Iterable[Endpoint]:
        # Those that belong to nobody, the gateway's shared subscriptions, are not shown.
        yield from [endpoint for endpoint in self.own.values() if endpoint.owner is not None]
        mine = {(e.kind, e.node, e.name) for e in self.own.values()}
        own_node = self._node.get_fully_qualified_name()
        nodes = {
            _node_of(namespace, name): (name, namespace)
            for name, namespace in self._node.get_node_names_and_namespaces()
        }
        nodes.pop(own_node, None)
        for full, (name, namespace) in nodes.items():
            if ("node", full, full) not in mine:
                yield Endpoint(f"node {full}", "node", full, full, "", "", SERVICES)
            yield from self._services(full, name, namespace, mine)
        for topic, _ in self._node.get_topic_names_and_types():
            for kind in ("publisher", "subscription"):
                for info in self._infos(topic, kind):
                    gid = bytes(info.endpoint_gid)
                    node = _node_of(info.node_namespace, info.node_name)
                    # An endpoint is discovered before its node.
                    if gid in self._own_gids or node not in nodes:
                        continue
                    yield Endpoint(
                        f"{kind} {gid.hex()}",
                        kind,
                        node,
                        topic,
                        info.topic_type,
                        str(info.topic_type_hash),
                        from_profile(info.qos_profile),
                        gid,
                    )

    def _services(
        self, full: str, name: str, namespace: str, mine: set[tuple[Kind, str, str]]
    ) -> Iterable[Endpoint]:
        kinds: tuple[tuple[Kind, Any], ...] = (
            ("service", self._node.get_service_names_and_types_by_node),
            ("client", self._node.get_client_names_and_types_by_node),
        )
        for kind, ask in kinds:
            try:
                found = ask(name, namespace)
            except Exception:
                # The node has gone since.
                continue
            for service, types in found:
                if (kind, full, service) in mine:
                    continue
                for type_name in types:
                    key = f"{kind} {full} {service} {type_name}"
                    yield Endpoint(key, kind, full, service, type_name, "", SERVICES)

    def _infos(self, topic: str, kind: str) -> Any:
        if kind == "publisher":
            return self._node.get_publishers_info_by_topic(topic)
        return self._node.get_subscriptions_info_by_topic(topic)


def _node_of(namespace: str, name: str) -> str:
    return f"{namespace.rstrip('/')}/{name}"


def _with_gid(endpoint: Endpoint, gid: bytes) -> Endpoint:
    fields = {**endpoint.__dict__, "gid": gid}
    return Endpoint(**fields)
