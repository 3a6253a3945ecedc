"""What publishers, subscriptions, services and clients have in common: a place in the graph."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING

import ros_host
from pyodide.ffi import to_js

from rclpy_backend import names
from rclpy_backend.errors import RCLError
from rclpy_backend.handles import Destroyable
from rclpy_backend.qos import host_qos, rmw_qos_profile_t

if TYPE_CHECKING:
    from rclpy_backend.node import Node


class Endpoint(Destroyable):
    """One end of a topic or a service; raises a ValueError if `name` cannot be its name."""

    def __init__(
        self, kind: str, node: Node, ros_type: type, name: str, profile: rmw_qos_profile_t
    ) -> None:
        super().__init__()
        service = kind in ("service", "client")
        # As rcl words it, of topics and of services.
        node.context.check(f"{'failed' if service else 'Failed'} to create {kind}")
        try:
            self._full_name = names.rclpy_resolve_name(node, name, False, service)
        except RCLError as error:
            raise ValueError(f"Failed to create {kind}: {error}") from None
        self.node = node
        self.profile = profile
        self.id = create(
            *(kind, node.get_fully_qualified_name(), self._full_name, type_name(ros_type), profile),
            offers=kind != "subscription",
        )

    def _destroy(self) -> None:
        ros_host.destroy(self.id)

    def get_logger_name(self) -> str:
        """Return the name of its node's logger."""
        return self.node.logger_name()

    def gid(self) -> bytes:
        """Return what tells it from all other endpoints of the page."""
        return gid_of(ros_host.nameOf(self.id))

    def matched(self) -> int:
        """Return how many endpoints it has found."""
        return int(ros_host.matched(self.id))

    def is_ready(self) -> bool:
        """Return whether something waits here to be taken."""
        return bool(ros_host.has(self.id))


def gid_of(name: int) -> bytes:
    """Return what messages and questions about the graph give as gid of an endpoint, 16 bytes."""
    return struct.pack("<d8x", name)


def create(
    kind: str, node: str, name: str, type_name: str, profile: rmw_qos_profile_t, *, offers: bool
) -> int:
    """Announce an endpoint to the page and return its id."""
    qos = to_js(host_qos(profile, offers=offers), dict_converter=ros_host.object)
    return int(ros_host.create(kind, node, name, type_name, qos))


def type_name(message_type: type) -> str:
    """Return the ROS name of a generated class, like std_msgs/msg/String."""
    package, kind, *_ = message_type.__module__.split(".")
    return f"{package}/{kind}/{message_type.__name__}"
