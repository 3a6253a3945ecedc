"""Requests of the native graph to services of peers."""

from __future__ import annotations

import asyncio
import itertools
import time
from collections.abc import Callable
from contextlib import suppress

import zenoh
from zenoh import handlers

from sitegen.gateway.access import Access
from sitegen.gateway.native import NativeError, Request
from sitegen.gateway.zenoh.attachment import Attachment
from sitegen.gateway.zenoh.keys import Token

# Requests that wait for an answer.
_MOST = 1000
# A service may take as long as it wants; if its peer goes, the request ends by itself (s).
_PATIENCE = 24 * 3600.0


class Asking:
    """All requests that wait for the answers of peers."""

    def __init__(self, session: zenoh.Session) -> None:
        self._session = session
        self._loop = asyncio.get_running_loop()
        self._numbers = itertools.count(1)
        self._waiting = 0

    def call(self, token: Token, request: Request, access: Access) -> None:
        """Ask a service of a peer, and give its answer to the native client."""
        if self._waiting >= _MOST:
            access.refused("more calls at once than the limit; they were dropped")
            return
        answers: list[zenoh.Reply] = []

        def ended() -> None:
            self._waiting -= 1
            if answers:
                _respond(token, request, answers[0], access)

        attachment = Attachment(next(self._numbers), time.time_ns(), token.gid).packed()
        self._waiting += 1
        try:
            self._session.get(
                token.data_key,
                handlers.Callback(answers.append, lambda: self._later(ended), indirect=False),
                # Of several services of the same name, all are asked, as by rmw_zenoh.
                target=zenoh.QueryTarget.ALL_COMPLETE,
                consolidation=zenoh.ConsolidationMode.NONE,
                timeout=_PATIENCE,
                payload=request.data,
                attachment=attachment,
            )
        except zenoh.ZError as error:
            self._waiting -= 1
            access.refused(f"{token.name} was not called: {error}")

    def _later(self, call: Callable[[], None]) -> None:
        # In a thread of Zenoh; the loop may have ended.
        with suppress(RuntimeError):
            self._loop.call_soon_threadsafe(call)


def _respond(token: Token, request: Request, answer: zenoh.Reply, access: Access) -> None:
    if answer.ok is None:
        text = answer.err.payload.to_bytes().decode("utf-8", "replace") if answer.err else ""
        access.refused(f"{token.name} failed: {text}")
        return
    future = request.respond(answer.ok.payload.to_bytes())

    def done(future: asyncio.Future[None]) -> None:
        if not future.cancelled() and isinstance(error := future.exception(), NativeError):
            access.refused(f"{token.name}: {error}")

    future.add_done_callback(done)
