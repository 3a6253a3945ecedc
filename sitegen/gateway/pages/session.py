"""One page that has joined: what it is told of the native graph, and what it takes part in."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import json
import time
from collections import deque
from typing import Any

from aiohttp import WSMsgType
from aiohttp.web import WebSocketResponse

from sitegen.gateway.access import Access, RefusedError
from sitegen.gateway.names import HAVING
from sitegen.gateway.native import Native, NativeError, describe
from sitegen.gateway.pages.feeds import Feeds
from sitegen.gateway.pages.own import Owns
from sitegen.gateway.pages.remotes import Remotes
from sitegen.gateway.pages.wire import (
    InvalidMessageError,
    announced,
    is_name,
    number,
    parse,
    record,
    records,
)
from sitegen.gateway.people import Visitor
from sitegen.gateway.turns import Turn

# A page that sends nothing for so long is gone (s): it asks for the time every few seconds.
_SILENCE = 20.0
# Invalid messages before a page is let go, and answers that wait for it.
_FAULTS = 100
_WAITING = 100_000

# Types that a page asks for at once.
_TYPES = 1000

_numbers = itertools.count(1)
# By the name that pages give themselves: one that comes back replaces its lost connection.
_sessions: dict[str, Session] = {}
_closing: set[asyncio.Task[None]] = set()


async def run(socket: WebSocketResponse, access: Access, native: Native) -> None:
    """Serve a page until it leaves."""
    session = Session(socket, access, native)
    try:
        await session.run()
    finally:
        # To the end, though the server cancels this when the connection is gone.
        closing = asyncio.create_task(session.close())
        _closing.add(closing)
        closing.add_done_callback(_closing.discard)
        await asyncio.shield(closing)


class Session:
    """The connection of a page."""

    def __init__(self, socket: WebSocketResponse, access: Access, native: Native) -> None:
        self.name = f"page {next(_numbers)}"
        self._socket = socket
        self._access = access
        access.is_page = True
        self._visitor: Visitor | None = None
        # Whether the page is to be told who is there, and what has changed in the graph.
        self._people_changed = False
        self._graph_changed = True
        self._native = native
        self._party = native.join(self.name)
        self._wake = asyncio.Event()
        self._control: deque[str | bytes] = deque()
        self._waiting = 0
        self._feeds = Feeds(self._wake.set)
        self._owns = Owns(self._party, access, self._receive, self._record, self._refuse)
        self._remotes = Remotes(native, self._party, access, self._owns, self._feeds)
        self._page = ""
        self._faults = 0
        self._ended = False
        self._leaving: asyncio.Future[bool] | None = None

    async def run(self) -> None:
        """Exchange messages until the page leaves or is silent for too long."""
        if not await self._greet():
            return
        stop = self._native.watch(lambda come, gone: self._look())
        self._wake.set()
        sender = asyncio.create_task(self._send())
        self._access.ended.add_done_callback(self._end)
        try:
            while not self._ended and await self._take(await self._socket.receive(_SILENCE)):
                pass
        except TimeoutError:
            self._access.say(f"silent for {_SILENCE:.0f} s, let go")
        finally:
            self._access.ended.remove_done_callback(self._end)
            stop()
            sender.cancel()
            with contextlib.suppress(asyncio.CancelledError, ConnectionError):
                await sender

    async def close(self) -> None:
        """Remove everything of the page from the native graph."""
        if _sessions.get(self._page) is self:
            del _sessions[self._page]
        self._access.people.watchers.discard(self._tell)
        self._access.people.leave(self._access)
        self._owns.close()
        await self._party.close()
        if not self._socket.closed:
            with contextlib.suppress(Exception):
                await asyncio.wait_for(self._socket.close(), 1)

    def _end(self, ended: asyncio.Future[str]) -> None:
        """Tell the page why it has to go, and let it."""
        self._say({"op": "ended", "reason": ended.result()})
        self._ended = True
        asyncio.get_running_loop().call_later(0.2, self._leave)

    def _leave(self) -> None:
        # Ends the wait for the page's next message.
        self._leaving = asyncio.ensure_future(self._socket.close())

    async def _greet(self) -> bool:
        """Wait for the page's hello, and answer it; return whether it may stay."""
        await self._write(_json({"op": "challenge", "keys": self._access.needs_key}))
        # The server ends it if nothing comes.
        message = await self._socket.receive()
        try:
            hello = parse(message.data) if message.type == WSMsgType.TEXT else {}
            if hello.get("op") != "hello" or hello.get("version") != 1:
                raise RefusedError("it did not say hello")
            await self._access.enter(hello.get("key"))
        except (InvalidMessageError, RefusedError) as error:
            with contextlib.suppress(ConnectionError):
                await self._write(_json({"op": "ended", "reason": str(error)}))
            self._access.end(f"refused: {error}")
            return False
        page, before = hello.get("page"), None
        if isinstance(page, str) and 0 < len(page) <= 100:
            self._page = page
            before = _sessions.get(page)
            _sessions[page] = self
            if before:
                await before.close()
        people, native = self._access.people, self._native
        people.watchers.add(self._tell)
        who = before._visitor if before else None
        self._visitor = people.join(self._access, self._access.name, lambda: self._party.nodes, who)
        if people.shown:
            self._access.say(f"is visitor {self._visitor.number}")
        welcome = {
            "op": "welcome",
            "session": self._access.session,
            "time": time.time() * 1000,
            "rmw": native.rmw,
            "domain": native.domain,
            "distribution": native.distribution,
            "until": self._access.seconds_left,
            "you": self._visitor.number if people.shown else None,
        }
        await self._write(_json(welcome))
        self._access.shown.append(self._show)
        if turn := self._access.turn:
            self._show(turn)
        return True

    def _tell(self) -> None:
        """Tell who is there; a page that reads slowly gets only the last news of it."""
        self._people_changed = True
        self._wake.set()

    def _look(self) -> None:
        """Tell what has changed in the graph."""
        self._graph_changed = True
        self._wake.set()

    def _show(self, turn: Turn) -> None:
        """Tell whose turn it is, and when that of the page is (s from now)."""
        now = {"now": turn.now, "nowLeft": turn.now_left}
        mine = {"mineIn": turn.mine_in, "mineLeft": turn.mine_left}
        self._say({"op": "turn", **now, **mine})

    async def _take(self, message: Any) -> bool:
        """Handle a message of the page; return False at the end."""
        try:
            if message.type in (WSMsgType.TEXT, WSMsgType.BINARY):
                await self._access.pace(len(message.data))
            if message.type == WSMsgType.TEXT:
                await self._obey(parse(message.data))
            elif message.type == WSMsgType.BINARY:
                await self._deliver(message.data)
            else:
                return False
        except InvalidMessageError as error:
            self._faults += 1
            if self._faults == 1:
                self._access.say(f"sent {error}; it was dropped")
            if self._faults >= _FAULTS:
                self._access.say(f"sent {self._faults} invalid messages, let go")
                return False
        return True

    async def _obey(self, message: dict[str, Any]) -> None:
        op = message["op"]
        if op == "graph":
            await self._change(message)
        elif op == "open":
            rate = message.get("rate")
            period = int(1e9 / rate) if isinstance(rate, (int, float)) and rate >= 0.001 else 0
            await self._remotes.open(number(message.get("id")), period)
        elif op == "close":
            await self._remotes.close(number(message.get("id")))
        elif op == "credit":
            count, size = message.get("records"), message.get("bytes")
            if type(count) is not int or type(size) is not int or min(count, size) < 0:
                raise InvalidMessageError("an invalid credit")
            self._feeds.credit(count, size)
        elif op == "describe":
            names = message.get("types")
            if not isinstance(names, list) or len(names) > _TYPES or not all(map(is_name, names)):
                raise InvalidMessageError("an invalid list of types")
            self._say({"op": "types", "types": describe(names)})
        elif op == "ping":
            pong = {key: message.get(key) for key in ("id", "sent")}
            if not all(type(value) in (int, float) for value in pong.values()):
                raise InvalidMessageError("an invalid ping")
            self._say({"op": "pong", **pong, "time": time.time() * 1000})
        else:
            raise InvalidMessageError("an unknown message")

    async def _change(self, message: dict[str, Any]) -> None:
        gone, come = message.get("gone", []), message.get("come", [])
        if not isinstance(gone, list) or not isinstance(come, list):
            raise InvalidMessageError("an invalid graph")
        for id in gone:
            await self._owns.remove(number(id))
        if gone:
            await self._remotes.settle()
        for given in come:
            endpoint = announced(given)
            use = HAVING.get(endpoint.kind)
            reason = self._access.forbidden(use, endpoint.name) if use else ""
            try:
                if not reason:
                    await self._owns.add(endpoint)
            except NativeError as error:
                reason = str(error)
                self._access.refused(reason)
            if reason:
                self._refuse(endpoint.id, reason)
        self._access.people.changed()
        # Others may look at publishers of the page.
        self._look()

    async def _deliver(self, frame: bytes) -> None:
        futures = []
        for one in records(frame):
            await self._owns.settle(one)
            futures.append(self._owns.take(one))
        # The page goes on when the middleware has its messages: a publisher with a full history
        # holds back the page that it belongs to.
        for future in futures:
            if future is None:
                continue
            try:
                await future
            except NativeError as error:
                raise InvalidMessageError(str(error)) from None
            except asyncio.CancelledError:
                if not future.cancelled():
                    raise

    def _refuse(self, id: int, reason: str) -> None:
        self._say({"op": "refused", "id": id, "reason": reason})

    def _receive(self, topic: str, sample: Any) -> None:
        self._remotes.receive(topic, sample)

    def _record(self, reader: int, writer: int, sequence: int, data: bytes) -> None:
        self._queue(record(reader, writer, sequence, data, time.time() * 1000))

    def _say(self, message: dict[str, Any]) -> None:
        self._queue(_json(message))

    def _queue(self, item: str | bytes) -> None:
        if self._ended:
            return
        self._control.append(item)
        self._waiting += len(item)
        self._wake.set()
        if len(self._control) > _WAITING or self._waiting > self._access.rules.limits.queue_size:
            # It asks for much and reads nothing.
            self._access.end("does not read")
            self._control.clear()
            self._ended = True

    async def _send(self) -> None:
        """Send what waits, in one task: messages, then news of the graph, then answers."""
        while True:
            await self._wake.wait()
            self._wake.clear()
            while frame := self._feeds.frame():
                await self._socket.send_bytes(frame)
            if self._graph_changed:
                self._graph_changed = False
                for message in await self._remotes.news():
                    await self._write(_json(message))
            if self._people_changed:
                self._people_changed = False
                await self._write(self._access.people.message)
            while self._control:
                item = self._control.popleft()
                self._waiting -= len(item)
                await self._write(item)

    async def _write(self, item: str | bytes) -> None:
        if isinstance(item, str):
            await self._socket.send_str(item)
        else:
            await self._socket.send_bytes(item)


def _json(message: dict[str, Any]) -> str:
    return json.dumps(message, separators=(",", ":"))
