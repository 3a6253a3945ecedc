"""Stop a robot whose driver has left."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sitegen.gateway.native import Native, Publisher

TYPES = ("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped")


class Stopping:
    """Has a publisher for each topic that somebody drives on, so that it is known in time."""

    def __init__(
        self, native: Native, topics: tuple[str, ...], write: Callable[[str], None]
    ) -> None:
        self._native = native
        self._party = native.join("stopping")
        self._topics = topics
        self._write = write
        self._publishers: dict[str, Publisher] = {}
        self._zero: dict[str, bytes] = {}

    async def prepare(self, topic: str, type_name: str) -> None:
        """Be ready to stop what moves on `topic`, if it is one that is to be stopped."""
        from sitegen.gateway.native import NativeError, Qos, load_type, to_cdr

        if topic not in self._topics or topic in self._zero:
            return
        if type_name not in TYPES:
            self._write(f"{topic} has the type {type_name}, which cannot be stopped")
            self._zero[topic] = b""
            return
        self._zero[topic] = to_cdr(load_type(type_name)())
        try:
            self._publishers[topic] = await self._party.advertise(topic, type_name, Qos())
        except NativeError as error:
            self._write(f"{topic} cannot be stopped: {error}")

    async def stop(self, topic: str) -> bool:
        """Publish a zero on a topic; return whether that was possible."""
        publisher = self._publishers.get(topic)
        if publisher is None:
            return False
        await publisher.settle()
        await publisher.publish(self._zero[topic])
        return True
