"""Logs the messages on /chatter."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    """Subscribes to the talker's topic."""

    def __init__(self):
        super().__init__("listener")
        self.subscription = self.create_subscription(String, "chatter", self.on_message, 10)

    def on_message(self, message):
        """Log a message."""
        self.get_logger().info(f"I heard: '{message.data}'")


def main(args=None):
    """Run the node until it is stopped."""
    try:
        with rclpy.init(args=args):
            rclpy.spin(Listener())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == "__main__":
    main()
