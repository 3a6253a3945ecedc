"""Events: what happens at a publisher or a subscription beside messages."""

from __future__ import annotations

from typing import Any

import ros_host

from rclpy_backend.endpoint import Endpoint
from rclpy_backend.enums import (
    rcl_publisher_event_type_t,
    rcl_subscription_event_type_t,
    rmw_qos_policy_kind_t,
)
from rclpy_backend.handles import Destroyable


class _Counts:
    """How often it happened, and how often since it was told the last time."""

    def __init__(self, event: Any) -> None:
        self.total_count = int(event.total)
        self.total_count_change = int(event.totalChange)


class rmw_requested_deadline_missed_status_t(_Counts):
    """A subscription heard nothing for too long."""


class rmw_offered_deadline_missed_status_t(_Counts):
    """A publisher said nothing for too long."""


class rmw_liveliness_lost_status_t(_Counts):
    """A publisher did not say in time that it lives."""


class rmw_message_lost_status_t(_Counts):
    """A subscription was too slow."""


class rmw_incompatible_type_status_t(_Counts):
    """Somebody has the topic with another type."""


class rmw_matched_status_t(_Counts):
    """Publisher and subscription found each other, or one left."""

    def __init__(self, event: Any) -> None:
        super().__init__(event)
        self.current_count = int(event.current)
        self.current_count_change = int(event.currentChange)


class rmw_liveliness_changed_status_t:
    """A publisher came to life, or did not say in time that it lives."""

    def __init__(self, event: Any) -> None:
        self.alive_count = int(event.current)
        self.alive_count_change = int(event.currentChange)
        self.not_alive_count = int(event.total)
        self.not_alive_count_change = int(event.totalChange)


class rmw_requested_qos_incompatible_event_status_t(_Counts):
    """Somebody offers less than is asked for."""

    def __init__(self, event: Any) -> None:
        super().__init__(event)
        name = f"RMW_QOS_POLICY_{event.policy or 'INVALID'}"
        self.last_policy_kind = rmw_qos_policy_kind_t[name]


class _rmw_offered_qos_incompatible_event_status_t(rmw_requested_qos_incompatible_event_status_t):
    """Somebody asks for more than is offered."""


_OF_PUBLISHER = rcl_publisher_event_type_t
_OF_SUBSCRIPTION = rcl_subscription_event_type_t
# The page's word for each event, and what rclpy is told.
_PUBLISHER_KINDS: dict[Any, tuple[str, type]] = {
    _OF_PUBLISHER.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED: (
        "deadline",
        rmw_offered_deadline_missed_status_t,
    ),
    _OF_PUBLISHER.RCL_PUBLISHER_LIVELINESS_LOST: ("liveliness", rmw_liveliness_lost_status_t),
    _OF_PUBLISHER.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS: (
        "incompatible",
        _rmw_offered_qos_incompatible_event_status_t,
    ),
    _OF_PUBLISHER.RCL_PUBLISHER_INCOMPATIBLE_TYPE: ("type", rmw_incompatible_type_status_t),
    _OF_PUBLISHER.RCL_PUBLISHER_MATCHED: ("matched", rmw_matched_status_t),
}
_SUBSCRIPTION_KINDS: dict[Any, tuple[str, type]] = {
    _OF_SUBSCRIPTION.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED: (
        "deadline",
        rmw_requested_deadline_missed_status_t,
    ),
    _OF_SUBSCRIPTION.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: (
        "liveliness",
        rmw_liveliness_changed_status_t,
    ),
    _OF_SUBSCRIPTION.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS: (
        "incompatible",
        rmw_requested_qos_incompatible_event_status_t,
    ),
    _OF_SUBSCRIPTION.RCL_SUBSCRIPTION_MESSAGE_LOST: ("lost", rmw_message_lost_status_t),
    _OF_SUBSCRIPTION.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE: ("type", rmw_incompatible_type_status_t),
    _OF_SUBSCRIPTION.RCL_SUBSCRIPTION_MATCHED: ("matched", rmw_matched_status_t),
}


class EventHandle(Destroyable):
    """Tells of one kind of event at one publisher or subscription."""

    def __init__(
        self,
        endpoint: Endpoint,
        event_type: rcl_publisher_event_type_t | rcl_subscription_event_type_t,
    ) -> None:
        super().__init__()
        self._endpoint = endpoint
        publisher = isinstance(event_type, rcl_publisher_event_type_t)
        # Both enumerations have the same numbers: as keys of one table they would be equal.
        self._kind, self._status = (_PUBLISHER_KINDS if publisher else _SUBSCRIPTION_KINDS)[
            event_type
        ]
        self._event: Any = None
        self._seen = -1

    def is_ready(self, events: int | None = None) -> bool:
        """Return whether there is something to tell; `events` is how many there were by now."""
        events = ros_host.events() if events is None else events
        if self._event is None and self._seen != events:
            self._seen = events
            self._event = ros_host.takeEvent(self._endpoint.id, self._kind)
        return self._event is not None

    def take_event(self) -> Any:
        """Return what happened since the last time, or None."""
        if not self.is_ready():
            return None
        event, self._event = self._event, None
        return self._status(event)
