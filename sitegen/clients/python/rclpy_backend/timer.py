"""Timers."""

from __future__ import annotations

from rclpy_backend.clock import Clock
from rclpy_backend.errors import TimerCancelledError
from rclpy_backend.handles import Context, Destroyable
from rclpy_backend.system import blocking


class Timer(Destroyable):
    """A timer that is ready every `period_nsec` nanoseconds of its clock."""

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
        self._left = 0
        clock.timers.add(self)

    def is_timer_ready(self) -> bool:
        """Return whether the timer is due."""
        return not self._canceled and self.clock.now() >= self._next

    def is_ready(self) -> bool:
        """Return whether the timer is due, for a wait set."""
        return self.is_timer_ready()

    def call_timer(self) -> None:
        """Start the next period.

        Raises:
            TimerCancelledError: if the timer is canceled.
        """
        self.call_timer_with_info()

    def call_timer_with_info(self) -> dict[str, int]:
        """Start the next period; return the expected and the actual time of this call.

        Raises:
            TimerCancelledError: if the timer is canceled.
        """
        if self._canceled:
            raise TimerCancelledError("Failed to call timer: timer is canceled")
        now, expected = self.clock.now(), self._next
        self._last = now
        self._next += self._period
        if self._next <= now:
            # Skip missed calls, and keep the phase.
            late = now - self._next
            self._next += (late // self._period + 1) * self._period if self._period else late
        return {"expected_call_time": expected, "actual_call_time": now}

    def reset_timer(self) -> None:
        """Start a new period now."""
        self._canceled = False
        self._next = self.clock.now() + self._period
        blocking.wake()

    def change_timer_period(self, period_nsec: int) -> None:
        """Change the period, from the next call on."""
        self._period = period_nsec

    def get_timer_period(self) -> int:
        """Return the period in nanoseconds."""
        return self._period

    def time_until_next_call(self) -> int | None:
        """Return the time until the next call (ns), negative if late; None if canceled."""
        return None if self._canceled else self._next - self.clock.now()

    def time_since_last_call(self) -> int:
        """Return the time since the last call (ns)."""
        return self.clock.now() - self._last

    def cancel_timer(self) -> None:
        """Cancel the timer."""
        self._canceled = True

    def is_timer_canceled(self) -> bool:
        """Return whether the timer is canceled."""
        return self._canceled

    def save_left(self) -> None:
        """Keep what is left of the period before the source of the clock changes."""
        # A clock without a message from /clock is at 0, and says nothing about the period.
        if now := self.clock.now():
            self._left = self._next - now

    def follow_jump(self, source_changed: bool) -> None:
        """Adapt the times of the calls to a clock that has jumped."""
        now = self.clock.now()
        if not source_changed:
            if now < self._last and now < self._next:
                self._last, self._next = now, now + self._period
        elif now and self._left:
            # As rcl does, which adds what was left to the last call instead of to now.
            self._last = now - self._left
            self._next, self._left = self._last + self._period, 0

    def _destroy(self) -> None:
        self.clock.timers.discard(self)
