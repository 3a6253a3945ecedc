"""Publishers."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import ros_host
from pyodide.ffi import to_js

from rclpy_backend import cdr
from rclpy_backend.clock import rcl_duration_t
from rclpy_backend.endpoint import Endpoint
from rclpy_backend.errors import RCLError
from rclpy_backend.qos import rmw_qos_profile_t
from rclpy_backend.system import blocking

if TYPE_CHECKING:
    from rclpy_backend.node import Node

# How long a publisher that keeps all waits for room (s), as in C++.
MAX_BLOCKING = 1.0


class Publisher(Endpoint):
    """Sends messages of one type to a topic."""

    def __init__(
        self, node: Node, message_type: type, topic: str, profile: rmw_qos_profile_t
    ) -> None:
        super().__init__("publisher", node, message_type, topic, profile)
        self._type = message_type

    def get_topic_name(self) -> str:
        """Return the whole name of the topic."""
        return self._full_name

    def get_subscription_count(self) -> int:
        """Return how many subscriptions it has found."""
        self.check("failed to get subscription count")
        return self.matched()

    def check(self, doing: str) -> None:
        """Raise an RCLError if its context has ended: then it sends nothing more."""
        self.node.context.check(doing, "publisher")

    def publish(self, message: Any) -> None:
        """Send a message; raises a TypeError if it is not of the publisher's type."""
        self.publish_raw(cdr.serialize(message, self._type))

    def publish_raw(self, data: bytes) -> None:
        """Send the bytes of a message."""
        self.check("Failed to publish")
        message = to_js(data)
        end = time.monotonic() + MAX_BLOCKING
        while not ros_host.publish(self.id, message):
            left = end - time.monotonic()
            if left <= 0:
                full = f"the subscriptions of '{self._full_name}' have no room for more"
                raise RCLError(f"Failed to publish: {full}")
            blocking.wait(left)

    def wait_for_all_acked(self, timeout: rcl_duration_t) -> bool:
        """Wait until reliable subscriptions have got all; returns whether they have."""
        self.check("Failed to wait for all acknowledgements")
        limited = timeout.nanoseconds >= 0
        end = time.monotonic() + timeout.nanoseconds / 1e9
        while ros_host.behind(self.id):
            left = end - time.monotonic() if limited else None
            if left is not None and left <= 0:
                return False
            blocking.wait(left)
        return True


def rclpy_assert_liveliness(publisher: Publisher) -> None:
    """Say that a publisher lives, though it has nothing to send."""
    publisher.check("Failed to assert liveliness on the Publisher")
    ros_host.assertLiveliness(publisher.id)
