"""A native node that passes orders on to gateway_robot.py, and prints what it then gets."""

from __future__ import annotations

import struct
import threading
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String, UInt8MultiArray

from bench.orders import follow

# Layout, offset and length of the type, after the head of CDR.
BEFORE = 4 + 12


def main() -> None:
    """Follow the orders of the standard input."""
    rclpy.init()
    node = rclpy.create_node("listener")
    found: list[tuple[int, int]] = []

    def received(data: bytes) -> None:
        found.append((struct.unpack_from("<Q", data, BEFORE)[0], time.monotonic_ns()))

    node.create_subscription(UInt8MultiArray, "/bytes", received, 1000, raw=True)
    go = node.create_publisher(String, "/go", 10)

    def listen() -> None:
        # Both ways through the gateways are there when the robot answers.
        while not found:
            go.publish(String(data="16 1 0"))
            time.sleep(0.2)
        # What is still on its way.
        time.sleep(0.5)
        follow(found, lambda order: go.publish(String(data=order)))

    threading.Thread(target=listen, daemon=True).start()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        return


if __name__ == "__main__":
    main()
