"""What rclpy holds on to: things that live until nobody uses them, contexts, guard conditions."""

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
    """Is destroyed as soon as that was asked for and nobody uses it."""

    def __init__(self) -> None:
        self._users = 0
        self._unwanted = False
        # In place of an address: a number that no other has.
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
        """Destroy it now, or when its last user is done."""
        if self._unwanted:
            return
        self._unwanted = True
        if not self._users:
            self._destroy()

    def _destroy(self) -> None:
        """Take it out of the graph."""


living_contexts: list[Context] = []


class Context(Destroyable):
    """One start of ROS, with its arguments."""

    def __init__(self, pyargs: Sequence[str] | None, domain_id: int) -> None:
        super().__init__()
        if domain_id == RCL_DEFAULT_DOMAIN_ID:
            domain_id = int(os.environ.get("ROS_DOMAIN_ID") or 0)
        self._domain_id = domain_id
        self.arguments: Arguments = parse(pyargs or ())
        self._shut_down = False
        living_contexts.append(self)

    def get_domain_id(self) -> int:
        """Return its domain; a page has one graph for all."""
        if not self.ok():
            raise RCLError("Failed to get domain id: error not set")
        return self._domain_id

    def ok(self) -> bool:
        """Return whether it was not shut down."""
        return self in living_contexts

    def check(self, doing: str, whose: str = "rcl node") -> None:
        """Raise the RCLError of `doing` something with what belongs to it, if it has ended."""
        if not self.ok():
            raise RCLError(f"{doing}: {whose}'s context is invalid")

    def check_for_new(self, part: str) -> None:
        """Raise the RCLError of making such a part, if it has ended."""
        if not self.ok():
            why = "either rcl_init() was not called or rcl_shutdown() was called."
            raise RCLError(f"failed to create {part}: the given context is not valid, {why}")

    def invalidate(self) -> None:
        """End it, if it has not ended."""
        if self in living_contexts:
            living_contexts.remove(self)
            ros_host.wake()

    def shutdown(self) -> None:
        """End it; raises a RuntimeError the second time. That a signal ended it does not count."""
        if self._shut_down:
            raise RuntimeError("Context already shutdown.")
        self._shut_down = True
        self.invalidate()


class GuardCondition(Destroyable):
    """Ends a wait from within the program."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        context.check_for_new("guard_condition")
        self._triggered = False

    def trigger_guard_condition(self) -> None:
        """End the wait of whoever waits for it, or the next."""
        self._triggered = True
        ros_host.wake()

    def is_ready(self) -> bool:
        """Return whether it was triggered since the last time."""
        return self._triggered

    def taken(self) -> None:
        """Wait for it again."""
        self._triggered = False
