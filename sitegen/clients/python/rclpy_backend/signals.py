"""Signals: Stop sends SIGINT, which rclpy handles before Python."""

from __future__ import annotations

import signal
from typing import TYPE_CHECKING

import ros_host

from rclpy_backend.enums import SignalHandlerOptions
from rclpy_backend.handles import GuardCondition, living_contexts

if TYPE_CHECKING:
    from rclpy_backend.handles import Context

_options = SignalHandlerOptions.NO
_guards: list[GuardCondition] = []
# The signal that is pending, 0 if none.
_pending = 0
# The last signal, by which program.run() determines why the program ended.
received = 0


def arrive(number: int) -> None:
    """Receive a signal from the page; the main thread of the program will handle it."""
    global _pending, received
    _pending = received = number
    if _options & SignalHandlerOptions.SIGINT:
        contexts: list[Context] = list(living_contexts)
        for context in contexts:
            context.invalidate()
        for guard in _guards:
            guard.trigger_guard_condition()
    ros_host.wake()


def handle(*, main: bool) -> None:
    """Call the handler of a pending signal, as Python does between two instructions."""
    global _pending
    if _pending and main:
        number, _pending = _pending, 0
        handler = signal.getsignal(number)
        if callable(handler):
            handler(number, None)


def register_sigint_guard_condition(guard_condition: GuardCondition) -> None:
    """Trigger a guard condition on each SIGINT."""
    _guards.append(guard_condition)


def unregister_sigint_guard_condition(guard_condition: GuardCondition) -> None:
    """Stop triggering a guard condition.

    Raises:
        ValueError: if it is not registered.
    """
    if guard_condition not in _guards:
        raise ValueError("Guard condition was not registered")
    _guards.remove(guard_condition)


def install_signal_handlers(options: SignalHandlerOptions) -> None:
    """Install rclpy's signal handlers, which end waits."""
    global _options
    _options = SignalHandlerOptions(options)


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    """Return which handlers are installed."""
    return _options


def uninstall_signal_handlers() -> None:
    """Uninstall rclpy's signal handlers."""
    global _options
    _options = SignalHandlerOptions.NO
