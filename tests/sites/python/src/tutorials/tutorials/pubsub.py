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
        self.text = None
        self.sums = []

    def say(self):
        """Publish."""
        if self.count > len(self.sums):
            return
        self.publisher.publish(String(data=f"Hello {self.count} äöü 🤖"))
        self.numbers.publish(Float64MultiArray(data=[1.5 * self.count, -2.0]))
        self.count += 1

    def hear(self, message):
        """Remember what was heard."""
        self.text = message
        self.tell()

    def add(self, message):
        """Remember the sum."""
        self.sums.append(f"sum {sum(message.data)} of {message.data}")
        self.tell()

    def tell(self):
        """Print both, in an order that does not depend on the middleware."""
        if self.text and len(self.sums) == self.count:
            print(f"heard {self.text}", self.sums[-1], flush=True)
            self.text = None


def main():
    """Spin until all was heard."""
    rclpy.init()
    node = Both()
    print(node.get_fully_qualified_name(), node.publisher.topic_name)
    while len(node.sums) < 3 or node.text:
        rclpy.spin_once(node)
    node.timer.cancel()
    print("timer cancelled", node.timer.is_canceled())
    node.destroy_node()
    rclpy.shutdown()
    print("ok", rclpy.ok())
