"""One HTTP server for pages and WebSockets."""

from __future__ import annotations

import asyncio
import os
import signal
import ssl
from collections import Counter
from collections.abc import Awaitable, Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from aiohttp import WSCloseCode, web

from sitegen.errors import SiteError
from sitegen.gateway import origins
from sitegen.gateway.access import Access, Guard
from sitegen.gateway.files import Files
from sitegen.gateway.keys import Keys
from sitegen.gateway.people import People
from sitegen.gateway.rules import Rules
from sitegen.gateway.stopping import Stopping
from sitegen.gateway.turns import Turns
from sitegen.shipped import CLIENTS

# Serves one client from its first message to its last.
Handler = Callable[[web.WebSocketResponse, Access, Any], Awaitable[None]]
# The protocol of sitegen's pages; clients without a protocol speak rosbridge.
PAGES = "sitegen.1"
# The path of programs without ROS.
ROWE = "/rowe"
# How often a silent client is asked whether it is still there (s).
HEARTBEAT = 20.0
LONGEST_REASON = 120


@dataclass
class Gateway:
    """The state that all connections share."""

    rules: Rules
    native: Any
    handlers: dict[str, Handler]
    write: Callable[[str], None]
    files: Files | None = None
    guard: Guard = field(default_factory=Guard)
    clients: dict[web.WebSocketResponse, Access] = field(default_factory=dict)
    # Connections that have not asked for anything yet.
    silent: set[web.RequestHandler] = field(default_factory=set)

    def application(self) -> web.Application:
        """Return the application that answers requests."""
        app = web.Application(client_max_size=64_000)
        app.router.add_get("/rowe/{name:expiringQueue|message|peer|rowe}.js", _rowe_module)
        app.router.add_get("/{path:.*}", self._answer)
        return app

    async def _answer(self, request: web.Request) -> web.StreamResponse:
        self.silent.discard(request.protocol)
        if request.headers.get("Upgrade", "").lower() == "websocket":
            return await self._connect(request)
        if self.files:
            return await self.files.answer(request)
        raise web.HTTPUpgradeRequired(
            text="this is a gateway of sitegen: connect with a WebSocket\n",
            headers={"Upgrade": "websocket"},
        )

    async def _connect(self, request: web.Request) -> web.WebSocketResponse:
        limits = self.rules.limits
        socket = web.WebSocketResponse(
            protocols=[name for name in self.handlers if name and not name.startswith("/")],
            heartbeat=HEARTBEAT,
            # Messages of ROS are hardly smaller, and the robot has other things to do.
            compress=False,
            max_msg_size=limits.message_size,
        )
        await socket.prepare(request)
        access = Access(self.rules, request.remote or "?", self.write, self.guard)
        if why := self._excluded(request):
            await self._leave(socket, access, f"refused: {why}", WSCloseCode.POLICY_VIOLATION)
            return socket
        self.clients[socket] = access
        handler = self.handlers.get(request.path) or self.handlers[socket.ws_protocol or ""]
        try:
            why = await self._serve(socket, access, handler)
        finally:
            del self.clients[socket]
        await self._leave(socket, access, why, WSCloseCode.OK)
        return socket

    def _excluded(self, request: web.Request) -> str:
        """Return why nobody from there can connect now, else ""."""
        limits = self.rules.limits
        origin = request.headers.get("Origin")
        if not origins.allows(origin, request.host, self.rules.origins):
            return f"pages of {origin} are not in 'origins' of gateway.yaml"
        addresses = Counter(access.address for access in self.clients.values())
        if len(self.clients) >= limits.connections:
            return f"all {limits.connections} connections are in use"
        if addresses[request.remote or "?"] >= limits.connections_per_address:
            return f"{limits.connections_per_address} connections from one address are the limit"
        return ""

    async def _serve(self, socket: web.WebSocketResponse, access: Access, handler: Handler) -> str:
        """Run the handler until the client leaves or has to go; return why."""
        work = asyncio.ensure_future(handler(socket, access, self.native))
        entering = asyncio.ensure_future(self._expect_key(access))
        try:
            ends: set[asyncio.Future[Any]] = {work, access.ended}
            await asyncio.wait(ends, return_when=asyncio.FIRST_COMPLETED)
            if access.ended.done():
                # The handler says good-bye, and ends what the client has begun.
                await asyncio.wait({work}, timeout=self.rules.limits.handshake)
                return access.ended.result()
            if error := work.exception():
                access.say(f"failed: {type(error).__name__}: {error}")
                return "the gateway failed"
            return "left"
        finally:
            entering.cancel()
            work.cancel()
            with suppress(asyncio.CancelledError, Exception):
                await work
            await access.close(_result(access.ended) or "left")

    async def _expect_key(self, access: Access) -> None:
        await asyncio.sleep(self.rules.limits.handshake)
        if not access.entered:
            access.end("no key came in time")

    async def _leave(
        self, socket: web.WebSocketResponse, access: Access, why: str, code: int
    ) -> None:
        access.say(why)
        if not socket.closed:
            reason = why.removeprefix("refused: ").encode()[:LONGEST_REASON]
            with suppress(asyncio.TimeoutError, ConnectionError):
                await asyncio.wait_for(socket.close(code=code, message=reason), 5)

    async def listen(
        self, host: str, port: int, tls: ssl.SSLContext | None = None
    ) -> tuple[web.AppRunner, asyncio.Server]:
        """Listen on `port`, 0 for any; return what has to be ended."""
        runner = web.AppRunner(self.application(), access_log=None, keepalive_timeout=30)
        await runner.setup()
        server = runner.server
        assert server is not None
        loop = asyncio.get_running_loop()

        def connected() -> asyncio.Protocol:
            if len(server.connections) >= 2 * self.rules.limits.connections + 100:
                return _Full()
            protocol = server()
            self.silent.add(protocol)
            loop.call_later(self.rules.limits.handshake, self._hurry, protocol)
            return protocol

        try:
            patience = self.rules.limits.handshake if tls else None
            listening = await loop.create_server(
                connected, host, port, ssl=tls, backlog=512, ssl_handshake_timeout=patience
            )
        except OSError as error:
            await runner.cleanup()
            # Names have errors of their own, with numbers below 0.
            number = error.errno or 0
            reason = os.strerror(number) if number > 0 else error.strerror
            why = f"cannot listen on {host} port {port}: {reason}"
            raise SiteError([f"{why}; choose others with --bind and --port"]) from None
        return runner, listening

    def _hurry(self, protocol: web.RequestHandler) -> None:
        if protocol in self.silent:
            self.silent.discard(protocol)
            protocol.force_close()

    async def close(self, why: str) -> None:
        """Let all clients go."""
        for access in self.clients.values():
            access.end(why)
        for _ in range(50):
            if not self.clients:
                return
            await asyncio.sleep(0.1)


