"""Native nodes that publish and subscribe to each other's topics, and send nothing: `N` of them."""

from __future__ import annotations

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String

# Topics that each node publishes.
TOPICS = 3


def main(count: int) -> None:
    """Be there until the process is ended."""
    rclpy.init()
    nodes = [rclpy.create_node(f"node_{number}") for number in range(count)]
    for number, node in enumerate(nodes):
        for topic in range(TOPICS):
            node.create_publisher(String, f"/node_{number}/topic_{topic}", 10)
            heard = f"/node_{(number + 1) % count}/topic_{topic}"
            node.create_subscription(String, heard, lambda message: None, 10)
    print("ready", flush=True)
    try:
        rclpy.spin(nodes[0])
    except (KeyboardInterrupt, ExternalShutdownException):
        return


if __name__ == "__main__":
    main(int(sys.argv[1]))
