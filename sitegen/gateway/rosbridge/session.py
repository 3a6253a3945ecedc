"""The state of one client, and what its operations share."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Awaitable, Callable, Coroutine
from typing import Any

import cbor2
from aiohttp import web

from sitegen.gateway.access import Access
from sitegen.gateway.asking import Asking
from sitegen.gateway.names import Use
from sitegen.gateway.native import Endpoint, Native, NativeError
from sitegen.gateway.rosbridge import png
from sitegen.gateway.rosbridge.fragments import Fragments, split
from sitegen.gateway.rosbridge.operation import InvalidOperationError
from sitegen.gateway.rosbridge.outbox import Outbox

Operation = Callable[[dict[str, Any]], Awaitable[None]]
LEVELS = ("none", "error", "warning", "info")


class Session:
    """One client: its operations, its party in the graph, and what is sent to it."""

    def __init__(self, socket: web.WebSocketResponse, access: Access, native: Native) -> None:
        self.access = access
        self.native = native
        self.party = native.join(f"rosbridge {access.session}")
        self.outbox = Outbox(socket, access)
        self.fragments = Fragments(access.rules.limits.message_size)
        self.asking = Asking()
        self.operations: dict[str, Operation] = {}
        # Called with endpoints that have come, and with those that have gone.
        self.watchers: list[Callable[[list[Endpoint], list[Endpoint]], None]] = []
        # Called when the client leaves, before its endpoints go.
        self.endings: list[Callable[[], Awaitable[None]]] = []
        self._level = LEVELS.index("error")
        self._tasks: set[asyncio.Task[None]] = set()
        self._fragmented = 0

    def set_level(self, level: str) -> None:
        """Send only statuses of this level and graver ones."""
        self._level = LEVELS.index(level)

    def status(self, level: str, text: str, identity: Any = None) -> None:
        """Tell the client something, if it wants to know of this level."""
        if LEVELS.index(level) <= self._level:
            self.tell(level, text, identity)

    def tell(self, level: str, text: str, identity: Any = None) -> None:
        """Tell the client something, whatever level it has chosen."""
        message = {"op": "status", "level": level, "msg": text}
        self.send(message if identity is None else {**message, "id": identity})

    def send(
        self, message: dict[str, Any], *, compression: str = "none", fragment_size: int = 0
    ) -> None:
        """Send a message that must not be left out."""
        if compression in ("cbor", "cbor-raw"):
            self.outbox.answer(cbor2.dumps(message))
            return
        text = json.dumps(message, separators=(",", ":"))
        for part in self.packed(text, compression, fragment_size):
            self.outbox.answer(part)

    def packed(self, text: str, compression: str, fragment_size: int) -> list[str]:
        """Return the messages that carry `text`."""
        if compression == "png":
            text = json.dumps({"op": "png", "data": png.encode(text)})
        if not fragment_size:
            return [text]
        self._fragmented += 1
        return list(split(text, fragment_size, f"{self.access.session}-{self._fragmented}"))

    def allow(self, use: Use, name: str) -> None:
        """Raise an InvalidOperationError if the client may not use `name`."""
        if why := self.access.refusal(use, name):
            raise InvalidOperationError(why)

    def start(self, work: Coroutine[Any, Any, None], identity: Any = None) -> asyncio.Task[None]:
        """Do something that takes time; its errors become statuses."""
        task = asyncio.create_task(self._guarded(work, identity))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return task

    async def _guarded(self, work: Coroutine[Any, Any, None], identity: Any) -> None:
        try:
            await work
        except (InvalidOperationError, NativeError) as error:
            self.status("error", str(error), identity)

    async def type_of(self, kind: str, name: str, patience: float = 0) -> str:
        """Return the type that a topic ("publisher") or a service has in the graph, or "".

        It may come within `patience` seconds.
        """
        end = asyncio.get_running_loop().time() + patience
        while True:
            if found := self._type(kind, name):
                return found
            await self.native.refresh()
            found = self._type(kind, name)
            if found or asyncio.get_running_loop().time() >= end:
                return found
            await asyncio.sleep(0.1)

    def _type(self, kind: str, name: str) -> str:
        for each in ("publisher", "subscription") if kind == "publisher" else (kind,):
            for endpoint in self.native.endpoints:
                if endpoint.kind == each and endpoint.name == name:
                    return endpoint.type
        return ""

    async def close(self) -> None:
        """End everything that the client has begun."""
        for ending in self.endings:
            try:
                await ending()
            except (NativeError, asyncio.CancelledError):
                continue
        for task in list(self._tasks):
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        await self.party.close()
