"""What the endpoints of parties have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from sitegen.gateway.native.endpoint import Endpoint, Kind, NativeError, Qos

if TYPE_CHECKING:
    from sitegen.gateway.native.party import Party


class Part:
    """An endpoint, made and destroyed in the thread of ROS."""

    kind: Kind
    handle: Any = None
    endpoint: Endpoint

    def __init__(self, party: Party, name: str, type_name: str, qos: Qos, node: str | None) -> None:
        self._party = party
        self._native = party.native
        self._type = type_name
        self._qos = qos
        self._node_name = node
        self._entity: Any = None
        self._node: Any = None
        full = node or self._native.node.get_fully_qualified_name()
        key = self._native.key(self.kind)
        self.endpoint = Endpoint(key, self.kind, full, name, type_name, "", qos, owner=party.owner)

    def make(self, kind: Any) -> None:
        """Make it, in the thread of ROS."""
        graph = self._native.graph
        topics = self.kind in ("publisher", "subscription")
        before = graph.gids(self.endpoint.name, self.kind) if topics else None
        try:
            self._node = self._party.native_node(self._node_name)
            self._entity = self._create(self._node, kind)
        except NativeError:
            raise
        except Exception as error:
            raise NativeError(str(error).splitlines()[0]) from None
        self.handle = self._entity.handle
        self.endpoint = graph.add(self.endpoint, before)

    async def close(self) -> None:
        """Remove it from the graph."""
        self._party.forget(self)
        await self._native.spin.do(self.destroy)

    def destroy(self) -> None:
        """Destroy it, in the thread of ROS."""
        entity, self._entity = self._entity, None
        if entity is None:
            return
        self._native.spin.remove(self)  # type: ignore[arg-type]
        self._native.graph.remove(self.endpoint.key)
        getattr(self._node, f"destroy_{self.kind}")(entity)

    def _create(self, node: Any, kind: Any) -> Any:
        raise NotImplementedError


def ignore(*_: Any) -> None:
    """Do nothing."""
