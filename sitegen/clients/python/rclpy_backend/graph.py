"""Graph queries: nodes, and the topics, services and actions they use."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import ros_host

from rclpy_backend import names
from rclpy_backend.endpoint import gid_bytes
from rclpy_backend.enums import RMW_DURATION_INFINITE
from rclpy_backend.errors import NodeNameNonExistentError, RCLError
from rclpy_backend.qos import (
    AUTOMATIC,
    BEST_EFFORT,
    MANUAL_BY_TOPIC,
    RELIABLE,
    TRANSIENT_LOCAL,
    UNKNOWN,
    VOLATILE,
    rmw_qos_profile_t,
)
from rclpy_backend.system import blocking

if TYPE_CHECKING:
    from rclpy_backend.handles import Context
    from rclpy_backend.node import Node

NamesAndTypes = list[tuple[str, list[str]]]

# The suffixes of an action's feedback topic and its type.
FEEDBACK, FEEDBACK_TYPE = "/_action/feedback", "_FeedbackMessage"
# As in rmw_endpoint_type_t.
ENDPOINT_TYPES = {"publisher": 1, "subscription": 2}
# The topics of DDS by kind of endpoint: prefix and suffix of the name, suffix of the type.
DDS = {
    "publisher": [("rt", "", "")],
    "subscription": [("rt", "", "")],
    "service": [("rq", "Request", "_Request"), ("rr", "Reply", "_Response")],
    "client": [("rq", "Request", "_Request"), ("rr", "Reply", "_Response")],
}


class _Entry(NamedTuple):
    """A node or one of its endpoints."""

    gid: int
    kind: str
    node: str
    name: str
    type: str
    qos: Any


def _entries(*kinds: str) -> list[_Entry]:
    """Return the entries of these kinds; the first call waits for the page."""
    while (found := ros_host.look()) is None:
        blocking.wait(None)
    every = (
        _Entry(int(one.gid), one.endpoint.kind, one.endpoint.node, *_named(one.endpoint))
        for one in found
    )
    return [entry for entry in every if entry.kind in kinds]


def _named(endpoint: Any) -> tuple[str, str, Any]:
    return endpoint.name, endpoint.type, endpoint.qos


def _names_and_types(pairs: Iterable[tuple[str, str]]) -> NamesAndTypes:
    types: dict[str, set[str]] = {}
    for name, type_name in pairs:
        types.setdefault(name, set()).add(type_name)
    return [(name, sorted(types[name])) for name in sorted(types)]


def _plain(entries: Iterable[_Entry]) -> Iterator[tuple[str, str]]:
    return ((entry.name, entry.type) for entry in entries)


def _in_dds(entry: _Entry) -> Iterator[tuple[str, str]]:
    """Yield the DDS topic names and types of an endpoint."""
    package, kind, name = entry.type.split("/")
    for prefix, suffix, part in DDS[entry.kind]:
        yield f"{prefix}{entry.name}{suffix}", f"{package}::{kind}::dds_::{name}{part}_"


def _topics(entries: Iterable[_Entry], *, no_demangle: bool) -> NamesAndTypes:
    if no_demangle:
        return _names_and_types(pair for entry in entries for pair in _in_dds(entry))
    return _names_and_types(_plain(entries))


def _split(node: str) -> tuple[str, str]:
    """Return the name and namespace of a node."""
    namespace, _, name = node.rpartition("/")
    return name, namespace or "/"


def _of_node(
    context: Context, kinds: Iterable[str], what: str, name: str, namespace: str
) -> list[_Entry]:
    """Return the endpoints of these kinds of a node.

    Raises:
        RCLError: if the context has been shut down or a name is invalid.
        NodeNameNonExistentError: if there is no such node.
    """
    context.check(f"failed to get {what} names and types")
    # As in rcl, an empty namespace is not checked and matches no node.
    for fault in (
        namespace and names.rclpy_get_validation_error_for_namespace(namespace),
        names.rclpy_get_validation_error_for_node_name(name),
    ):
        if fault:
            raise RCLError(f"failed to get {what} names and types: {fault[0]}, result: 2")
    found = _entries("node", *kinds)
    if (name, namespace) not in (_split(entry.node) for entry in found):
        raise NodeNameNonExistentError(
            f"cannot get {what} names and types for nonexistent node: error not set"
        )
    own = (entry for entry in found if _split(entry.node) == (name, namespace))
    return [entry for entry in own if entry.kind != "node"]


def _count(context: Context, kind: str, name: str, function: str, argument: str) -> int:
    context.check(f"Error in rcl_count_{function}")
    fault = names.rclpy_get_validation_error_for_full_topic_name(name)
    if fault:
        reason = f"{argument}_name argument is invalid: {fault[0]}"
        raise RCLError(f"Error in rcl_count_{function}: {reason}")
    return sum(entry.name == name for entry in _entries(kind))


def _actions(entries: Iterable[_Entry]) -> NamesAndTypes:
    """Return the actions whose feedback topics are in `entries`."""
    return _names_and_types(
        (entry.name.removesuffix(FEEDBACK), entry.type.removesuffix(FEEDBACK_TYPE))
        for entry in entries
        if entry.name.endswith(FEEDBACK)
    )


class GraphQueries:
    """The graph queries of a node; they raise an RCLError after its context has been shut down."""

    context: Context

    def get_count_publishers(self, topic_name: str) -> int:
        """Return the number of publishers of a topic."""
        return _count(self.context, "publisher", topic_name, "publishers", "topic")

    def get_count_subscribers(self, topic_name: str) -> int:
        """Return the number of subscriptions of a topic."""
        return _count(self.context, "subscription", topic_name, "subscribers", "topic")

    def get_count_clients(self, service_name: str) -> int:
        """Return the number of clients of a service."""
        return _count(self.context, "client", service_name, "clients", "service")

    def get_count_services(self, service_name: str) -> int:
        """Return the number of servers of a service."""
        return _count(self.context, "service", service_name, "services", "service")

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Return all nodes."""
        self.context.check("Failed to get node names")
        return [_split(entry.node) for entry in _entries("node")]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """Return all nodes, with the only enclave of a page."""
        self.context.check("Failed to get node names")
        return [(*_split(entry.node), "/") for entry in _entries("node")]

    def get_action_client_names_and_types_by_node(
        self, remote_node_name: str, remote_node_namespace: str
    ) -> NamesAndTypes:
        """Return the actions for which a node has clients."""
        where = (remote_node_name, remote_node_namespace)
        return _actions(_of_action(self.context, "client", *where))

    def get_action_server_names_and_types_by_node(
        self, remote_node_name: str, remote_node_namespace: str
    ) -> NamesAndTypes:
        """Return the actions for which a node has servers."""
        where = (remote_node_name, remote_node_namespace)
        return _actions(_of_action(self.context, "server", *where))

    def get_action_names_and_types(self) -> NamesAndTypes:
        """Return all actions."""
        self.context.check("Failed to get action names and type")
        return _actions(_entries("publisher", "subscription"))


