"""Services of the native graph that peers can call."""

from __future__ import annotations

import asyncio
import time
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

import zenoh
from zenoh import handlers

from sitegen.gateway.native import Client, NativeError, Party
from sitegen.gateway.zenoh.attachment import Attachment, unpack
from sitegen.gateway.zenoh.keys import Token

# Requests that wait for the answers of one service.
_MOST = 1000


@dataclass
class _Service:
    """A service of the native graph."""

    token: Token
    # How peers ask it.
    queryable: Any
    # How this gateway asks it, made for the first request.
    client: asyncio.Task[Client] | None = None
    # Nodes that serve the same name are one service.
    count: int = 1
    answers: set[asyncio.Task[None]] = field(default_factory=set)


class Serving:
    """The services of the native graph that peers can call."""

    def __init__(self, session: zenoh.Session, party: Party) -> None:
        self._session = session
        self._party = party
        self._loop = asyncio.get_running_loop()
        self._services: dict[str, _Service] = {}

    async def add(self, token: Token) -> None:
        """Let peers call a service."""
        if known := self._services.get(token.data_key):
            known.count += 1
            return

        def asked(query: zenoh.Query) -> None:
            # In a thread of Zenoh; the loop may have ended.
            with suppress(RuntimeError):
                self._loop.call_soon_threadsafe(self._begin, token.data_key, query)

        handler = handlers.Callback(asked, indirect=False)
        queryable = self._session.declare_queryable(token.data_key, handler, complete=True)
        self._services[token.data_key] = _Service(token, queryable)

    async def remove(self, token: Token) -> None:
        """Let nobody call a service any more."""
        service = self._services.get(token.data_key)
        if service is None:
            return
        service.count -= 1
        if service.count == 0:
            del self._services[token.data_key]
            service.queryable.undeclare()
            _end(service)
            if service.client:
                with suppress(NativeError):
                    await (await service.client).close()

    def close(self) -> None:
        """Wait for no more answers."""
        for service in self._services.values():
            _end(service)

    def _begin(self, key: str, query: zenoh.Query) -> None:
        service = self._services.get(key)
        if service is None or len(service.answers) >= _MOST:
            # Without an answer, it ends with the query.
            return
        answer = asyncio.create_task(self._answer(service, query))
        service.answers.add(answer)
        answer.add_done_callback(service.answers.discard)

    async def _answer(self, service: _Service, query: zenoh.Query) -> None:
        token = service.token
        asked = unpack(query.attachment.to_bytes()) if query.attachment else None
        if service.client is None:
            making = self._party.client(token.name, token.type)
            service.client = asyncio.create_task(making)
        try:
            if asked is None or query.payload is None:
                raise NativeError("a request without an attachment of rmw_zenoh")
            client = await asyncio.shield(service.client)
            response = await client.call(query.payload.to_bytes())
        except NativeError as error:
            with suppress(zenoh.ZError):
                query.reply_err(str(error))
            return
        attachment = Attachment(asked.sequence, time.time_ns(), asked.gid).packed()
        with suppress(zenoh.ZError):
            query.reply(token.data_key, response, attachment=attachment)


def _end(service: _Service) -> None:
    """Wait for no more answers: their requests end without one."""
    for answer in service.answers:
        answer.cancel()
