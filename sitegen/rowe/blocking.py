"""An endpoint of rowe for ordinary programs: every call blocks until it is done."""

from __future__ import annotations

import asyncio
import contextlib
import math
import threading
from collections.abc import Callable, Coroutine
from typing import Any, Self, TypeVar

from sitegen.rowe.endpoint import AsyncEndpoint
from sitegen.rowe.message import Body, Message
from sitegen.rowe.outgoing import Outgoing

Result = TypeVar("Result")


class Endpoint:
    """An `AsyncEndpoint` in a thread of its own; its methods can be called from all threads."""

    def __init__(self) -> None:
        """Start the thread."""
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="rowe", daemon=True)
        self._thread.start()
        self._endpoint = self._run(_call(AsyncEndpoint))
        # The last port that `listen` returned, 0 before.
        self.port = 0

    def peers(self) -> list[str]:
        """Return the names of the peers that are connected now."""
        return self._endpoint.peers()

    def listen(self, port: int = 0, host: str = "127.0.0.1") -> int:
        """Accept connections, and return the port."""
        self.port = self._run(self._endpoint.listen(port, host))
        return self.port

    def connect(self, url: str, name: str = "") -> str:
        """Connect to a server, and again after a lost connection. Return the name of the peer."""
        return self._run(_call(lambda: self._endpoint.connect(url, name)))

    def send(self, body: Body, ttl: float = math.inf, *, to: str = "") -> bool:
        """Block until a message was sent (True) or discarded (False). See `AsyncEndpoint.send`."""
        return _settled(self._endpoint.put(body, {}, ttl, to, True), ttl)

    def async_send(self, body: Body, ttl: float = math.inf, *, to: str = "") -> None:
        """Queue a message to be sent, and return at once."""
        self._endpoint.async_send(body, ttl, to=to)

    def broadcast(self, body: Body, ttl: float = math.inf) -> list[str]:
        """Queue a message for each connected peer, and return their names."""
        return self._endpoint.broadcast(body, ttl)

    def receive(self, timeout: float | None = None) -> Message | None:
        """Block until there is a message and return it.

        Return None after `timeout` seconds, or when the endpoint is closed.
        """
        return self._endpoint.inbox.receive_blocking(timeout)

    def invoke(self, body: Body, timeout: float = 5, *, to: str = "") -> Message:
        """Send a request and block until its reply arrives. See `AsyncEndpoint.invoke`."""
        key, reply = self._endpoint.ask(body, timeout, to)
        try:
            return reply.result(_seconds(timeout))
        except TimeoutError:
            raise TimeoutError(f"no reply within {timeout} s") from None
        finally:
            self._endpoint.forget(key)

    def reply(self, request: Message, body: Body, ttl: float = math.inf) -> bool:
        """Block until the reply to a request was sent (True) or discarded (False)."""
        message = self._endpoint.put_reply(request, body, ttl, True)
        return _settled(message, ttl) if message else False

    def async_reply(self, request: Message, body: Body, ttl: float = math.inf) -> None:
        """Queue a reply to a request, and return at once."""
        self._endpoint.async_reply(request, body, ttl)

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


def open_local_endpoint(port: int = 0, host: str = "127.0.0.1") -> Endpoint:
    """Return an endpoint that accepts connections. Its `port` is the one given, or a free one."""
    endpoint = Endpoint()
    try:
        endpoint.listen(port, host)
    except BaseException:
        endpoint.close()
        raise
    return endpoint


def open_remote_endpoint(host: str, port: int) -> Endpoint:
    """Return an endpoint that connects to a server, and again after a lost connection."""
    endpoint = Endpoint()
    shown = f"[{host}]" if ":" in host else host
    try:
        endpoint.connect(f"ws://{shown}:{port}/")
    except BaseException:
        endpoint.close()
        raise
    return endpoint


def _settled(message: Outgoing, ttl: float) -> bool:
    sent = message.sent
    assert sent
    if ttl < math.inf:
        with contextlib.suppress(TimeoutError):
            return sent.result(_seconds(ttl))
        message.expire()
    return sent.result()


def _seconds(timeout: float) -> float | None:
    return None if timeout > threading.TIMEOUT_MAX else timeout


async def _call(function: Callable[[], Result]) -> Result:
    return function()
