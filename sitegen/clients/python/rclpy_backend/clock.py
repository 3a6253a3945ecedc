"""Clocks, and waits for a time."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any
from weakref import WeakSet

import ros_host

from rclpy_backend.enums import ClockChange, ClockType
from rclpy_backend.handles import Destroyable
from rclpy_backend.system import blocking

if TYPE_CHECKING:
    from rclpy.clock import JumpHandle

    from rclpy_backend.timer import Timer

MILLISECOND = 1_000_000


def system_time() -> int:
    """Return nanoseconds since 1970, by the clock that timestamps the page's messages."""
    return nanoseconds(ros_host.now())


def nanoseconds(milliseconds: float) -> int:
    """Convert a time of the page to nanoseconds."""
    whole = int(milliseconds)
    # A single float product would be inexact by a quarter of a microsecond.
    return whole * MILLISECOND + round((milliseconds - whole) * MILLISECOND)


class rcl_time_point_t:
    """A point in time of a clock."""

    def __init__(self, nanoseconds: int, clock_type: int) -> None:
        self.nanoseconds = nanoseconds
        self.clock_type = ClockType(clock_type)


class rcl_duration_t:
    """A duration."""

    def __init__(self, nanoseconds: int) -> None:
        self.nanoseconds = nanoseconds


class Clock(Destroyable):
    """A clock; one of ROS time can show simulated time."""

    def __init__(self, clock_type: int) -> None:
        super().__init__()
        self._type = ClockType(clock_type)
        self.simulated = False
        self._time = 0
        self._handles: list[tuple[JumpHandle, bool, int, int]] = []
        self.timers: WeakSet[Timer] = WeakSet()

    def now(self) -> int:
        """Return the time in nanoseconds."""
        if self._type == ClockType.STEADY_TIME:
            return time.monotonic_ns()
        return self._time if self.simulated else system_time()

    def get_now(self) -> rcl_time_point_t:
        """Return the time."""
        return rcl_time_point_t(self.now(), self._type)

    def get_ros_time_override_is_enabled(self) -> bool:
        """Return whether the clock shows simulated time."""
        return self.simulated

    def set_ros_time_override_is_enabled(self, enabled: bool) -> None:
        """Set whether the clock shows simulated time."""
        if enabled != self.simulated:
            begins = ClockChange.ROS_TIME_ACTIVATED
            change = begins if enabled else ClockChange.ROS_TIME_DEACTIVATED
            self._jump(change, 0, lambda: setattr(self, "simulated", enabled))

    def set_ros_time_override(self, time_point: rcl_time_point_t) -> None:
        """Set the simulated time."""

        def take() -> None:
            self._time = time_point.nanoseconds

        delta = time_point.nanoseconds - self._time
        if self.simulated and delta:
            self._jump(ClockChange.ROS_TIME_NO_CHANGE, delta, take)
        else:
            take()

    def add_clock_callback(
        self, pyjump_handle: JumpHandle, on_clock_change: bool, min_forward: int, min_backward: int
    ) -> None:
        """Call `pyjump_handle` on time jumps over its thresholds."""
        self._handles.append((pyjump_handle, on_clock_change, min_forward, min_backward))

    def remove_clock_callback(self, pyjump_handle: JumpHandle) -> None:
        """Remove a jump callback."""
        self._handles = [entry for entry in self._handles if entry[0] is not pyjump_handle]

    def _jump(self, change: ClockChange, delta: int, make: Callable[[], None]) -> None:
        # The callbacks are private attributes in rclpy.
        handles: list[tuple[Any, bool, int, int]] = list(self._handles)
        changes = change != ClockChange.ROS_TIME_NO_CHANGE
        told = [
            handle
            for handle, on_change, forward, backward in handles
            if (on_change and changes)
            or (forward and delta >= forward)
            or (backward and delta <= backward)
        ]
        for handle in told:
            if handle._pre_callback:
                handle._pre_callback()
        timers = list(self.timers)
        for timer in timers if changes else ():
            timer.save_left()
        make()
        for timer in timers:
            timer.follow_jump(changes)
        for handle in told:
            if handle._post_callback:
                handle._post_callback({"clock_change": change, "delta": delta})
        blocking.wake()


class ClockEvent:
    """An event to wait for, up to a time of a clock."""

    def __init__(self) -> None:
        self._set = False

    def _wait(self, clock: Clock, until: rcl_time_point_t) -> None:
        while not self._set:
            left = until.nanoseconds - clock.now()
            if left <= 0:
                return
            blocking.wait(None if clock.simulated else left / 1e9)

    def wait_until_steady(self, clock: Clock, until: rcl_time_point_t) -> None:
        """Wait by a steady clock."""
        self._wait(clock, until)

    def wait_until_system(self, clock: Clock, until: rcl_time_point_t) -> None:
        """Wait by the system clock."""
        self._wait(clock, until)

    def wait_until_ros(self, clock: Clock, until: rcl_time_point_t) -> None:
        """Wait by a clock of ROS time."""
        self._wait(clock, until)

    def is_set(self) -> bool:
        """Return whether the event is set."""
        return self._set

    def set(self) -> None:
        """Set the event."""
        self._set = True
        blocking.wake()

    def clear(self) -> None:
        """Clear the event."""
        self._set = False
