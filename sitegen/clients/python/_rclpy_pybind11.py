"""Replace rclpy's C++ extension: re-export the names of rclpy_backend."""

# ruff: noqa: F401
from __future__ import annotations

from types import SimpleNamespace

from rclpy_backend.action import (
    ActionGoalHandle,
)
from rclpy_backend.action_client import (
    ActionClient,
)
from rclpy_backend.action_server import (
    ActionServer,
)
from rclpy_backend.arguments import (
    rclpy_remove_ros_args,
)
from rclpy_backend.cdr import (
    rclpy_deserialize,
    rclpy_serialize,
)
from rclpy_backend.clock import (
    Clock,
    ClockEvent,
    rcl_duration_t,
    rcl_time_point_t,
)
from rclpy_backend.enums import (
    RCL_DEFAULT_DOMAIN_ID,
    RCUTILS_LOG_SEVERITY,
    RMW_DURATION_INFINITE,
    RMW_QOS_DEADLINE_BEST_AVAILABLE,
    RMW_QOS_LIVELINESS_LEASE_DURATION_BEST_AVAILABLE,
    ClockChange,
    ClockType,
    GoalEvent,
    QoSCompatibility,
    ServiceIntrospectionState,
    SignalHandlerOptions,
    TransitionCallbackReturnType,
    rcl_publisher_event_type_t,
    rcl_subscription_event_type_t,
    rmw_qos_policy_kind_t,
)
from rclpy_backend.errors import (
    InvalidHandle,
    NodeNameNonExistentError,
    NotImplementedError,
    RCLError,
    RCLInvalidROSArgsError,
    RCUtilsError,
    RMWError,
    TimerCancelledError,
    UnknownROSArgsError,
    UnsupportedEventTypeError,
)
from rclpy_backend.events import (
    EventHandle,
    _rmw_offered_qos_incompatible_event_status_t,
    rmw_incompatible_type_status_t,
    rmw_liveliness_changed_status_t,
    rmw_liveliness_lost_status_t,
    rmw_matched_status_t,
    rmw_message_lost_status_t,
    rmw_offered_deadline_missed_status_t,
    rmw_requested_deadline_missed_status_t,
    rmw_requested_qos_incompatible_event_status_t,
)
from rclpy_backend.executor import (
    EventsExecutor,
)
from rclpy_backend.graph import (
    rclpy_get_client_names_and_types_by_node,
    rclpy_get_publisher_names_and_types_by_node,
    rclpy_get_publishers_info_by_topic,
    rclpy_get_service_names_and_types,
    rclpy_get_service_names_and_types_by_node,
    rclpy_get_subscriber_names_and_types_by_node,
    rclpy_get_subscriptions_info_by_topic,
    rclpy_get_topic_names_and_types,
)
from rclpy_backend.handles import (
    Context,
    Destroyable,
    GuardCondition,
)
from rclpy_backend.lifecycle import (
    LifecycleStateMachine,
)
from rclpy_backend.log import (
    rclpy_get_rmw_implementation_identifier,
    rclpy_logging_configure,
    rclpy_logging_fini,
    rclpy_logging_get_logger_effective_level,
    rclpy_logging_get_logger_level,
    rclpy_logging_get_logging_directory,
    rclpy_logging_get_separator_string,
    rclpy_logging_initialize,
    rclpy_logging_logger_is_enabled_for,
    rclpy_logging_rcutils_log,
    rclpy_logging_rosout_add_sublogger,
    rclpy_logging_rosout_remove_sublogger,
    rclpy_logging_set_logger_level,
    rclpy_logging_severity_level_from_string,
    rclpy_logging_shutdown,
)
from rclpy_backend.names import (
    rclpy_expand_topic_name,
    rclpy_get_validation_error_for_full_topic_name,
    rclpy_get_validation_error_for_namespace,
    rclpy_get_validation_error_for_node_name,
    rclpy_get_validation_error_for_topic_name,
    rclpy_remap_topic_name,
    rclpy_resolve_name,
)
from rclpy_backend.node import (
    Node,
)
from rclpy_backend.publisher import (
    Publisher,
    rclpy_assert_liveliness,
)
from rclpy_backend.qos import (
    QoSCheckCompatibleResult,
    rclpy_action_get_rmw_qos_profile,
    rclpy_qos_check_compatible,
    rmw_qos_profile_t,
)
from rclpy_backend.service import (
    Client,
    Service,
    TypeDescriptionService,
    rmw_request_id_t,
    rmw_service_info_t,
)
from rclpy_backend.signals import (
    get_current_signal_handlers_options,
    install_signal_handlers,
    register_sigint_guard_condition,
    uninstall_signal_handlers,
    unregister_sigint_guard_condition,
)
from rclpy_backend.subscription import (
    Subscription,
)
from rclpy_backend.timer import (
    Timer,
)
from rclpy_backend.wait_set import (
    WaitSet,
)

# Programs print these classes, and tracebacks name their module.
for _each in list(globals().values()):
    if isinstance(_each, type) and _each.__module__.startswith("rclpy_backend."):
        _each.__module__ = "rclpy._rclpy_pybind11"

service_introspection = SimpleNamespace(ServiceIntrospectionState=ServiceIntrospectionState)
