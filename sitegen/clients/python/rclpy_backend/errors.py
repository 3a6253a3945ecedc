"""The exceptions of rclpy's extension."""

from __future__ import annotations

import builtins
from typing import Never


class RCUtilsError(RuntimeError):
    """An error of rcutils: logging and strings."""


class RMWError(RuntimeError):
    """An error of the middleware."""


class RCLError(RuntimeError):
    """An error of the ROS client library."""


class RCLInvalidROSArgsError(RCLError):
    """Invalid arguments after --ros-args."""


class UnknownROSArgsError(RuntimeError):
    """Unknown arguments after --ros-args."""


class NodeNameNonExistentError(RCLError):
    """The node does not exist."""


class UnsupportedEventTypeError(RCLError):
    """An event that the middleware does not support."""


class TimerCancelledError(RCLError):
    """A call of a canceled timer."""


class NotImplementedError(builtins.NotImplementedError):
    """A feature that this middleware does not support."""


class InvalidHandle(RuntimeError):
    """Use of a destroyed object."""


def unsupported(what: str) -> Never:
    """Report an unsupported feature.

    Raises:
        NotImplementedError: always.
    """
    raise NotImplementedError(f"{what} is not supported in the browser")
