"""Ends with an error from below rclpy, while another one is handled; then what atexit keeps."""

import atexit

import rclpy
from std_msgs.msg import String


def wrong():
    """Fail when nobody cares."""
    raise ValueError("ignored")


def main():
    """Publish too late."""
    atexit.register(print, "last")
    atexit.register(wrong)
    atexit.register(print, "never")
    atexit.unregister(print)
    atexit.register(print, "at", "exit", sep="-")
    rclpy.init()
    node = rclpy.create_node("ending")
    publisher = node.create_publisher(String, "words", 10)
    with node.context.handle:
        node.context.handle.shutdown()
    try:
        raise LookupError("first")
    except LookupError:
        publisher.publish(String())
