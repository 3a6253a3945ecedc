"""The common part of filters: callbacks for the messages that pass."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.clock import ROSClock
from rclpy.logging import get_logger
from rclpy.time import Time


class SimpleFilter:
    """A filter with any number of callbacks."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., object], tuple[Any, ...]]] = {}

    def registerCallback(self, cb: Callable[..., object], *args: Any) -> int:
        """Call `cb` with each message, followed by `args`; return the callback's number."""
        number = max(self.callbacks, default=-1) + 1
        self.callbacks[number] = (cb, args)
        return number

    def signalMessage(self, *msg: Any) -> None:
        """Pass messages on to the callbacks."""
        for callback, args in list(self.callbacks.values()):
            callback(*msg, *args)


def stamp_of(msg: Any, allow_headerless: bool, filter_name: str) -> Time | None:
    """Return the timestamp of a message; without a header, the current time or None."""
    stamp = getattr(getattr(msg, "header", None), "stamp", None)
    if stamp is not None:
        return Time.from_msg(stamp)
    if allow_headerless:
        return ROSClock().now()
    get_logger(f"message_filters_{filter_name}").warning(
        "can not use message filters for messages without timestamp infomation when "
        "'allow_headerless' is disabled. auto assign ROSTIME to headerless messages once enabling "
        "constructor option of 'allow_headerless'."
    )
    return None
