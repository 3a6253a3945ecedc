"""Makes a node that logs a line: how long it took to import rclpy (ms)."""

import time

begun = time.perf_counter()

import rclpy  # noqa: E402

IMPORT = (time.perf_counter() - begun) * 1000


def main() -> None:
    rclpy.init()
    rclpy.create_node("hello").get_logger().info(f"{IMPORT:.1f}")
