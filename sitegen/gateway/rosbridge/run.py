"""Serve a client of rosbridge from its first message to its last."""

from __future__ import annotations

import asyncio
import json
import math
from contextlib import suppress
from typing import Any

import cbor2
from aiohttp import WSMsgType, web

from sitegen.gateway.access import Access, RefusedError
from sitegen.gateway.native import Endpoint, Native, NativeError
from sitegen.gateway.rosbridge import actions, calls, goals, publishing, services, subscribing
from sitegen.gateway.rosbridge.operation import InvalidOperationError, text
from sitegen.gateway.rosbridge.session import LEVELS, Session

GROUPS = (publishing, subscribing, calls, services, goals, actions)
# How deeply fragments may be in fragments.
DEEPEST = 4
# The size of a message before the key, and how many may come.
LONGEST_BEFORE, MOST_BEFORE = 10_000, 20


async def run(socket: web.WebSocketResponse, access: Access, native: Native) -> None:
    """Serve a client until it leaves or `access` ends."""
    session = Session(socket, access, native)
    for group in GROUPS:
        session.operations.update(group.operations(session))
    access.turned.append(
        lambda mine: session.tell("info", f"your turn {'begins' if mine else 'has ended'}")
    )
    sending = asyncio.create_task(session.outbox.run())
    receiving = asyncio.create_task(_receive(socket, session))

    def changed(come: list[Endpoint], gone: list[Endpoint]) -> None:
        for watch in session.watchers:
            watch(come, gone)

    unwatch = native.watch(changed)
    try:
        if access.needs_key:
            challenge = 'this gateway needs a key: send {"op": "auth", "key": …} first'
            session.tell("info", challenge)
        else:
            await access.enter()
        ends: set[asyncio.Future[Any]] = {receiving, sending, access.ended}
        await asyncio.wait(ends, return_when=asyncio.FIRST_COMPLETED)
        if access.ended.done() and not socket.closed:
            session.tell("error", access.ended.result())
        elif receiving.done():
            await receiving
    finally:
        unwatch()
        for task in (receiving, sending):
            task.cancel()
        await session.close()
        with suppress(TimeoutError, ConnectionError):
            await asyncio.wait_for(session.outbox.flush(), 2)


async def _receive(socket: web.WebSocketResponse, session: Session) -> None:
    strangers = 0
    async for message in socket:
        if message.type not in (WSMsgType.TEXT, WSMsgType.BINARY):
            continue
        await session.access.pace(len(message.data))
        if not session.access.entered:
            strangers += 1
            if len(message.data) > LONGEST_BEFORE or strangers > MOST_BEFORE:
                session.access.refused("too much before a key")
                session.access.end("a key comes first")
                return
        await session.outbox.room()
        await _handle(session, message.data, 0)


async def _handle(session: Session, data: str | bytes, depth: int) -> None:
    """Do what one message asks for; whatever is wrong becomes a status."""
    identity: Any = None
    try:
        message = _parsed(data)
        identity = message.get("id")
        plain = isinstance(identity, str | int) or (
            isinstance(identity, float) and math.isfinite(identity)
        )
        if identity is not None and not plain:
            identity = None
            raise InvalidOperationError("'id' must be text or a number")
        await _do(session, message, depth)
    except RefusedError as error:
        session.tell("error", str(error), identity)
    except (InvalidOperationError, NativeError) as error:
        session.status("error", str(error), identity)


async def _do(session: Session, message: dict[str, Any], depth: int) -> None:
    op = message["op"]
    if op == "auth":
        await _enter(session, message)
    elif not session.access.entered:
        raise RefusedError("a key comes first")
    elif op == "fragment":
        if depth >= DEEPEST:
            raise InvalidOperationError("fragment: too many in each other")
        if (whole := session.fragments.add(message)) is not None:
            await _handle(session, whole, depth + 1)
    elif op == "set_level":
        level = text(message, "level")
        if level not in LEVELS:
            raise InvalidOperationError(f"set_level: the levels are {', '.join(LEVELS)}")
        session.set_level(level)
    elif op in session.operations:
        await session.operations[op](message)
    elif op != "status":
        raise InvalidOperationError(f"unknown operation '{op[:40]}'")


async def _enter(session: Session, message: dict[str, Any]) -> None:
    access = session.access
    if access.entered:
        return
    # Clients that only know the fields of rosauth have "mac" for it.
    await access.enter(message.get("key", message.get("mac")))
    left = access.seconds_left
    until = "" if left is None else f"; the key is good for {left:.0f} s"
    session.tell("info", f"entered{until}", message.get("id"))


def _parsed(data: str | bytes) -> dict[str, Any]:
    try:
        message = json.loads(data) if isinstance(data, str) else cbor2.loads(data)
        if isinstance(data, str) and "\\u" in data:
            # Half of a character, as "\\ud800", which nothing else takes.
            json.dumps(message, ensure_ascii=False).encode()
    except (ValueError, RecursionError, EOFError, OverflowError, MemoryError, TypeError):
        kind = "JSON" if isinstance(data, str) else "CBOR"
        raise InvalidOperationError(f"a message that is not {kind}") from None
    except cbor2.CBORError:
        raise InvalidOperationError("a message that is not CBOR") from None
    if not isinstance(message, dict) or not isinstance(message.get("op"), str):
        raise InvalidOperationError("a message without 'op'")
    return message
