"""The same as program.py with the package websockets alone: text, without JSON or queues."""

from __future__ import annotations

import json
import sys
import time
from statistics import median

from websockets.sync.client import connect
from websockets.sync.server import ServerConnection, serve

BATCH = 1000


def echo(socket: ServerConnection) -> None:
    """Echo what begins like a request."""
    for message in socket:
        if message[:2] == '{"':
            socket.send(message)


def play(port: int, turns: int) -> None:
    """Measure echoes one by one, and batches of messages."""
    rest = json.dumps({"topic": "speed", "x": 0.25, "text": "x" * 60})
    request = '{"message_id": "0123456789abcdef0123456789abcdef", ' + rest[1:]
    with connect(f"ws://127.0.0.1:{port}/", compression=None) as socket:
        delays = []
        for _ in range(turns + 50):
            begun = time.perf_counter()
            socket.send(request)
            socket.recv()
            delays.append(time.perf_counter() - begun)
        begun = time.perf_counter()
        for _ in range(max(1, turns // 50)):
            for _ in range(BATCH):
                socket.send(" " + rest)
            socket.send(request)
            socket.recv()
        rate = max(1, turns // 50) * (BATCH + 1) / (time.perf_counter() - begun)
    print(json.dumps([median(delays[50:]) * 1e3, rate]), flush=True)


if __name__ == "__main__":
    if sys.argv[1] == "serve":
        with serve(echo, "127.0.0.1", 0, compression=None) as server:
            print(server.socket.getsockname()[1], flush=True)
            server.serve_forever()
    else:
        play(int(sys.argv[2]), int(sys.argv[3]))
