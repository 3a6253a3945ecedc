"""A native node that publishes each line that it reads on "/tell", and prints what it hears."""

from __future__ import annotations

import contextlib
import sys
import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String


def main() -> None:
    rclpy.init()
    node = rclpy.create_node("talk")
    tell = node.create_publisher(String, "/tell", 1000)
    node.create_subscription(String, "/heard", lambda m: print(m.data, flush=True), 1000)

    def read() -> None:
        for line in sys.stdin:
            tell.publish(String(data=line.strip()))

    threading.Thread(target=read, daemon=True).start()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(node)


main()
