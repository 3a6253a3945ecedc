"""A native node that passes orders on to gateway_robot.py, and prints what it then gets."""

from __future__ import annotations

import os
import struct
import threading
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String, UInt8MultiArray

from bench.orders import Found, follow

# Layout, offset and length of the type, after the head of CDR.
BEFORE = 4 + 12


def main() -> None:
    """Follow the orders of the standard input."""
    rclpy.init()
    # Gateways must not take the listeners of two graphs for one node.
    node = rclpy.create_node(f"listener_{os.getpid()}")
    found: Found = []
    # The first order of each listener has a size of its own, as all hear the robot's answers.
    size = 64 + 4 * (os.getpid() % 1000)
    answered = threading.Event()

    def received(data: bytes) -> None:
        if len(data) == BEFORE + size:
            answered.set()
        found.append((struct.unpack_from("<Q", data, BEFORE)[0], time.time_ns()))

    node.create_subscription(UInt8MultiArray, "/bytes", received, 1000, raw=True)
    go = node.create_publisher(String, "/go", 10)

    def listen() -> None:
        # Both ways are there when the robot answers.
        while not answered.wait(0.2):
            go.publish(String(data=f"{size} 1 0"))
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
