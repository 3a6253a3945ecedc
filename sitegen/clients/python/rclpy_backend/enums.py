"""Constants and enumerations that rclpy shares with its extension."""

from __future__ import annotations

from enum import Enum, IntEnum

RCL_DEFAULT_DOMAIN_ID = 2**64 - 1
RMW_DURATION_INFINITE = 2**63 - 1
RMW_QOS_DEADLINE_BEST_AVAILABLE = 2**63 - 2
RMW_QOS_LIVELINESS_LEASE_DURATION_BEST_AVAILABLE = 2**63 - 2


class _Named(IntEnum):
    """Print as enumerations of C++ extensions do."""

    __str__ = Enum.__str__


class ClockType(_Named):
    """The time source of a clock."""

    UNINITIALIZED = 0
    ROS_TIME = 1
    SYSTEM_TIME = 2
    STEADY_TIME = 3


class ClockChange(_Named):
    """How the source of a clock changed when its time jumped."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class GoalEvent(_Named):
    """Events of an action goal."""

    EXECUTE = 0
    CANCEL_GOAL = 1
    SUCCEED = 2
    ABORT = 3
    CANCELED = 4


class QoSCompatibility(_Named):
    """Whether a publisher and a subscription have compatible QoS."""

    OK = 0
    WARNING = 1
    ERROR = 2


class RCUTILS_LOG_SEVERITY(_Named):
    """The severity of a log message."""

    RCUTILS_LOG_SEVERITY_UNSET = 0
    RCUTILS_LOG_SEVERITY_DEBUG = 10
    RCUTILS_LOG_SEVERITY_INFO = 20
    RCUTILS_LOG_SEVERITY_WARN = 30
    RCUTILS_LOG_SEVERITY_ERROR = 40
    RCUTILS_LOG_SEVERITY_FATAL = 50


class SignalHandlerOptions(_Named):
    """Which signals rclpy handles."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


class rcl_publisher_event_type_t(_Named):
    """Events of a publisher."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class rcl_subscription_event_type_t(_Named):
    """Events of a subscription."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


class rmw_qos_policy_kind_t(_Named):
    """The kinds of QoS policy."""

    RMW_QOS_POLICY_INVALID = 1
    RMW_QOS_POLICY_DURABILITY = 2
    RMW_QOS_POLICY_DEADLINE = 4
    RMW_QOS_POLICY_LIVELINESS = 8
    RMW_QOS_POLICY_RELIABILITY = 16
    RMW_QOS_POLICY_HISTORY = 32
    RMW_QOS_POLICY_LIFESPAN = 64
    RMW_QOS_POLICY_DEPTH = 128
    RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION = 256
    RMW_QOS_POLICY_AVOID_ROS_NAMESPACE_CONVENTIONS = 512


class ServiceIntrospectionState(_Named):
    """What a service publishes about its calls."""

    OFF = 0
    METADATA = 1
    CONTENTS = 2


class TransitionCallbackReturnType(_Named):
    """The result of a lifecycle transition's callback."""

    SUCCESS = 97
    FAILURE = 98
    ERROR = 99

    def to_label(self) -> str:
        """Return the label of the transition that follows."""
        return f"transition_{self.name.lower()}"
