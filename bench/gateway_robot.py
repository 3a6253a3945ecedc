"""A native node that publishes what "/go" orders (bench/orders.py), and notes what it gets."""

from __future__ import annotations

import array
import struct
import threading
import time
from collections.abc import Callable
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Float64MultiArray, String, UInt8MultiArray

from bench.native_listener import BEFORE
from bench.orders import Found, follow

# Makes so many bytes to send.
Fill = Callable[[int], bytes]


def main() -> None:
    """Publish, and follow the orders of the standard input, until the process is ended."""
    rclpy.init()
    node = rclpy.create_node("robot")
    found: Found = []

    def publishes(kind: Any, letter: str, fill: Fill, topic: str, orders: str) -> None:
        publisher = node.create_publisher(kind, topic, 10)

        def publish(size: int, count: int, period: float) -> None:
            rest = fill(size - 8)
            due = time.monotonic()
            for _ in range(count):
                data = array.array(letter, struct.pack("<Q", time.time_ns()) + rest)
                publisher.publish(kind(data=data))
                due += period
                time.sleep(max(0.0, due - time.monotonic()))

        def go(message: Any) -> None:
            size, count, period = message.data.split()
            threading.Thread(target=publish, args=(int(size), int(count), float(period))).start()

        node.create_subscription(String, orders, go, 10)

    def received(data: bytes) -> None:
        found.append((struct.unpack_from("<Q", data, BEFORE)[0], time.time_ns()))

    publishes(UInt8MultiArray, "B", bytes, "/bytes", "/go")
    publishes(Float64MultiArray, "d", _numbers, "/numbers", "/go_numbers")
    node.create_subscription(UInt8MultiArray, "/to_robot", received, 1000, raw=True)
    threading.Thread(target=follow, args=(found, lambda order: None), daemon=True).start()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        return


def _numbers(size: int) -> bytes:
    # As many digits as measured ones have.
    return array.array("d", (number / 7 for number in range(size // 8))).tobytes()


if __name__ == "__main__":
    main()
