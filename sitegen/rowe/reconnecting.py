"""Keep a connection to a server: connect, and again after it was lost, with pauses that grow."""

from __future__ import annotations

import asyncio
import logging
import random
from collections.abc import Awaitable, Callable
from time import monotonic
from urllib.parse import urlsplit

import aiohttp

from sitegen.rowe.message import LONGEST

log = logging.getLogger("rowe")

# Seconds between attempts to connect, the last repeated.
PAUSES = (0.1, 0.2, 0.5, 1, 2, 5)
# Seconds between pings, by which both sides notice that a connection is gone.
HEARTBEAT = 15


def checked(url: str) -> None:
    """Raise ValueError unless this is the URL of a WebSocket."""
    try:
        parts = urlsplit(url)
        valid = parts.scheme in ("ws", "wss") and bool(parts.hostname) and parts.port != 0
    except ValueError:
        valid = False
    if not valid:
        raise ValueError(f"'{url}' is not the URL of a WebSocket; write it like 'ws://robot:9090/'")


async def keep_connected(
    url: str, name: str, run: Callable[[aiohttp.ClientWebSocketResponse], Awaitable[None]]
) -> None:
    """Run `run` with one connection after another, and say once when there is none."""
    attempt = 0
    told = False
    async with aiohttp.ClientSession() as session:
        while True:
            begun = monotonic()
            reason = ""
            try:
                async with session.ws_connect(
                    url, heartbeat=HEARTBEAT, max_msg_size=LONGEST
                ) as socket:
                    begun = monotonic()
                    if told:
                        log.warning("%s: connected", name)
                        told = False
                    await run(socket)
                # A server that accepts and leaves at once is asked less and less often, too.
                if monotonic() - begun > PAUSES[min(attempt, len(PAUSES) - 1)]:
                    attempt = 0
            except Exception as error:
                reason = str(error) or type(error).__name__
            if reason and not told:
                log.warning("%s: no connection, trying again: %s", name, reason)
                told = True
            pause = PAUSES[min(attempt, len(PAUSES) - 1)]
            attempt += 1
            # Programs that lost the same server do not all come back in the same instant.
            await asyncio.sleep(pause * random.uniform(0.75, 1))
