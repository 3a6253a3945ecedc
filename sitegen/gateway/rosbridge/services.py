"""Operations of clients that offer services: advertise_service, service_response."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from sitegen.gateway.native import Request, Server, from_cdr, load_type, to_cdr
from sitegen.gateway.rosbridge.decode import from_json
from sitegen.gateway.rosbridge.encode import to_json
from sitegen.gateway.rosbridge.operation import InvalidOperationError, graph_name, text
from sitegen.gateway.rosbridge.session import Operation, Session
from sitegen.gateway.rosbridge.typenames import full

# Requests that the client has not answered yet; older ones are forgotten.
MOST = 1000


@dataclass
class Offered:
    """A service of the client."""

    server: Server
    type: str
    waiting: dict[str, Request] = field(default_factory=dict)


class Services:
    """The services of one client, by name."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._offered: dict[str, Offered] = {}
        self._numbers = itertools.count(1)

    async def advertise(self, message: dict[str, Any]) -> None:
        """Offer a service; one of the same name is replaced."""
        service = graph_name(message, "service")
        type_name = full(text(message, "type"), "srv")
        self._session.allow("advertise_services", service)
        if known := self._offered.pop(service, None):
            await known.server.close()
        limit = self._session.access.rules.limits.services
        if len(self._offered) >= limit:
            raise InvalidOperationError(f"advertise_service: {limit} services are the limit")
        load_type(type_name)
        server = await self._session.party.serve(service, type_name, self._asking(service))
        self._offered[service] = Offered(server, type_name)

    async def unadvertise(self, message: dict[str, Any]) -> None:
        """Offer it no more."""
        service = graph_name(message, "service")
        known = self._offered.pop(service, None)
        if known is None:
            raise InvalidOperationError(f"unadvertise_service: {service} is not advertised")
        await known.server.close()

    async def respond(self, message: dict[str, Any]) -> None:
        """Pass on the client's response."""
        service = graph_name(message, "service")
        known = self._offered.get(service)
        request = known.waiting.pop(str(message.get("id")), None) if known else None
        if known is None or request is None:
            raise InvalidOperationError(f"service_response: {service} has no such request")
        kind = load_type(known.type).Response
        if message.get("result") is False:
            # ROS has no way to say that a call has failed.
            why = str(message.get("values") or "failed")[:200]
            self._session.access.say(f"{service} has failed in the client: {why}")
            await request.respond(to_cdr(kind()))
            return
        await request.respond(to_cdr(from_json(message.get("values"), kind)))

    def _asking(self, service: str) -> Callable[[Request], None]:
        def asked(request: Request) -> None:
            known = self._offered.get(service)
            if known is None:
                return
            number = f"service_request:{service}:{next(self._numbers)}"
            known.waiting[number] = request
            while len(known.waiting) > MOST:
                del known.waiting[next(iter(known.waiting))]
            values = to_json(from_cdr(request.data, load_type(known.type).Request))
            self._session.send(
                {
                    "op": "call_service",
                    "id": number,
                    "service": service,
                    "type": known.type,
                    "args": values,
                }
            )

        return asked


def operations(session: Session) -> dict[str, Operation]:
    """Return the operations of this group."""
    services = Services(session)
    return {
        "advertise_service": services.advertise,
        "unadvertise_service": services.unadvertise,
        "service_response": services.respond,
    }
