"""What goes wrong below rclpy, by the names that it knows."""

from __future__ import annotations

import builtins
from typing import Never


class RCUtilsError(RuntimeError):
    """Of the logging and the texts of ROS."""


class RMWError(RuntimeError):
    """Of the middleware."""


class RCLError(RuntimeError):
    """Of the ROS client library."""


class RCLInvalidROSArgsError(RCLError):
    """Arguments after --ros-args that cannot be read."""


class UnknownROSArgsError(RuntimeError):
    """Arguments after --ros-args that nobody knows."""


class NodeNameNonExistentError(RCLError):
    """A question about a node that is not there."""


class UnsupportedEventTypeError(RCLError):
    """An event that the middleware does not tell of."""


class TimerCancelledError(RCLError):
    """A call of a timer that was cancelled."""


class NotImplementedError(builtins.NotImplementedError):
    """What this middleware does not do."""


class InvalidHandle(RuntimeError):
    """Use of something that was destroyed."""


def refuse(what: str) -> Never:
    """Raise the error that says that `what` is not there."""
    raise NotImplementedError(f"{what} does not work in a page")
