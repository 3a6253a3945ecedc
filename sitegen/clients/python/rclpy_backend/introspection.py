"""Telling on a topic what a service is asked and what it answers."""

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
    """What happened to a request, as service_msgs/msg/ServiceEventInfo numbers it."""

    REQUEST_SENT = 0
    REQUEST_RECEIVED = 1
    RESPONSE_SENT = 2
    RESPONSE_RECEIVED = 3


class Introspection:
    """Publishes the events of one client or server; with `contents` what was said, too."""

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
        """Publish an event; `gid` is that of the client, `said` its `request` or `response`."""
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
        """Take the topic back."""
        self._publisher.destroy_when_not_in_use()
