"""An endpoint of rowe for programs with threads: every call blocks until it is done."""

from __future__ import annotations

import asyncio
import math
import threading
from collections.abc import Callable, Coroutine
from typing import Any, Self, TypeVar

from sitegen.rowe.endpoint import AsyncEndpoint
from sitegen.rowe.message import Body, Message

Result = TypeVar("Result")


class Endpoint:
    """An `AsyncEndpoint` in a thread of its own; its methods can be called from all threads."""

    def __init__(self) -> None:
        """Start the thread."""
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="rowe", daemon=True)
        self._thread.start()
        self._endpoint = self._run(_call(AsyncEndpoint))

    @property
    def peers(self) -> list[str]:
        """The names of the peers that are connected now."""
        return self._endpoint.peers

    def listen(self, port: int = 0, host: str = "127.0.0.1") -> int:
        """Accept connections, and return the port."""
        return self._run(self._endpoint.listen(port, host))

    def connect(self, url: str, name: str = "") -> str:
        """Connect to a server, and again after a lost connection. Return the name of the peer."""
        return self._run(_call(lambda: self._endpoint.connect(url, name)))

    def send(self, body: Body, *, to: str = "", time_to_live: float = math.inf) -> bool:
        """Block until a message was sent (True) or discarded (False). See `AsyncEndpoint.send`."""
        return self._run(self._endpoint.send(body, to=to, time_to_live=time_to_live))

    def async_send(self, body: Body, *, to: str = "", time_to_live: float = math.inf) -> None:
        """Queue a message to be sent, and return at once."""
        send = self._endpoint.async_send
        self._run(_call(lambda: send(body, to=to, time_to_live=time_to_live)))

    def receive(self, timeout: float | None = None) -> Message | None:
        """Block until there is a message and return it. Return None after `timeout` seconds."""
        return self._run(self._endpoint.receive(timeout))

    def invoke(self, body: Body, *, to: str = "", time_to_live: float = 5) -> Message:
        """Send a request and block until its reply arrives. See `AsyncEndpoint.invoke`."""
        return self._run(self._endpoint.invoke(body, to=to, time_to_live=time_to_live))

    def reply(self, request: Message, body: Body, *, time_to_live: float = math.inf) -> bool:
        """Block until the reply to a request was sent (True) or discarded (False)."""
        return self._run(self._endpoint.reply(request, body, time_to_live=time_to_live))

    def async_reply(self, request: Message, body: Body, *, time_to_live: float = math.inf) -> None:
        """Queue a reply to a request, and return at once."""
        reply = self._endpoint.async_reply
        self._run(_call(lambda: reply(request, body, time_to_live=time_to_live)))

    def close(self) -> None:
        """Close all connections and end the thread."""
        if self._loop.is_closed():
            return
        self._run(self._endpoint.close())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    def __enter__(self) -> Self:
        """Return the endpoint, which is closed at the end of the block."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close the endpoint."""
        self.close()

    def _run(self, work: Coroutine[Any, Any, Result]) -> Result:
        return asyncio.run_coroutine_threadsafe(work, self._loop).result()


async def _call(function: Callable[[], Result]) -> Result:
    return function()
