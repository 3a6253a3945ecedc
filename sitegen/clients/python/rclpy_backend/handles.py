"""Handles of rclpy: objects with a count of users, contexts and guard conditions."""

from __future__ import annotations

import itertools
import os
from collections.abc import Sequence
from typing import Self

import ros_host

from rclpy_backend.arguments import Arguments, parse
from rclpy_backend.enums import RCL_DEFAULT_DOMAIN_ID
from rclpy_backend.errors import InvalidHandle, RCLError

_addresses = itertools.count(16, 16)


class Destroyable:
    """A handle that is destroyed on request, once it has no users.

    Raises:
        InvalidHandle: if it is used after destruction was requested.
    """

    def __init__(self) -> None:
        self._users = 0
        self._unwanted = False
        # A unique number in place of a memory address.
        self.pointer = next(_addresses)

    def __enter__(self) -> Self:
        if self._unwanted:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        self._users += 1
        return self

    def __exit__(self, *_: object) -> None:
        self._users -= 1
        if self._unwanted and not self._users:
            self._destroy()

    def destroy_when_not_in_use(self) -> None:
        """Destroy the handle now, or when its last user has finished."""
        if self._unwanted:
            return
        self._unwanted = True
        if not self._users:
            self._destroy()

    def _destroy(self) -> None:
        """Release the resources of the handle."""


living_contexts: list[Context] = []


class Context(Destroyable):
    """A context: ROS from initialization to shutdown, with its arguments."""

    def __init__(self, pyargs: Sequence[str] | None, domain_id: int) -> None:
        super().__init__()
        if domain_id == RCL_DEFAULT_DOMAIN_ID:
            domain_id = int(os.environ.get("ROS_DOMAIN_ID") or 0)
        self._domain_id = domain_id
        self.arguments: Arguments = parse(pyargs or ())
        self._shut_down = False
        living_contexts.append(self)

    def get_domain_id(self) -> int:
        """Return the domain ID; in the browser, all domains share one graph.

        Raises:
            RCLError: if the context has been shut down.
        """
        if not self.ok():
            raise RCLError("Failed to get domain id: error not set")
        return self._domain_id

    def ok(self) -> bool:
        """Return whether the context has not been shut down."""
        return self in living_contexts

    def check(self, doing: str, whose: str = "rcl node") -> None:
        """Check that the context is valid for `doing` something with an object of it.

        Raises:
            RCLError: if the context has been shut down.
        """
        if not self.ok():
            raise RCLError(f"{doing}: {whose}'s context is invalid")

    def check_for_new(self, part: str) -> None:
        """Check that the context is valid for creating a `part`.

        Raises:
            RCLError: if the context has been shut down.
        """
        if not self.ok():
            why = "either rcl_init() was not called or rcl_shutdown() was called."
            raise RCLError(f"failed to create {part}: the given context is not valid, {why}")

    def invalidate(self) -> None:
        """Make the context invalid, as a signal does."""
        if self in living_contexts:
            living_contexts.remove(self)
            ros_host.wake()

    def shutdown(self) -> None:
        """Shut down the context; allowed after invalidate().

        Raises:
            RuntimeError: if shutdown() has been called before.
        """
        if self._shut_down:
            raise RuntimeError("Context already shutdown.")
        self._shut_down = True
        self.invalidate()


class GuardCondition(Destroyable):
    """A condition that the program triggers to end a wait."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        context.check_for_new("guard_condition")
        self._triggered = False

    def trigger_guard_condition(self) -> None:
        """Trigger the condition: end the current wait for it, or the next one."""
        self._triggered = True
        ros_host.wake()

    def is_ready(self) -> bool:
        """Return whether the condition has been triggered."""
        return self._triggered

    def taken(self) -> None:
        """Reset the condition."""
        self._triggered = False
