"""Bytes over Zenoh alone: `publish PORT` sends them, `listen PORT` prints when they were got."""

from __future__ import annotations

import json
import struct
import sys
import time

import zenoh
from zenoh import handlers

from bench.orders import Found, follow

KEY = "bytes"


def main(does: str, port: str) -> None:
    """Follow the orders of the standard input: size, count and period (s) as text."""
    publishes = does == "publish"
    settings = zenoh.Config()
    settings.insert_json5("scouting/multicast/enabled", "false")
    side = "listen" if publishes else "connect"
    settings.insert_json5(f"{side}/endpoints", json.dumps([f"tcp/127.0.0.1:{port}"]))
    with zenoh.open(settings) as session:
        if publishes:
            publish(session)
        else:
            listen(session)


def publish(session: zenoh.Session) -> None:
    block = zenoh.CongestionControl.BLOCK
    publisher = session.declare_publisher(KEY, congestion_control=block)
    print("ready", flush=True)
    for order in sys.stdin:
        size, count, period = order.split()
        rest = bytes(int(size) - 8)
        due = time.monotonic()
        for _ in range(int(count)):
            publisher.put(struct.pack("<Q", time.time_ns()) + rest)
            due += float(period)
            time.sleep(max(0.0, due - time.monotonic()))


def listen(session: zenoh.Session) -> None:
    found: Found = []

    def received(sample: zenoh.Sample) -> None:
        data = sample.payload.to_bytes()
        found.append((struct.unpack_from("<Q", data)[0], time.time_ns()))

    session.declare_subscriber(KEY, handlers.Callback(received, indirect=False))
    time.sleep(1)
    follow(found, lambda order: None)


if __name__ == "__main__":
    main(*sys.argv[1:])
