"""Spins until it is stopped, beside threads that wait; says how that ends."""

from concurrent.futures import ThreadPoolExecutor

import rclpy

# Natively its thread ends with the program, and so here.
POOL = ThreadPoolExecutor()


def main():
    """Spin."""
    rclpy.init()
    node = rclpy.create_node("stopping")
    POOL.submit(node.get_name).result()
    try:
        node.get_logger().info("spinning")
        rclpy.spin(node)
    except KeyboardInterrupt:
        print("interrupted, ok:", rclpy.ok())
    finally:
        print("finally")
        node.destroy_node()
        rclpy.shutdown()  # that Stop ended it already does not count