def _of_action(context: Context, side: str, name: str, namespace: str) -> list[_Entry]:
    context.check(f"Failed to get action {side} names and type")
    kind = "subscription" if side == "client" else "publisher"
    try:
        return _of_node(context, [kind], "action", name, namespace)
    except NodeNameNonExistentError:
        raise RCLError(f"Failed to get action {side} names and type: error not set") from None


def rclpy_get_topic_names_and_types(node: Node, no_demangle: bool) -> NamesAndTypes:
    """Return all topics; with `no_demangle`, those of DDS, including services."""
    node.context.check("failed to get topic names and types")
    kinds = DDS if no_demangle else ENDPOINT_TYPES
    return _topics(_entries(*kinds), no_demangle=no_demangle)


def rclpy_get_publisher_names_and_types_by_node(
    node: Node, no_demangle: bool, node_name: str, node_namespace: str
) -> NamesAndTypes:
    """Return the topics that a node publishes."""
    entries = _of_node(node.context, ["publisher"], "publisher", node_name, node_namespace)
    return _topics(entries, no_demangle=no_demangle)


def rclpy_get_subscriber_names_and_types_by_node(
    node: Node, no_demangle: bool, node_name: str, node_namespace: str
) -> NamesAndTypes:
    """Return the topics to which a node subscribes."""
    entries = _of_node(node.context, ["subscription"], "subscriber", node_name, node_namespace)
    return _topics(entries, no_demangle=no_demangle)


def rclpy_get_service_names_and_types(node: Node) -> NamesAndTypes:
    """Return all services."""
    node.context.check("failed to get service names and types")
    return _names_and_types(_plain(_entries("service", "client")))


def rclpy_get_service_names_and_types_by_node(
    node: Node, node_name: str, node_namespace: str
) -> NamesAndTypes:
    """Return the services for which a node has servers."""
    return _names_and_types(
        _plain(_of_node(node.context, ["service"], "service", node_name, node_namespace))
    )


def rclpy_get_client_names_and_types_by_node(
    node: Node, node_name: str, node_namespace: str
) -> NamesAndTypes:
    """Return the services for which a node has clients."""
    return _names_and_types(
        _plain(_of_node(node.context, ["client"], "client", node_name, node_namespace))
    )


def rclpy_get_publishers_info_by_topic(
    node: Node, topic_name: str, no_mangle: bool
) -> list[dict[str, Any]]:
    """Describe the publishers of a topic; with `no_mangle`, the name is that of DDS."""
    node.context.check("Failed to get information by topic for publishers")
    return _describe("publisher", topic_name, no_mangle=no_mangle)


def rclpy_get_subscriptions_info_by_topic(
    node: Node, topic_name: str, no_mangle: bool
) -> list[dict[str, Any]]:
    """Describe the subscriptions of a topic; with `no_mangle`, the name is that of DDS."""
    node.context.check("Failed to get information by topic for subscriptions")
    return _describe("subscription", topic_name, no_mangle=no_mangle)


def _describe(kind: str, topic: str, *, no_mangle: bool) -> list[dict[str, Any]]:
    name = re.sub("^rt", "", topic) if no_mangle else topic
    if no_mangle and name == topic:
        return []
    return [_description(entry) for entry in _entries(kind) if entry.name == name]


def _description(entry: _Entry) -> dict[str, Any]:
    name, namespace = _split(entry.node)
    return {
        "node_name": name,
        "node_namespace": namespace,
        "topic_type": entry.type,
        # The graph identifies types by name only.
        "topic_type_hash": {"version": 0, "value": bytes(32)},
        "endpoint_type": ENDPOINT_TYPES[entry.kind],
        "endpoint_gid": list(gid_bytes(entry.gid)),
        "qos_profile": _profile(entry.qos).to_dict(),
    }


def _profile(qos: Any) -> rmw_qos_profile_t:
    """Return the profile of an endpoint; as with DDS, its history is not known to others."""
    return rmw_qos_profile_t(
        *(UNKNOWN, 0),
        RELIABLE if qos.reliable else BEST_EFFORT,
        TRANSIENT_LOCAL if qos.transientLocal else VOLATILE,
        *(_nanoseconds(qos.lifespan), _nanoseconds(qos.deadline)),
        MANUAL_BY_TOPIC if qos.manual else AUTOMATIC,
        *(_nanoseconds(qos.lease), False),
    )


def _nanoseconds(milliseconds: float) -> int:
    return round(min(milliseconds * 1e6, RMW_DURATION_INFINITE))