def _result(future: asyncio.Future[str]) -> str:
    return future.result() if future.done() else ""


async def _rowe_module(request: web.Request) -> web.FileResponse:
    """Return a JavaScript module of rowe, which pages of every origin may import."""
    file = CLIENTS / "rowe" / f"{request.match_info['name']}.js"
    return web.FileResponse(file, headers={"Access-Control-Allow-Origin": "*"})


class _Full(asyncio.Protocol):
    """Ends connections that exceed what the server can hold."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        transport.close()


async def run(
    gateway: Gateway,
    host: str,
    port: int,
    *,
    tls: ssl.SSLContext | None,
    ready: Callable[[int], None],
) -> None:
    """Serve until SIGINT or SIGTERM; `ready` is called with the port."""
    runner, listening = await gateway.listen(host, port, tls)
    stopped = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM):
        # On Windows, Ctrl-C cancels this task instead.
        with suppress(NotImplementedError):
            loop.add_signal_handler(number, stopped.set)
    reading = asyncio.create_task(gateway.guard.turns.run()) if gateway.guard.turns else None
    ready(listening.sockets[0].getsockname()[1])
    try:
        await stopped.wait()
    finally:
        listening.close()
        if reading:
            reading.cancel()
        await gateway.close("the gateway is stopping")
        await runner.cleanup()


def site_files(folder: Path | None) -> Files | None:
    """Return the files of a built site. Raises: SiteError without a page in `folder`."""
    if folder is None:
        return None
    if not (folder / "index.html").is_file():
        raise SiteError([f"{folder}: no index.html here; build the site first: sitegen build"])
    return Files(folder)


def handlers() -> dict[str, Handler]:
    """Return what serves clients, by path or by subprotocol; "" is for those that name none."""
    from sitegen.gateway.pages import run as pages
    from sitegen.gateway.rosbridge import run as rosbridge
    from sitegen.gateway.rowe import run as rowe

    return {"": rosbridge, PAGES: pages, ROWE: rowe}


def guard(rules: Rules, native: Any, write: Callable[[str], None]) -> Guard:
    """Return what clients share. Raises: SiteError for a secret that cannot be read."""
    from sitegen.gateway.definitions import full_text

    return Guard(
        Keys(rules.keys) if rules.keys else None,
        Turns(rules.reservations, write) if rules.reservations else None,
        Stopping(native, rules.stop, write) if rules.stop else None,
        full_text if rules.recording else None,
        People(rules.people),
    )
