"""Endpoints: the common part of publishers, subscriptions, services and clients."""

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
    """One end of a topic or a service.

    Raises:
        RCLError: if the context has been shut down.
        ValueError: if `name` is invalid.
    """

    def __init__(
        self, kind: str, node: Node, ros_type: type, name: str, profile: rmw_qos_profile_t
    ) -> None:
        super().__init__()
        service = kind in ("service", "client")
        # rcl's messages differ for topics and services.
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
        """Return the logger name of the endpoint's node."""
        return self.node.logger_name()

    def gid(self) -> bytes:
        """Return the gid of the endpoint, 16 bytes."""
        return gid_bytes(ros_host.gid(self.id))

    def matched(self) -> int:
        """Return the number of matched endpoints."""
        return int(ros_host.matched(self.id))

    def is_ready(self) -> bool:
        """Return whether there is something to take."""
        return bool(ros_host.has(self.id))


def gid_bytes(gid: int) -> bytes:
    """Return a gid, a number, as the 16 bytes that rclpy expects."""
    return struct.pack("<d8x", gid)


def create(
    kind: str, node: str, name: str, type_name: str, profile: rmw_qos_profile_t, *, offers: bool
) -> int:
    """Announce an endpoint to the page and return its id in this program."""
    qos = to_js(host_qos(profile, offers=offers), dict_converter=ros_host.object)
    return int(ros_host.create(kind, node, name, type_name, qos))


def type_name(message_type: type) -> str:
    """Return the ROS name of a generated class, like std_msgs/msg/String."""
    package, kind, *_ = message_type.__module__.split(".")
    return f"{package}/{kind}/{message_type.__name__}"
