"""Clients and servers of services, whose requests and responses are bytes."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from sitegen.gateway.native.endpoint import NativeError, Qos
from sitegen.gateway.native.part import Part, ignore
from sitegen.gateway.native.types import from_cdr, to_cdr

if TYPE_CHECKING:
    from sitegen.gateway.native.party import Party

# A new client looks for its service for so long (s).
_PATIENCE = 5.0


class Client(Part):
    """A client of a service."""

    kind = "client"
    _service: Any = None

    def __init__(self, party: Party, name: str, type_name: str, node: str | None) -> None:
        super().__init__(party, name, type_name, Qos(), node)
        self._waiting: dict[int, asyncio.Future[bytes]] = {}
        self._ready = False
        self._readiness: asyncio.Future[None] | None = None

    def call(self, request: bytes) -> asyncio.Future[bytes]:
        """Send a request and return its response; cancel the future to wait no longer.

        It is sent when the service is there, which a new client does not know at once.

        Raises:
            MalformedMessageError: `request` is no request of this type
        """
        future: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()

        def sent(done: asyncio.Future[None]) -> None:
            if not done.cancelled() and (error := done.exception()) and not future.done():
                future.set_exception(error)

        def send(waiting: asyncio.Future[None]) -> None:
            if not waiting.cancelled() and not future.done():
                self._native.spin.do(lambda: self._send(request, future)).add_done_callback(sent)

        if self._ready:
            self._native.spin.do(lambda: self._send(request, future)).add_done_callback(sent)
        else:
            if self._readiness is None:
                self._readiness = asyncio.ensure_future(self._wait())
            self._readiness.add_done_callback(send)
        return future

    async def _wait(self) -> None:
        limit = time.monotonic() + _PATIENCE
        while not await self.is_ready() and time.monotonic() < limit:
            await asyncio.sleep(0.02)
        self._ready, self._readiness = True, None

    async def is_ready(self) -> bool:
        """Return whether the service is there."""
        return await self._native.spin.do(
            lambda: self._entity is not None and bool(self._entity.service_is_ready())
        )

    async def close(self) -> None:
        """Remove it; nothing that is still being waited for is answered."""
        if self._readiness:
            self._readiness.cancel()
        await super().close()
        for future in self._waiting.values():
            future.cancel()
        self._waiting.clear()

    def take(self) -> Callable[[], None] | None:
        """Take a response, in the thread of ROS."""
        header, response = self.handle.take_response(self._service.Response)
        if header is None:
            return None
        sequence = header.request_id.sequence_number
        data = to_cdr(response)
        return lambda: self._answer(sequence, data)

    def _send(self, request: bytes, future: asyncio.Future[bytes]) -> None:
        if self._entity is None:
            raise NativeError("the client is closed")
        sequence = self.handle.send_request(from_cdr(request, self._service.Request))
        self._waiting[sequence] = future

    def _answer(self, sequence: int, data: bytes) -> None:
        future = self._waiting.pop(sequence, None)
        if future and not future.done():
            future.set_result(data)

    def _create(self, node: Any, kind: Any) -> Any:
        self._service = kind
        entity = node.create_client(kind, self.endpoint.name)
        self.handle = entity.handle
        self._native.spin.add(self)
        return entity


class Request:
    """A request to a service, in CDR."""

    def __init__(self, data: bytes, respond: Callable[[bytes], asyncio.Future[None]]) -> None:
        self.data = data
        self.respond = respond
        """Send the response; the future has a MalformedMessageError if it is none."""


class Server(Part):
    """A service."""

    kind = "service"
    _service: Any = None

    def __init__(
        self,
        party: Party,
        name: str,
        type_name: str,
        asked: Callable[[Request], None],
        node: str | None,
    ) -> None:
        super().__init__(party, name, type_name, Qos(), node)
        self._asked = asked

    def take(self) -> Callable[[], None] | None:
        """Take a request, in the thread of ROS."""
        request, header = self.handle.service_take_request(self._service.Request)
        if header is None:
            return None

        def respond(data: bytes) -> asyncio.Future[None]:
            return self._native.spin.do(lambda: self._respond(data, header.request_id))

        item = Request(to_cdr(request), respond)
        return lambda: self._asked(item)

    def _respond(self, data: bytes, request_id: Any) -> None:
        if self._entity is not None:
            response = from_cdr(data, self._service.Response)
            self.handle.service_send_response(response, request_id)

    def _create(self, node: Any, kind: Any) -> Any:
        self._service = kind
        entity = node.create_service(kind, self.endpoint.name, ignore)
        self.handle = entity.handle
        self._native.spin.add(self)
        return entity
