"""Says hello on /chatter twice a second."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class MinimalPublisher(Node):
    """Counts what it says."""

    def __init__(self):
        super().__init__("minimal_publisher")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.timer = self.create_timer(0.5, self.say_hello)
        self.count = 0

    def say_hello(self):
        """Publish a greeting and log it."""
        message = String()
        message.data = f"Hello, world! {self.count}"
        self.publisher.publish(message)
        self.get_logger().info(f"Publishing: '{message.data}'")
        self.count += 1


def main(args=None):
    """Run the node until it is stopped."""
    try:
        with rclpy.init(args=args):
            rclpy.spin(MinimalPublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        print("Goodbye")


if __name__ == "__main__":
    main()
