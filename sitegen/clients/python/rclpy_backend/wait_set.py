"""The wait set: what an executor waits for."""

from __future__ import annotations

import time
from typing import Any, Protocol

import ros_host

from rclpy_backend.endpoint import Endpoint
from rclpy_backend.events import EventHandle
from rclpy_backend.handles import Context, Destroyable, GuardCondition
from rclpy_backend.service import Client, Service
from rclpy_backend.subscription import Subscription
from rclpy_backend.system import blocking
from rclpy_backend.timer import Timer

ENDPOINTS = ("subscription", "service", "client")
KINDS = (*ENDPOINTS, "guard_condition", "timer", "event", "part")


class Waitable(Protocol):
    """Something that becomes ready."""

    pointer: int

    def is_ready(self) -> bool:
        """Return whether a wait for it is over."""


class WaitSet(Destroyable):
    """Waits until one of many is ready; what was found is kept until the next wait."""

    def __init__(
        self,
        number_of_subscriptions: int,
        number_of_guard_conditions: int,
        number_of_timers: int,
        number_of_clients: int,
        number_of_services: int,
        number_of_events: int,
        context: Context,
    ) -> None:
        super().__init__()
        self._context = context
        self.clear_entities()

    def clear_entities(self) -> None:
        """Wait for nothing."""
        # By what they are, as rclpy names it; "part" is what belongs to something larger.
        self._entities: dict[str, list[Any]] = {kind: [] for kind in KINDS}
        self._ready: set[int] = set()

    def add(self, entity: Waitable) -> None:
        """Wait for a part of something larger."""
        self._entities["timer" if isinstance(entity, Timer) else "part"].append(entity)

    # These are called for everything that a node has, for each message: so they call nothing else.
    def add_service(self, service: Service) -> int:
        """Wait for requests; returns the index among the services."""
        entities = self._entities["service"]
        entities.append(service)
        return len(entities) - 1

    def add_subscription(self, subscription: Subscription) -> int:
        """Wait for messages; returns the index among the subscriptions."""
        entities = self._entities["subscription"]
        entities.append(subscription)
        return len(entities) - 1

    def add_client(self, client: Client) -> int:
        """Wait for responses; returns the index among the clients."""
        entities = self._entities["client"]
        entities.append(client)
        return len(entities) - 1

    def add_guard_condition(self, guard_condition: GuardCondition) -> int:
        """Wait for a trigger; returns the index among the guard conditions."""
        entities = self._entities["guard_condition"]
        entities.append(guard_condition)
        return len(entities) - 1

    def add_timer(self, timer: Timer) -> int:
        """Wait for a time; returns the index among the timers."""
        entities = self._entities["timer"]
        entities.append(timer)
        return len(entities) - 1

    def add_event(self, event: EventHandle) -> int:
        """Wait for an event; returns the index among the events."""
        entities = self._entities["event"]
        entities.append(event)
        return len(entities) - 1

    def is_ready(self, entity_type: str, index: int) -> bool:
        """Return whether the last wait found that one ready."""
        return self._entities[entity_type][index].pointer in self._ready

    def found(self, entity: Waitable) -> bool:
        """Return whether the last wait found `entity` ready."""
        return entity.pointer in self._ready

    def get_ready_entities(self, entity_type: str) -> list[int]:
        """Return the pointers of those that the last wait found ready."""
        return [e.pointer for e in self._entities[entity_type] if e.pointer in self._ready]

    def wait(self, timeout: int) -> None:
        """Wait for at most so many nanoseconds, without a limit if it is below 0."""
        end = None if timeout < 0 else time.monotonic() + timeout / 1e9
        blocking.breathe()
        while not (ready := self._find_ready()) and self._context.ok():
            left = None if end is None else end - time.monotonic()
            if left is not None and left <= 0:
                if timeout == 0:
                    blocking.wait(0)
                    ready = self._find_ready()
                break
            blocking.wait(self._until_next_timer(left))
        self._ready = {entity.pointer for entity in ready}
        for entity in ready:
            if isinstance(entity, GuardCondition):
                entity.taken()

    def _find_ready(self) -> list[Waitable]:
        # The page is asked once, and not for each: that takes as long as all else here.
        events, *ids = map(int, ros_host.filled().split())
        filled = set(ids)
        ready: list[Waitable] = []
        entities = self._entities
        for kind in ENDPOINTS:
            ready += [one for one in entities[kind] if one.id in filled]
        for part in entities["part"]:
            if part.id in filled if isinstance(part, Endpoint) else part.is_ready():
                ready.append(part)
        ready += [event for event in entities["event"] if event.is_ready(events)]
        for kind in ("timer", "guard_condition"):
            ready += [one for one in entities[kind] if one.is_ready()]
        return ready

    def _until_next_timer(self, limit: float | None) -> float | None:
        """Return how long nothing will be ready by itself (s)."""
        times = [] if limit is None else [limit]
        for timer in self._entities["timer"]:
            if isinstance(timer, Timer) and not timer.clock.simulated:
                until = timer.time_until_next_call()
                times += [] if until is None else [max(until, 0) / 1e9]
        return min(times, default=None)
