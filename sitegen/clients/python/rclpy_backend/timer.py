"""Timers."""

from __future__ import annotations

from rclpy_backend.clock import Clock
from rclpy_backend.errors import TimerCancelledError
from rclpy_backend.handles import Context, Destroyable
from rclpy_backend.system import blocking


class Timer(Destroyable):
    """Is ready each `period_nsec` of its clock."""

    def __init__(
        self, clock: Clock, context: Context, period_nsec: int, autostart: bool = True
    ) -> None:
        super().__init__()
        context.check_for_new("timer")
        self.clock = clock
        self._period = int(period_nsec)
        self._canceled = not autostart
        self._last = clock.now()
        self._next = self._last + self._period

    def is_timer_ready(self) -> bool:
        """Return whether its time has come."""
        return not self._canceled and self.clock.now() >= self._next

    def is_ready(self) -> bool:
        """Return whether a wait for it is over."""
        return self.is_timer_ready()

    def call_timer(self) -> None:
        """Note that it is being called."""
        self.call_timer_with_info()

    def call_timer_with_info(self) -> dict[str, int]:
        """Note that it is being called; return when it should be and when it is."""
        if self._canceled:
            raise TimerCancelledError("Failed to call timer: timer is canceled")
        now, expected = self.clock.now(), self._next
        self._last = now
        self._next += self._period
        if self._next < now:
            # Calls that are over are left out, the rhythm stays.
            missed = (now - self._next) // self._period + 1 if self._period else 0
            self._next = self._next + missed * self._period if self._period else now
        return {"expected_call_time": expected, "actual_call_time": now}

    def reset_timer(self) -> None:
        """Begin a period now."""
        self._canceled = False
        self._next = self.clock.now() + self._period
        blocking.wake()

    def change_timer_period(self, period_nsec: int) -> None:
        """Take another period from the next call on."""
        self._period = period_nsec

    def get_timer_period(self) -> int:
        """Return the period in nanoseconds."""
        return self._period

    def time_until_next_call(self) -> int | None:
        """Return nanoseconds, below 0 if it is late; None if it was cancelled."""
        return None if self._canceled else self._next - self.clock.now()

    def time_since_last_call(self) -> int:
        """Return nanoseconds."""
        return self.clock.now() - self._last

    def cancel_timer(self) -> None:
        """Be ready no more."""
        self._canceled = True

    def is_timer_canceled(self) -> bool:
        """Return whether it was cancelled."""
        return self._canceled
