"""A native node that publishes as it is told: "/go" has size, count and period (s) as text."""

from __future__ import annotations

import array
import struct
import threading
import time
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String, UInt8MultiArray


def main() -> None:
    """Publish until the process is ended."""
    rclpy.init()
    node = rclpy.create_node("robot")
    publisher = node.create_publisher(UInt8MultiArray, "/bytes", 10)

    def publish(size: int, count: int, period: float) -> None:
        rest = bytes(size - 8)
        due = time.monotonic()
        for _ in range(count):
            data = array.array("B", struct.pack("<Q", time.monotonic_ns()) + rest)
            publisher.publish(UInt8MultiArray(data=data))
            due += period
            time.sleep(max(0.0, due - time.monotonic()))

    def go(message: Any) -> None:
        size, count, period = message.data.split()
        threading.Thread(target=publish, args=(int(size), int(count), float(period))).start()

    node.create_subscription(String, "/go", go, 10)
    print("ready", flush=True)
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        return


if __name__ == "__main__":
    main()
