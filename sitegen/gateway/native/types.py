"""Find the Python classes of interfaces, and convert their messages."""

from __future__ import annotations

import functools
import importlib
import math
import re
from pathlib import Path
from typing import Any

from ament_index_python import get_package_share_directory, get_resource, get_resources
from rclpy.duration import Duration, Infinite
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
)
from rclpy.serialization import deserialize_message, serialize_message

from sitegen.gateway.native.endpoint import MalformedMessageError, Qos, UnknownTypeError

_NAME = re.compile(r"([a-z][a-z0-9_]*)/(msg|srv|action)/([A-Za-z][A-Za-z0-9]*)(_[A-Za-z_]+)?")
# What belongs to an action, and where Python keeps it.
_OF_ACTIONS = {
    "_SendGoal": "SendGoalService",
    "_GetResult": "GetResultService",
    "_FeedbackMessage": "FeedbackMessage",
}
# What middlewares tell for "no limit" (s).
_FOREVER = 10**9


@functools.cache
def load_type(name: str) -> Any:
    """Return the class of an interface.

    That of "std_msgs/msg/String" is a message; that of "std_srvs/srv/SetBool" has `Request` and
    `Response`. The services and the feedback of an action are named as in the graph:
    "example_interfaces/action/Fibonacci_SendGoal".

    Raises:
        UnknownTypeError: it is not installed
    """
    match = _NAME.fullmatch(name)
    if not match:
        raise UnknownTypeError(f"'{name}' is not a valid type")
    package, kind, short, suffix = match.groups()
    if package not in _packages():
        # Nothing else of Python is to be imported because a client says so.
        raise UnknownTypeError(f"the type '{name}' is not installed beside the gateway")
    try:
        found = getattr(importlib.import_module(f"{package}.{kind}"), short)
        if suffix is None:
            return found
        if suffix in ("_Request", "_Response", "_Goal", "_Result", "_Feedback"):
            return getattr(found, suffix[1:])
        return getattr(found.Impl, _OF_ACTIONS[suffix])
    except (ImportError, AttributeError, KeyError):
        message = f"the type '{name}' is not installed beside the gateway"
        raise UnknownTypeError(message) from None


@functools.cache
def _packages() -> dict[str, str]:
    return dict(get_resources("rosidl_interfaces"))


@functools.cache
def installed() -> list[str]:
    """Return the names of all interfaces that are installed."""
    names = set()
    for package in _packages():
        content, _ = get_resource("rosidl_interfaces", package)
        for line in content.splitlines():
            stem, _, ending = line.rpartition(".")
            if ending == "idl":
                names.add(f"{package}/{stem}")
    return sorted(names)


@functools.cache
def definition(name: str) -> str:
    """Return the text of the .msg, .srv or .action file of an interface.

    Raises:
        UnknownTypeError: it is not installed, or was installed without it
    """
    package, kind, short = [*name.split("/"), "", ""][:3]
    try:
        share = Path(get_package_share_directory(package))
        return (share / kind / f"{short}.{kind}").read_text("utf-8")
    except (LookupError, OSError, ValueError):
        raise UnknownTypeError(f"no definition of '{name}' is installed") from None


def to_cdr(message: Any) -> bytes:
    """Return the bytes of a message."""
    data: bytes = serialize_message(message)
    return data


def from_cdr(data: bytes, kind: Any) -> Any:
    """Return the message of class `kind` that `data` are the bytes of.

    Raises:
        MalformedMessageError: they are not
    """
    try:
        return deserialize_message(data, kind)
    except Exception:
        # rclpy raises what its middleware raises, also MemoryError and UnicodeDecodeError.
        message = f"{len(data)} bytes are no {kind.__module__.split('.')[0]}/{kind.__name__}"
        raise MalformedMessageError(message) from None


def to_profile(qos: Qos) -> Any:
    """Return rclpy's profile."""
    return QoSProfile(
        history=HistoryPolicy.KEEP_ALL if qos.keep_all else HistoryPolicy.KEEP_LAST,
        depth=max(1, qos.depth),
        reliability=ReliabilityPolicy.RELIABLE if qos.reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL
        if qos.transient_local
        else DurabilityPolicy.VOLATILE,
        deadline=_duration(qos.deadline),
        lifespan=_duration(qos.lifespan),
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC if qos.manual else LivelinessPolicy.AUTOMATIC,
        liveliness_lease_duration=_duration(qos.lease),
    )


def from_profile(profile: Any) -> Qos:
    """Return the quality of service that the graph tells of an endpoint."""
    return Qos(
        depth=profile.depth or 10,
        reliable=profile.reliability == ReliabilityPolicy.RELIABLE,
        transient_local=profile.durability == DurabilityPolicy.TRANSIENT_LOCAL,
        keep_all=profile.history == HistoryPolicy.KEEP_ALL,
        deadline=_milliseconds(profile.deadline),
        lifespan=_milliseconds(profile.lifespan),
        manual=profile.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC,
        lease=_milliseconds(profile.liveliness_lease_duration),
    )


def _duration(milliseconds: float) -> Any:
    return Infinite if math.isinf(milliseconds) else Duration(nanoseconds=int(milliseconds * 1e6))


def _milliseconds(duration: Any) -> float:
    nanoseconds = duration.nanoseconds
    # Zero is how profiles spell "the default", which is none.
    if nanoseconds == 0 or nanoseconds >= _FOREVER * 10**9:
        return math.inf
    return float(nanoseconds / 1e6)
