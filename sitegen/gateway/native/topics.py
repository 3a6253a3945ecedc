"""Publishers and subscriptions of serialized messages."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy.duration import Duration

from sitegen.gateway.native.endpoint import Qos, Sample
from sitegen.gateway.native.part import Part, ignore
from sitegen.gateway.native.types import from_cdr, load_type, to_profile

if TYPE_CHECKING:
    from sitegen.gateway.native.native import Native
    from sitegen.gateway.native.party import Party

# A new publisher waits for the first subscription for so long (s).
_PATIENCE = 1.0
# One that goes waits for so long until what it sent has arrived (s).
_ACKNOWLEDGED = 0.2
Received = Callable[[Sample], None]


class Subscription(Part):
    """A subscription; `close` ends it."""

    kind = "subscription"

    def __init__(
        self,
        party: Party,
        name: str,
        type_name: str,
        qos: Qos,
        received: Received,
        node: str | None,
        shared: Shared | None = None,
    ) -> None:
        super().__init__(party, name, type_name, qos, node)
        self.received = received
        self._shared = shared
        self._since = time.time_ns()

    async def close(self) -> None:
        """End it."""
        self.received = ignore
        if self._shared is None:
            await super().close()
        else:
            self._party.forget(self)
            await self._shared.leave(self)

    @property
    def shared(self) -> bool:
        """Whether others had the same subscription before."""
        return self._shared is not None and self._shared.members > 1

    async def matched(self) -> bool:
        """Return whether any publisher matches; True where rclpy does not tell."""
        entity = self._shared.entity if self._shared else self._entity
        count = getattr(entity, "get_publisher_count", None)
        return count is None or await self._native.spin.do(count) > 0

    def take(self) -> Callable[[], None] | None:
        """Take a message, in the thread of ROS."""
        taken = self.handle.take_message(None, True)
        if taken is None:
            return None
        data, info = taken
        gid = bytes((info["publisher_gid"] or {"data": b""})["data"])
        sample = Sample(
            data,
            gid,
            self._native.graph.owner(gid),
            info["publication_sequence_number"],
            info["source_timestamp"],
            self._qos.transient_local and info["source_timestamp"] < self._since,
        )
        return lambda: self.received(sample)

    def _create(self, node: Any, kind: Any) -> Any:
        self._since = time.time_ns()
        name, profile = self.endpoint.name, to_profile(self._qos)
        entity = node.create_subscription(kind, name, ignore, profile, raw=True)
        self.handle = entity.handle
        self._native.spin.add(self)
        return entity


class Shared:
    """A subscription of the gateway itself, for several parties."""

    def __init__(self, native: Native, key: tuple[str, str, Qos]) -> None:
        self._native = native
        self._key = key
        self._members: list[Subscription] = []
        self._source: Subscription | None = None
        self._lock = asyncio.Lock()

    @property
    def members(self) -> int:
        """The number of those who listen."""
        return len(self._members)

    @property
    def entity(self) -> Any:
        """The subscription of rclpy, None if there is none."""
        return self._source._entity if self._source else None

    async def join(self, member: Subscription) -> None:
        """Deliver messages to one more."""
        self._members.append(member)
        self._native.notify()
        async with self._lock:
            if self._source is not None:
                return
            topic, type_name, qos = self._key
            # It belongs to nobody, so nobody is told of it.
            source = Subscription(
                self._native.join(None), topic, type_name, qos, self._deliver, None
            )
            try:
                await self._native.spin.do(lambda: source.make(load_type(type_name)))
            except Exception:
                self._members.remove(member)
                self._forget()
                raise
            self._source = source

    async def leave(self, member: Subscription) -> None:
        """Deliver no more to a member, and end the subscription with the last."""
        if member in self._members:
            self._members.remove(member)
            self._native.notify()
        async with self._lock:
            if not self._members and self._source:
                source, self._source = self._source, None
                await source.close()
            self._forget()

    def owners(self) -> set[str | None]:
        """Return the parties that get its messages."""
        return {member.endpoint.owner for member in self._members}

    def _forget(self) -> None:
        if not self._members and self._native.shared.get(self._key) is self:
            del self._native.shared[self._key]

    def _deliver(self, sample: Sample) -> None:
        for member in list(self._members):
            member.received(sample)


class Publisher(Part):
    """A publisher."""

    kind = "publisher"
    _message: Any = None
    _made = 0.0

    def publish(self, data: bytes) -> asyncio.Future[None]:
        """Publish a message; the future is done when the middleware has it.

        Raises:
            MalformedMessageError: `data` are no message of this type; nothing is published then
        """
        return self._native.spin.do(lambda: self._publish(data))

    def destroy(self) -> None:
        """Destroy it, in the thread of ROS, when reliable subscriptions have what it sent."""
        if self._entity is not None and self._qos.reliable:
            self._entity.wait_for_all_acked(Duration(seconds=_ACKNOWLEDGED))
        super().destroy()

    async def settle(self) -> None:
        """Wait until a subscription matches a new publisher, but not for long.

        What is published before reaches nobody.
        """
        limit = self._made + _PATIENCE
        while time.monotonic() < limit and await self._native.spin.do(self._count) == 0:
            await asyncio.sleep(0.02)

    def _count(self) -> int:
        return int(self._entity.get_subscription_count()) if self._entity else 0

    def _publish(self, data: bytes) -> None:
        if self._entity is None:
            return
        # Bytes that are no message would end native programs that take them.
        from_cdr(data, self._message)
        self._entity.publish(data)

    def _create(self, node: Any, kind: Any) -> Any:
        self._message = kind
        self._made = time.monotonic()
        return node.create_publisher(kind, self.endpoint.name, to_profile(self._qos))
