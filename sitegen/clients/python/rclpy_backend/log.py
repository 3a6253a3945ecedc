"""Logging: logger levels, console output, and messages on /rosout."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import ros_host

from rclpy_backend.arguments import severities
from rclpy_backend.clock import nanoseconds
from rclpy_backend.enums import RCUTILS_LOG_SEVERITY
from rclpy_backend.errors import RCLError
from rclpy_backend.handles import Context
from rclpy_backend.qos import rmw_qos_profile_t

if TYPE_CHECKING:
    from rclpy_backend.node import Node

# The name of this middleware.
IDENTIFIER = "rmw_sitegen"

SEPARATOR = "."
_INFO = int(RCUTILS_LOG_SEVERITY.RCUTILS_LOG_SEVERITY_INFO)
_ERROR = int(RCUTILS_LOG_SEVERITY.RCUTILS_LOG_SEVERITY_ERROR)
# Levels of loggers by name; "" is the default level.
_levels: dict[str, int] = {"": _INFO}
# The publishers of /rosout by logger name.
_rosouts: dict[str, Rosout] = {}


class Rosout:
    """The publisher of a node's log messages."""

    def __init__(self, node: Node, profile: rmw_qos_profile_t) -> None:
        from rcl_interfaces.msg import Log

        from rclpy_backend.publisher import Publisher

        self._publisher = Publisher(node, Log, "/rosout", profile)
        _rosouts.setdefault(node.logger_name(), self)

    def close(self) -> None:
        """Destroy the publisher."""
        for name in [name for name, rosout in _rosouts.items() if rosout is self]:
            del _rosouts[name]
        self._publisher.destroy_when_not_in_use()

    def publish(
        self, severity: int, name: str, text: str, where: tuple[str, str, int], stamp: float
    ) -> None:
        """Publish a log message; `where` is its function, file and line, `stamp` its time in ms."""
        from builtin_interfaces.msg import Time
        from rcl_interfaces.msg import Log

        seconds, rest = divmod(nanoseconds(stamp), 10**9)
        function, file, line = where
        message: Any = Log(level=severity, name=name, msg=text, file=file, function=function)
        message.stamp = Time(sec=seconds, nanosec=rest)
        message.line = line
        try:
            self._publisher.publish(message)
        except RCLError as error:
            # The console shows the message in any case.
            reason = str(error).removeprefix("Failed to publish: ")
            print(f"Failed to publish log message to rosout: {reason}", file=sys.stderr)


def rclpy_logging_rcutils_log(
    severity: int, name: str, message: str, function_name: str, file_name: str, line_number: int
) -> None:
    """Log a message if its logger is enabled for the severity."""
    if not rclpy_logging_logger_is_enabled_for(name, severity):
        return
    sys.stdout.flush()
    stamp: float = ros_host.now()
    ros_host.log(int(severity), name, message, stamp, function_name, file_name, line_number)
    if rosout := _rosouts.get(name):
        rosout.publish(int(severity), name, message, (function_name, file_name, line_number), stamp)


def report(text: str) -> None:
    """Log an error of this layer."""
    rclpy_logging_rcutils_log(_ERROR, "rclpy", text, "", "", 0)


def rclpy_logging_rosout_add_sublogger(logger_name: str, sublogger_name: str) -> bool:
    """Publish the messages of a node's child logger; return whether there is such a node."""
    rosout = _rosouts.get(logger_name)
    if rosout is None:
        return False
    _rosouts.setdefault(f"{logger_name}{SEPARATOR}{sublogger_name}", rosout)
    return True


def rclpy_logging_rosout_remove_sublogger(logger_name: str, sublogger_name: str) -> None:
    """Stop publishing the messages of a child logger."""
    _rosouts.pop(f"{logger_name}{SEPARATOR}{sublogger_name}", None)


def rclpy_logging_configure(context: Context) -> None:
    """Set the logger levels of the command line."""
    _levels.update(context.arguments.log_levels)


def rclpy_logging_fini() -> None:
    """Do nothing: messages are passed to the page at once."""


def rclpy_logging_initialize() -> None:
    """Do nothing: logging is always initialized."""


def rclpy_logging_shutdown() -> None:
    """Reset all logger levels."""
    _levels.clear()
    _levels[""] = _INFO


def rclpy_logging_get_separator_string() -> str:
    """Return the separator of the parts of a logger name."""
    return SEPARATOR


def rclpy_logging_set_logger_level(name: str, level: int, detailed_error: bool = False) -> None:
    """Set the level of a logger."""
    _levels[name] = int(level)


def rclpy_logging_get_logger_level(name: str) -> int:
    """Return the level of a logger, 0 if unset."""
    return _levels.get(name, 0)


def rclpy_logging_get_logger_effective_level(name: str) -> int:
    """Return the level of a logger or, if unset, of its nearest ancestor."""
    while name and not _levels.get(name):
        name = name.rpartition(SEPARATOR)[0]
    return _levels.get(name) or _INFO


def rclpy_logging_logger_is_enabled_for(name: str, severity: int) -> bool:
    """Return whether a logger is enabled for this severity."""
    return int(severity) >= rclpy_logging_get_logger_effective_level(name)


def rclpy_logging_severity_level_from_string(log_level: str) -> int:
    """Return the number of a severity.

    Raises:
        RuntimeError: if the name is unknown.
    """
    level = severities().get(log_level.upper())
    if level is None:
        raise RuntimeError(f"Failed to get log severity from name: {log_level}")
    return level


def rclpy_logging_get_logging_directory() -> str:
    """Return the directory for log files; the page writes none."""
    return "/root/.ros/log"


def rclpy_get_rmw_implementation_identifier() -> str:
    """Return the name of this middleware."""
    return IDENTIFIER
