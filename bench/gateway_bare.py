"""A WebSocket server that sends what a client orders (bench/orders.py), and notes what it gets."""

from __future__ import annotations

import asyncio
import struct
import threading
import time

from aiohttp import WSMsgType, web

from bench.orders import Found, follow

found: Found = []


async def answer(request: web.Request) -> web.WebSocketResponse:
    """Serve one client."""
    socket = web.WebSocketResponse(compress=False)
    await socket.prepare(request)
    async for message in socket:
        if message.type == WSMsgType.BINARY:
            found.append((struct.unpack_from("<Q", message.data)[0], time.time_ns()))
            continue
        size, count, period = message.data.split()
        rest = bytes(int(size) - 8)
        due = time.monotonic()
        for _ in range(int(count)):
            await socket.send_bytes(struct.pack("<Q", time.time_ns()) + rest)
            due += float(period)
            await asyncio.sleep(max(0.0, due - time.monotonic()))
    return socket


async def main() -> None:
    """Listen until the process is ended."""
    app = web.Application()
    app.router.add_get("/", answer)
    runner = web.AppRunner(app)
    await runner.setup()
    site = web.TCPSite(runner, "127.0.0.1", 0)
    await site.start()
    print(f"ws://localhost:{runner.addresses[0][1]}/", flush=True)
    threading.Thread(target=follow, args=(found, lambda order: None), daemon=True).start()
    await asyncio.Event().wait()


if __name__ == "__main__":
    asyncio.run(main())
