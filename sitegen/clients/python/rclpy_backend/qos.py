"""Quality of service: profiles, their form in the page, and compatibility."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from rclpy_backend.enums import RMW_QOS_DEADLINE_BEST_AVAILABLE, QoSCompatibility

SYSTEM_DEFAULT = 0
KEEP_LAST, KEEP_ALL = 1, 2
RELIABLE, BEST_EFFORT = 1, 2
TRANSIENT_LOCAL, VOLATILE = 1, 2
AUTOMATIC, MANUAL_BY_TOPIC = 1, 3
UNKNOWN, UNKNOWN_LIVELINESS = 3, 4
BEST_AVAILABLE, BEST_AVAILABLE_LIVELINESS = 4, 5

TIMES = ("lifespan", "deadline", "liveliness_lease_duration")
POLICIES = (
    *("history", "depth", "reliability", "durability", "lifespan", "deadline", "liveliness"),
    *("liveliness_lease_duration", "avoid_ros_namespace_conventions"),
)
# History, depth, reliability, durability, lifespan, deadline, liveliness, lease.
_PREDEFINED = {
    "sensor_data": (KEEP_LAST, 5, BEST_EFFORT, VOLATILE, 0, 0, 0, 0),
    "default": (KEEP_LAST, 10, RELIABLE, VOLATILE, 0, 0, 0, 0),
    "system_default": (0, 0, 0, 0, 0, 0, 0, 0),
    "services_default": (KEEP_LAST, 10, RELIABLE, VOLATILE, 0, 0, 0, 0),
    "unknown": (UNKNOWN, 0, UNKNOWN, UNKNOWN, 0, 0, UNKNOWN_LIVELINESS, 0),
    "parameters": (KEEP_LAST, 1000, RELIABLE, VOLATILE, 0, 0, 0, 0),
    "parameter_events": (KEEP_LAST, 1000, RELIABLE, VOLATILE, 0, 0, 0, 0),
    "best_available": (
        *(KEEP_LAST, 10, BEST_AVAILABLE, BEST_AVAILABLE, 0, RMW_QOS_DEADLINE_BEST_AVAILABLE),
        *(BEST_AVAILABLE_LIVELINESS, RMW_QOS_DEADLINE_BEST_AVAILABLE),
    ),
    "rosout_default": (KEEP_LAST, 1000, RELIABLE, TRANSIENT_LOCAL, 10_000_000_000, 0, 0, 0),
}
_ACTION_STATUS = (KEEP_LAST, 1, RELIABLE, TRANSIENT_LOCAL, 0, 0, 0, 0, False)


class rmw_qos_profile_t:
    """A QoS profile; durations are in nanoseconds, 0 if unspecified."""

    def __init__(
        self,
        qos_history: int,
        qos_depth: int,
        qos_reliability: int,
        qos_durability: int,
        pyqos_lifespan: Any,
        pyqos_deadline: Any,
        qos_liveliness: int,
        pyqos_liveliness_lease_duration: Any,
        avoid_ros_namespace_conventions: bool,
    ) -> None:
        self.history = int(qos_history)
        self.depth = int(qos_depth)
        self.reliability = int(qos_reliability)
        self.durability = int(qos_durability)
        self.lifespan = _nanoseconds(pyqos_lifespan)
        self.deadline = _nanoseconds(pyqos_deadline)
        self.liveliness = int(qos_liveliness)
        self.liveliness_lease_duration = _nanoseconds(pyqos_liveliness_lease_duration)
        self.avoid_ros_namespace_conventions = avoid_ros_namespace_conventions

    def to_dict(self) -> dict[str, Any]:
        """Return the policies by name, with durations of rclpy."""
        from rclpy.duration import Duration

        policies = {name: getattr(self, name) for name in POLICIES}
        return policies | {name: Duration(nanoseconds=policies[name]) for name in TIMES}

    @staticmethod
    def predefined(qos_profile_name: str) -> rmw_qos_profile_t:
        """Return a predefined profile.

        Raises:
            ValueError: if the name is unknown.
        """
        values = _PREDEFINED.get(qos_profile_name.removeprefix("qos_profile_"))
        if values is None:
            raise ValueError(f"Requested unknown rmw_qos_profile: {qos_profile_name}")
        return rmw_qos_profile_t(*values, False)


def _nanoseconds(duration: Any) -> int:
    return int(getattr(duration, "nanoseconds", duration))


def rclpy_action_get_rmw_qos_profile(rmw_profile: str) -> dict[str, Any]:
    """Return the profile of an action's status topic.

    Raises:
        RuntimeError: if the name is unknown.
    """
    if rmw_profile != "rcl_action_qos_profile_status_default":
        raise RuntimeError(f"Requested unknown rmw_qos_profile: {rmw_profile}")
    return rmw_qos_profile_t(*_ACTION_STATUS).to_dict()


def host_qos(profile: rmw_qos_profile_t, *, offers: bool) -> dict[str, object]:
    """Return a profile as Qos of protocol.js.

    System defaults are those of Fast DDS: what an endpoint `offers` is stricter than what it
    requests.
    """
    reliable = profile.reliability == RELIABLE or (offers and profile.reliability != BEST_EFFORT)
    kept = profile.durability == TRANSIENT_LOCAL or (offers and profile.durability != VOLATILE)
    return {
        "depth": max(profile.depth, 1),
        "reliable": reliable,
        "transientLocal": kept,
        "keepAll": profile.history == KEEP_ALL,
        "manual": profile.liveliness == MANUAL_BY_TOPIC,
        "deadline": _limit(profile.deadline) / 1e6,
        "lifespan": _limit(profile.lifespan) / 1e6,
        "lease": _limit(profile.liveliness_lease_duration) / 1e6,
    }


def _limit(nanoseconds: int) -> float:
    """Return a duration, infinite if it is unspecified or the maximum."""
    endless = nanoseconds == 0 or nanoseconds >= RMW_QOS_DEADLINE_BEST_AVAILABLE
    return math.inf if endless else nanoseconds


class QoSCheckCompatibleResult:
    """Whether two profiles are compatible, and the reason if not."""

    def __init__(self) -> None:
        self.compatibility = QoSCompatibility.OK
        self.reason = ""


def rclpy_qos_check_compatible(
    publisher_qos_profile: rmw_qos_profile_t, subscription_qos_profile: rmw_qos_profile_t
) -> QoSCheckCompatibleResult:
    """Return whether the offered and the requested profile are compatible."""
    result = QoSCheckCompatibleResult()
    errors = list(_errors(publisher_qos_profile, subscription_qos_profile))
    warnings = list(_warnings(publisher_qos_profile, subscription_qos_profile))
    if errors:
        result.compatibility = QoSCompatibility.ERROR
        result.reason = "".join(f"ERROR: {what};" for what in errors)
    elif warnings:
        result.compatibility = QoSCompatibility.WARNING
        result.reason = "".join(f"WARNING: {what};" for what in warnings)
    return result


def _errors(offered: rmw_qos_profile_t, asked: rmw_qos_profile_t) -> Iterator[str]:
    if offered.reliability == BEST_EFFORT and asked.reliability == RELIABLE:
        yield "Best effort publisher and reliable subscription"
    if offered.durability == VOLATILE and asked.durability == TRANSIENT_LOCAL:
        yield "Volatile publisher and transient local subscription"
    yield from _time_errors(
        *(offered.deadline, asked.deadline, "Subscription has a deadline, but publisher does not"),
        "Subscription deadline is less than publisher deadline",
    )
    if offered.liveliness == AUTOMATIC and asked.liveliness == MANUAL_BY_TOPIC:
        yield "Publisher's liveliness is automatic and subscription's is manual by topic"
    yield from _time_errors(
        *(offered.liveliness_lease_duration, asked.liveliness_lease_duration),
        "Subscription has a liveliness lease duration, but publisher does not",
        "Subscription liveliness lease duration is less than publisher",
    )


def _time_errors(offered: int, asked: int, none: str, less: str) -> Iterator[str]:
    if _limit(asked) < math.inf and _limit(offered) == math.inf:
        yield none
    elif _limit(asked) < _limit(offered):
        yield less


def _warnings(offered: rmw_qos_profile_t, asked: rmw_qos_profile_t) -> Iterator[str]:
    """Yield possible incompatibilities: policies that one side leaves to the system."""
    pairs = (
        ("reliability", "Reliable", "Best effort", RELIABLE, BEST_EFFORT),
        ("durability", "Transient local", "Volatile", TRANSIENT_LOCAL, VOLATILE),
    )
    for policy, much, little, strong, weak in pairs:
        open_ = (SYSTEM_DEFAULT, UNKNOWN)
        one, other = getattr(offered, policy), getattr(asked, policy)
        words = "system_default" if SYSTEM_DEFAULT in (one, other) else "unknown"
        if one in open_ and other in open_:
            yield f"Publisher {policy} is {words} and subscription {policy} is {words}"
        elif one in open_ and other == strong:
            yield f"{much} subscription, but publisher is {words}"
        elif one == weak and other in open_:
            yield f"{little} publisher, but subscription is {words}"
    if offered.liveliness == SYSTEM_DEFAULT and asked.liveliness == SYSTEM_DEFAULT:
        default = "liveliness is system_default"
        yield f"Publisher {default} and subscription {default}"
