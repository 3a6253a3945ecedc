"""Measure rowe: `serve`, or `play PORT TURNS`, which prints a delay (ms) and a rate (/s)."""

from __future__ import annotations

import json
import sys
import time
from statistics import median

from sitegen.rowe import open_local_endpoint, open_remote_endpoint

BATCH = 1000


def serve() -> None:
    """Reply to each request."""
    endpoint = open_local_endpoint()
    print(endpoint.port, flush=True)
    while message := endpoint.receive():
        if message.message_id:
            endpoint.async_reply(message, message.body)


def play(port: int, turns: int) -> None:
    """Measure requests one by one, and batches of messages."""
    endpoint = open_remote_endpoint("127.0.0.1", port)
    body = {"topic": "speed", "x": 0.25, "text": "x" * 60}
    delays = []
    for _ in range(turns + 50):
        begun = time.perf_counter()
        endpoint.invoke(body)
        delays.append(time.perf_counter() - begun)
    begun = time.perf_counter()
    for _ in range(max(1, turns // 50)):
        for _ in range(BATCH):
            endpoint.async_send(body)
        endpoint.invoke(body, 60)
    rate = max(1, turns // 50) * (BATCH + 1) / (time.perf_counter() - begun)
    print(json.dumps([median(delays[50:]) * 1e3, rate]), flush=True)
    endpoint.close()


if __name__ == "__main__":
    if sys.argv[1] == "serve":
        serve()
    else:
        play(int(sys.argv[2]), int(sys.argv[3]))
