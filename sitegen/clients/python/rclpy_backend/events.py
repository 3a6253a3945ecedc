"""QoS events of publishers and subscriptions."""

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
    """The number of occurrences, in total and since the last report."""

    def __init__(self, event: Any) -> None:
        self.total_count = int(event.total)
        self.total_count_change = int(event.totalChange)


class rmw_requested_deadline_missed_status_t(_Counts):
    """A subscription received no message within its deadline."""


class rmw_offered_deadline_missed_status_t(_Counts):
    """A publisher sent no message within its deadline."""


class rmw_liveliness_lost_status_t(_Counts):
    """A publisher did not assert its liveliness in time."""


class rmw_message_lost_status_t(_Counts):
    """A subscription lost messages because it was too slow."""


class rmw_incompatible_type_status_t(_Counts):
    """Another endpoint uses the topic with a different type."""


class rmw_matched_status_t(_Counts):
    """The number of matched endpoints changed."""

    def __init__(self, event: Any) -> None:
        super().__init__(event)
        self.current_count = int(event.current)
        self.current_count_change = int(event.currentChange)


class rmw_liveliness_changed_status_t:
    """The liveliness of a publisher changed."""

    def __init__(self, event: Any) -> None:
        self.alive_count = int(event.current)
        self.alive_count_change = int(event.currentChange)
        self.not_alive_count = int(event.total)
        self.not_alive_count_change = int(event.totalChange)


class rmw_requested_qos_incompatible_event_status_t(_Counts):
    """A publisher offers incompatible QoS."""

    def __init__(self, event: Any) -> None:
        super().__init__(event)
        name = f"RMW_QOS_POLICY_{event.policy or 'INVALID'}"
        self.last_policy_kind = rmw_qos_policy_kind_t[name]


class _rmw_offered_qos_incompatible_event_status_t(rmw_requested_qos_incompatible_event_status_t):
    """A subscription requests incompatible QoS."""


_OF_PUBLISHER = rcl_publisher_event_type_t
_OF_SUBSCRIPTION = rcl_subscription_event_type_t
# The page's name of each event, and the status object for rclpy.
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
    """Reports one kind of event of one publisher or subscription."""

    def __init__(
        self,
        endpoint: Endpoint,
        event_type: rcl_publisher_event_type_t | rcl_subscription_event_type_t,
    ) -> None:
        super().__init__()
        self._endpoint = endpoint
        publisher = isinstance(event_type, rcl_publisher_event_type_t)
        # Both enumerations use the same numbers, which would collide as keys of one table.
        self._kind, self._status = (_PUBLISHER_KINDS if publisher else _SUBSCRIPTION_KINDS)[
            event_type
        ]
        self._event: Any = None
        self._seen = -1

    def is_ready(self, events: int | None = None) -> bool:
        """Return whether there is an event to report; `events` counts those of the program."""
        events = ros_host.events() if events is None else events
        if self._event is None and self._seen != events:
            self._seen = events
            self._event = ros_host.takeEvent(self._endpoint.id, self._kind)
        return self._event is not None

    def take_event(self) -> Any:
        """Return the status since the last call, or None."""
        if not self.is_ready():
            return None
        event, self._event = self._event, None
        return self._status(event)
