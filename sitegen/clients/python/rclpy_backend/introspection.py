"""Service introspection: publish the calls of a service on a topic."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING, Any

from rclpy_backend.clock import Clock
from rclpy_backend.publisher import Publisher
from rclpy_backend.qos import rmw_qos_profile_t

if TYPE_CHECKING:
    from rclpy_backend.node import Node

POSTFIX = "/_service_event"
SECOND = 1_000_000_000


class ServiceEvent(IntEnum):
    """The event types of service_msgs/msg/ServiceEventInfo."""

    REQUEST_SENT = 0
    REQUEST_RECEIVED = 1
    RESPONSE_SENT = 2
    RESPONSE_RECEIVED = 3


class Introspection:
    """Publishes the events of a client or server; with `contents`, including the messages."""

    def __init__(
        self,
        node: Node,
        service_type: Any,
        service_name: str,
        *,
        clock: Clock,
        profile: rmw_qos_profile_t,
        contents: bool,
    ) -> None:
        self._event = service_type.Event
        self._clock = clock
        self._contents = contents
        self._publisher = Publisher(node, self._event, f"{service_name}{POSTFIX}", profile)

    def tell(self, what: ServiceEvent, gid: bytes, sequence: int, **said: Any) -> None:
        """Publish an event; `gid` is that of the client, `said` has its `request` or `response`."""
        event = self._event()
        event.info.event_type = int(what)
        event.info.stamp.sec, event.info.stamp.nanosec = divmod(self._clock.now(), SECOND)
        event.info.client_gid = list(gid)
        event.info.sequence_number = sequence
        if self._contents:
            for field, message in said.items():
                setattr(event, field, [message])
        self._publisher.publish(event)

    def end(self) -> None:
        """Destroy the publisher."""
        self._publisher.destroy_when_not_in_use()
