"""The operation of clients that call services: call_service."""

from __future__ import annotations

import asyncio
from functools import partial
from typing import Any

from sitegen.gateway.native import Client, NativeError, from_cdr, load_type, to_cdr
from sitegen.gateway.rosbridge import rosapi
from sitegen.gateway.rosbridge.decode import InvalidValueError, from_json
from sitegen.gateway.rosbridge.encode import to_cbor, to_json
from sitegen.gateway.rosbridge.operation import InvalidOperationError, graph_name, number, text
from sitegen.gateway.rosbridge.session import Operation, Session
from sitegen.gateway.rosbridge.typenames import full

# How long a call waits for the service, and for the response if the client does not say (s).
PATIENCE, TIMEOUT = 5.0, 60.0
LONGEST = 24 * 3600.0


class Calls:
    """The calls of one client; each service that it calls has one client in the graph."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._clients: dict[tuple[str, str], Client] = {}
        self._lock = asyncio.Lock()
        # By service: calls are sent in their order, whatever they have to wait for.
        self._order: dict[str, asyncio.Lock] = {}
        self._under_way = 0

    async def call(self, message: dict[str, Any]) -> None:
        """Call a service; the response comes later."""
        service = graph_name(message, "service")
        compression = text(message, "compression", "none")
        size = int(number(message, "fragment_size"))
        number(message, "timeout")
        limit = self._session.access.rules.limits.calls
        answer = {"op": "service_response", "service": message["service"]}
        if message.get("id") is not None:
            answer["id"] = message["id"]

        async def work() -> None:
            try:
                values = await self._values(service, message, cbor=compression == "cbor")
                done: dict[str, Any] = {**answer, "values": values, "result": True}
            except (NativeError, InvalidOperationError, TimeoutError) as error:
                why = str(error) or f"{service} did not respond in time"
                done = {**answer, "values": why, "result": False}
            finally:
                self._under_way -= 1
            self._session.send(done, compression=compression, fragment_size=size)

        self._under_way += 1
        if self._under_way > limit:
            self._under_way -= 1
            why = f"{limit} calls at once are the limit"
            self._session.send({**answer, "values": why, "result": False})
            return
        self._session.start(work(), message.get("id"))

    async def _values(self, service: str, message: dict[str, Any], *, cbor: bool) -> Any:
        args = message.get("args")
        if service.startswith(rosapi.PREFIX):
            answer = partial(rosapi.answer, self._session, service, args)
            if "param" not in service:
                return await answer()
            # Who sets a parameter and then gets it, gets what was set.
            return await self._session.asking.in_turn(rosapi.node_asked(args), answer)
        self._session.allow("call_services", service)
        timeout = min(number(message, "timeout") or TIMEOUT, LONGEST)
        async with self._turn(service):
            type_name = await self._type(service, message)
            client = await self._client(service, type_name)
            kind = load_type(type_name)
            response_to = client.call(to_cdr(_request(args, kind.Request)))
        async with asyncio.timeout(timeout):
            data = await response_to
        response = from_cdr(data, kind.Response)
        return to_cbor(response) if cbor else to_json(response)

    def _turn(self, service: str) -> asyncio.Lock:
        for name in [name for name, lock in self._order.items() if not lock.locked()]:
            del self._order[name]
        return self._order.setdefault(service, asyncio.Lock())

    async def _type(self, service: str, message: dict[str, Any]) -> str:
        # It may just be starting.
        there = await self._session.type_of("service", service, PATIENCE)
        if not there:
            raise InvalidOperationError(f"service {service} does not exist")
        if message.get("type"):
            wanted = full(message["type"], "srv")
            if wanted != there:
                raise InvalidOperationError(f"{service} has the type {there}, not {wanted}")
        return there

    async def _client(self, service: str, type_name: str) -> Client:
        async with self._lock:
            client = self._clients.get((service, type_name))
            if client is None:
                if len(self._clients) >= self._session.access.rules.limits.services:
                    oldest = next(iter(self._clients))
                    await self._clients.pop(oldest).close()
                client = await self._session.party.client(service, type_name)
                self._clients[service, type_name] = client
        end = asyncio.get_running_loop().time() + PATIENCE
        while not await client.is_ready():
            if asyncio.get_running_loop().time() > end:
                raise InvalidOperationError(f"service {service} is not available")
            await asyncio.sleep(0.01)
        return client


def _request(args: Any, kind: Any) -> Any:
    """Return the request; its fields may be given by name, or as a list in their order."""
    if isinstance(args, list) and args:
        names = list(kind.get_fields_and_field_types())
        if len(args) > len(names):
            raise InvalidValueError(f"expected {len(names)} arguments, found {len(args)}")
        args = dict(zip(names, args, strict=False))
    return from_json(args, kind)


def operations(session: Session) -> dict[str, Operation]:
    """Return the operations of this group."""
    return {"call_service": Calls(session).call}
