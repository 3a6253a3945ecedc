"""What one client of the gateway, such as a page, does in the native graph."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from sitegen.gateway.native.endpoint import Endpoint, NativeError, Qos
from sitegen.gateway.native.part import Part
from sitegen.gateway.native.services import Client, Request, Server
from sitegen.gateway.native.topics import Publisher, Received, Shared, Subscription
from sitegen.gateway.native.types import load_type

if TYPE_CHECKING:
    from sitegen.gateway.native.native import Native

P = TypeVar("P", bound=Part)


class Party:
    """The nodes and endpoints of one owner; all of them go together."""

    def __init__(self, native: Native, owner: str | None) -> None:
        self.native = native
        self.owner = owner
        self._nodes: dict[str, tuple[Any, str]] = {}
        self._open: set[Part] = set()
        self._closed = False

    @property
    def nodes(self) -> list[str]:
        """The names of its native nodes, with their namespaces."""
        return list(self._nodes)

    async def add_node(self, full: str) -> None:
        """Make a native node, whose name begins with its namespace: "/robot/talker".

        Raises:
            NativeError: the name is not valid
        """
        if self._closed:
            raise NativeError("this party has left")
        await self.native.spin.do(lambda: self.native_node(full))

    async def remove_node(self, full: str) -> None:
        """Remove a node with its endpoints, if there is one of this name."""
        for item in [item for item in self._open if item.endpoint.node == full]:
            await item.close()
        await self.native.spin.do(lambda: self._drop(full))

    async def subscribe(
        self, topic: str, type_name: str, qos: Qos, received: Received, *, node: str | None = None
    ) -> Subscription:
        """Call `received` with each message of a topic.

        With `node`, the subscription is one of that node. Without, it is the gateway's, and shared
        by all parties that ask for the same; latched messages are for each party.

        Raises:
            UnknownTypeError: the type is not installed
            NativeError: a name is not valid
        """
        kind = load_type(type_name)
        if node is None and not qos.transient_local:
            return await self._share(topic, type_name, qos, received)
        subscription = Subscription(self, topic, type_name, qos, received, node)
        return await self._make(subscription, kind)

    async def advertise(
        self, topic: str, type_name: str, qos: Qos, *, node: str | None = None
    ) -> Publisher:
        """Return a publisher, of the gateway's node without `node`.

        Raises:
            UnknownTypeError: the type is not installed
            NativeError: a name is not valid
        """
        kind = load_type(type_name)
        publisher = Publisher(self, topic, type_name, qos, node)
        return await self._make(publisher, kind)

    async def client(self, service: str, type_name: str, *, node: str | None = None) -> Client:
        """Return a client of a service.

        Raises:
            UnknownTypeError: the type is not installed
            NativeError: a name is not valid
        """
        kind = load_type(type_name)
        client = Client(self, service, type_name, node)
        return await self._make(client, kind)

    async def serve(
        self,
        service: str,
        type_name: str,
        asked: Callable[[Request], None],
        *,
        node: str | None = None,
    ) -> Server:
        """Call `asked` with each request to a service, which it answers at any time.

        Raises:
            UnknownTypeError: the type is not installed
            NativeError: a name is not valid
        """
        kind = load_type(type_name)
        server = Server(self, service, type_name, asked, node)
        return await self._make(server, kind)

    async def close(self) -> None:
        """Remove all nodes and endpoints of this party."""
        self._closed = True
        for item in list(self._open):
            await item.close()
        await self.native.spin.do(self._drop_all)

    def forget(self, item: Part) -> None:
        """Take out an endpoint that is being closed."""
        self._open.discard(item)

    async def _share(
        self, topic: str, type_name: str, qos: Qos, received: Received
    ) -> Subscription:
        native = self.native
        key = (topic, type_name, qos)
        shared = native.shared.get(key)
        if shared is None:
            shared = native.shared[key] = Shared(native, key)
        member = Subscription(self, topic, type_name, qos, received, None, shared)
        self._keep(member)
        try:
            await shared.join(member)
        except Exception:
            self.forget(member)
            raise
        return member

    async def _make(self, item: P, kind: Any) -> P:
        # It is known before it is there, so that it also goes if whoever asked is canceled.
        self._keep(item)
        try:
            await self.native.spin.do(lambda: item.make(kind))
        except NativeError:
            self.forget(item)
            raise
        return item

    def _keep(self, item: Part) -> None:
        if self._closed:
            raise NativeError("this party has left")
        self._open.add(item)

    def native_node(self, full: str | None) -> Any:
        """Return a node, in the thread of ROS."""
        if full is None:
            return self.native.node
        if full not in self._nodes:
            node = self.native.make_node(full)
            key = self.native.key("node")
            self._nodes[full] = (node, key)
            empty = Endpoint(key, "node", full, full, "", "", Qos(), owner=self.owner)
            self.native.graph.add(empty)
        return self._nodes[full][0]

    def _drop_all(self) -> None:
        for full in list(self._nodes):
            self._drop(full)

    def _drop(self, full: str) -> None:
        node, key = self._nodes.pop(full, (None, ""))
        if node is not None:
            self.native.graph.remove(key)
            node.destroy_node()
