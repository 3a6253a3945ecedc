"""Sends back on /pong what it hears on /ping."""

import contextlib

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import UInt8MultiArray


def main() -> None:
    rclpy.init()
    node = rclpy.create_node("pong")
    publisher = node.create_publisher(UInt8MultiArray, "pong", 10)
    node.create_subscription(UInt8MultiArray, "ping", publisher.publish, 10)
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(node)
