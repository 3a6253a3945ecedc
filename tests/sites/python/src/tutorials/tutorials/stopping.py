"""Spins until it is stopped; says how that ends."""

import rclpy


def main():
    """Spin."""
    rclpy.init()
    node = rclpy.create_node("stopping")
    try:
        node.get_logger().info("spinning")
        rclpy.spin(node)
    except KeyboardInterrupt:
        print("interrupted, ok:", rclpy.ok())
    finally:
        print("finally")
        node.destroy_node()
        rclpy.shutdown()  # that Stop ended it already does not count
