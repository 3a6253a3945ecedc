"""A publisher, a subscription and a timer; ends by itself."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64MultiArray, String


class Both(Node):
    """Says something, hears it, and stops after the third time."""

    def __init__(self):
        super().__init__("both")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.numbers = self.create_publisher(Float64MultiArray, "numbers", 10)
        self.create_subscription(String, "chatter", self.hear, 10)
        self.create_subscription(Float64MultiArray, "numbers", self.add, 10)
        self.timer = self.create_timer(0.05, self.say)
        self.count = 0
        self.heard = 0

    def say(self):
        """Publish."""
        if self.count == 3:
            self.timer.cancel()
            return
        self.publisher.publish(String(data=f"Hello {self.count} äöü 🤖"))
        self.numbers.publish(Float64MultiArray(data=[1.5 * self.count, -2.0]))
        self.count += 1

    def hear(self, message):
        """Print what was heard."""
        print(f"heard {message}", flush=True)
        self.heard += 1

    def add(self, message):
        """Print the sum."""
        print(f"sum {sum(message.data)} of {message.data}", flush=True)
        self.heard += 1


def main():
    """Spin until all was heard."""
    rclpy.init()
    node = Both()
    print(node.get_fully_qualified_name(), node.publisher.topic_name)
    while node.heard < 6:
        rclpy.spin_once(node)
    print("timer cancelled", node.timer.is_canceled())
    node.destroy_node()
    rclpy.shutdown()
    print("ok", rclpy.ok())
