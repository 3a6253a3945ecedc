"""Waits in its only thread until it is stopped."""

import rclpy


def main():
    """Wait."""
    rclpy.init()
    node = rclpy.create_node("elder")
    print("waiting")
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        print("interrupted")
