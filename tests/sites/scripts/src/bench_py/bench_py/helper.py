import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionServer
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import SetBool


class Helper(Node):
    def __init__(self):
        super().__init__("helper")
        self.declare_parameter("gain", 2.0)
        self.said = self.create_publisher(String, "said", 10)
        self.create_timer(0.05, lambda: self.said.publish(String(data="grüße")))
        self.create_service(AddTwoInts, "add_two_ints", self.add)
        self.create_service(SetBool, "ask_page", self.ask)
        self.client = self.create_client(AddTwoInts, "/page/add")
        self.server = ActionServer(self, Fibonacci, "fibonacci", self.execute)

    def add(self, request, response):
        response.sum = request.a + request.b
        return response

    def ask(self, request, response):
        future = self.client.call_async(AddTwoInts.Request(a=20, b=22))
        future.add_done_callback(
            lambda done: self.get_logger().info(f"page says {done.result().sum}")
        )
        response.success = True
        return response

    def execute(self, goal):
        feedback = Fibonacci.Feedback(sequence=[0, 1])
        for index in range(1, goal.request.order):
            feedback.sequence.append(feedback.sequence[index] + feedback.sequence[index - 1])
            goal.publish_feedback(feedback)
        goal.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)


def main():
    rclpy.init()
    rclpy.spin(Helper())
