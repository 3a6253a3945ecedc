"""Keep the last messages and pass all of them on."""

from __future__ import annotations

from typing import Any

from rclpy.time import Time

from message_filters.simple_filter import SimpleFilter, stamp_of


class Cache(SimpleFilter):
    """A cache of `cache_size` messages; those without a header have their time of arrival."""

    def __init__(self, f: Any = None, cache_size: int = 1, allow_headerless: bool = False) -> None:
        super().__init__()
        self.cache_size = cache_size
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Time] = []
        self.allow_headerless = allow_headerless
        if f is not None:
            self.connectInput(f)

    def connectInput(self, f: Any) -> None:
        """Connect the input to another filter."""
        self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Add a message."""
        stamp = stamp_of(msg, self.allow_headerless, "cache")
        if stamp is None:
            return
        self.cache_times.append(stamp)
        self.cache_msgs.append(msg)
        if len(self.cache_msgs) > self.cache_size:
            del self.cache_msgs[0], self.cache_times[0]
        self.signalMessage(msg)

    def getInterval(self, from_stamp: Time, to_stamp: Time) -> list[Any]:
        """Return the messages from one time to another, both included."""
        return [msg for msg, time in self._kept() if from_stamp <= time <= to_stamp]

    def getElemAfterTime(self, stamp: Time) -> Any:
        """Return the first message at a time or after it, or None."""
        return next((msg for msg, time in self._kept() if time >= stamp), None)

    def getElemBeforeTime(self, stamp: Time) -> Any:
        """Return the last message at a time or before it, or None."""
        return next((msg for msg, time in reversed(self._kept()) if time <= stamp), None)

    def getLatestTime(self) -> Time | None:
        """Return the time of the last message."""
        return self.cache_times[-1] if self.cache_times else None

    # The spelling of upstream.
    getLastestTime = getLatestTime

    def getOldestTime(self) -> Time | None:
        """Return the time of the first message."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        """Return the last message, or None."""
        return self.cache_msgs[-1] if self.cache_msgs else None

    def _kept(self) -> list[tuple[Any, Time]]:
        return list(zip(self.cache_msgs, self.cache_times, strict=True))
