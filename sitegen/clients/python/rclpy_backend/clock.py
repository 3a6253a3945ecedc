"""Clocks, and waiting for a time."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import ros_host

from rclpy_backend.enums import ClockChange, ClockType
from rclpy_backend.handles import Destroyable
from rclpy_backend.system import blocking

if TYPE_CHECKING:
    from rclpy.clock import JumpHandle

MILLISECOND = 1_000_000


def system_time() -> int:
    """Return nanoseconds since 1970, by the clock that stamps the messages of the page."""
    return nanoseconds(ros_host.now())


def nanoseconds(milliseconds: float) -> int:
    """Return a time of the page, which has milliseconds, in nanoseconds."""
    whole = int(milliseconds)
    # The product as one float would be a quarter of a microsecond off.
    return whole * MILLISECOND + round((milliseconds - whole) * MILLISECOND)


class rcl_time_point_t:
    """A time of a clock."""

    def __init__(self, nanoseconds: int, clock_type: int) -> None:
        self.nanoseconds = nanoseconds
        self.clock_type = ClockType(clock_type)


class rcl_duration_t:
    """A length of time."""

    def __init__(self, nanoseconds: int) -> None:
        self.nanoseconds = nanoseconds


class Clock(Destroyable):
    """A clock; one of ROS time shows the time that a simulation gives, while it gives one."""

    def __init__(self, clock_type: int) -> None:
        super().__init__()
        self._type = ClockType(clock_type)
        self.simulated = False
        self._time = 0
        self._handles: list[tuple[JumpHandle, bool, int, int]] = []

    def now(self) -> int:
        """Return its time in nanoseconds."""
        if self._type == ClockType.STEADY_TIME:
            return time.monotonic_ns()
        return self._time if self.simulated else system_time()

    def get_now(self) -> rcl_time_point_t:
        """Return its time."""
        return rcl_time_point_t(self.now(), self._type)

    def get_ros_time_override_is_enabled(self) -> bool:
        """Return whether it shows the time of a simulation."""
        return self.simulated

    def set_ros_time_override_is_enabled(self, enabled: bool) -> None:
        """Show the time of a simulation, or no longer."""
        if enabled != self.simulated:
            begins = ClockChange.ROS_TIME_ACTIVATED
            change = begins if enabled else ClockChange.ROS_TIME_DEACTIVATED
            self._jump(change, 0, lambda: setattr(self, "simulated", enabled))

    def set_ros_time_override(self, time_point: rcl_time_point_t) -> None:
        """Take the time of a simulation."""

        def take() -> None:
            self._time = time_point.nanoseconds

        if self.simulated:
            delta = time_point.nanoseconds - self._time
            self._jump(ClockChange.ROS_TIME_NO_CHANGE, delta, take)
        else:
            take()

    def add_clock_callback(
        self, pyjump_handle: JumpHandle, on_clock_change: bool, min_forward: int, min_backward: int
    ) -> None:
        """Tell `pyjump_handle` of jumps that are at least so far."""
        self._handles.append((pyjump_handle, on_clock_change, min_forward, min_backward))

    def remove_clock_callback(self, pyjump_handle: JumpHandle) -> None:
        """Tell it no more."""
        self._handles = [entry for entry in self._handles if entry[0] is not pyjump_handle]

    def _jump(self, change: ClockChange, delta: int, make: Callable[[], None]) -> None:
        # What its handles call, rclpy keeps to itself.
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
        make()
        for handle in told:
            if handle._post_callback:
                handle._post_callback({"clock_change": change, "delta": delta})
        blocking.wake()


class ClockEvent:
    """Something to wait for, at most until a time of a clock."""

    def __init__(self) -> None:
        self._set = False

    def _wait(self, clock: Clock, until: rcl_time_point_t) -> None:
        while not self._set:
            left = until.nanoseconds - clock.now()
            if left <= 0:
                return
            blocking.wait(None if clock.simulated else left / 1e9)

    def wait_until_steady(self, clock: Clock, until: rcl_time_point_t) -> None:
        """Wait by a clock that nobody sets."""
        self._wait(clock, until)

    def wait_until_system(self, clock: Clock, until: rcl_time_point_t) -> None:
        """Wait by the clock of the system."""
        self._wait(clock, until)

    def wait_until_ros(self, clock: Clock, until: rcl_time_point_t) -> None:
        """Wait by the clock of ROS."""
        self._wait(clock, until)

    def is_set(self) -> bool:
        """Return whether it has happened."""
        return self._set

    def set(self) -> None:
        """It has happened."""
        self._set = True
        blocking.wake()

    def clear(self) -> None:
        """It has to happen again."""
        self._set = False
