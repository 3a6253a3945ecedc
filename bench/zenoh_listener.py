"""A native node that passes orders on to gateway_robot.py, and prints what it then gets."""

from __future__ import annotations

import json
import struct
import sys
import threading
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String, UInt8MultiArray

# Layout, offset and length of the type, after the head of CDR.
BEFORE = 4 + 12
QUIET = 2.0


def main() -> None:
    """Follow the orders of the standard input."""
    rclpy.init()
    node = rclpy.create_node("listener")
    found: list[tuple[int, int]] = []

    def received(data: bytes) -> None:
        found.append((struct.unpack_from("<Q", data, BEFORE)[0], time.monotonic_ns()))

    node.create_subscription(UInt8MultiArray, "/bytes", received, 1000, raw=True)
    go = node.create_publisher(String, "/go", 10)

    def follow() -> None:
        while go.get_subscription_count() == 0:
            time.sleep(0.05)
        # The robot's publisher, through the gateways, finds the subscription a little later.
        time.sleep(2)
        print("ready", flush=True)
        for order in sys.stdin:
            found.clear()
            go.publish(String(data=order.strip()))
            count = int(order.split()[1])
            last = time.monotonic_ns()
            while len(found) < count and time.monotonic_ns() - last < QUIET * 1e9:
                time.sleep(0.01)
                last = max(last, found[-1][1] if found else last)
            print(json.dumps(found), flush=True)

    threading.Thread(target=follow, daemon=True).start()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        return


if __name__ == "__main__":
    main()
