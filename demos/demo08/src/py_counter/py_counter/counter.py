"""Counts on /count, twice a second."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32

PERIOD = 0.5  # seconds
STEP = 1


class Counter(Node):
    """A publisher and the timer that drives it."""

    def __init__(self):
        super().__init__("counter")
        self.publisher = self.create_publisher(Int32, "count", 10)
        self.timer = self.create_timer(PERIOD, self.count)
        self.number = 0

    def count(self):
        """Publish the next number."""
        self.publisher.publish(Int32(data=self.number))
        self.get_logger().info(f"Now it is {self.number}")
        self.number += STEP


def main():
    """Count until it is stopped."""
    rclpy.init()
    try:
        rclpy.spin(Counter())
    except (KeyboardInterrupt, ExternalShutdownException):
        print("Stopped")
