"""Tries all that turtlesim does, and says what came of it."""

import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.srv import SetParameters
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_srvs.srv import Empty
from turtlesim_msgs.action import RotateAbsolute
from turtlesim_msgs.msg import Color, Pose
from turtlesim_msgs.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative


class Visitor(Node):
    """Knows the newest pose of the first turtle, and the color below it."""

    def __init__(self):
        super().__init__("visitor")
        self.pose = self.color = None
        self.create_subscription(Pose, "turtle1/pose", lambda pose: setattr(self, "pose", pose), 1)
        self.create_subscription(
            Color, "turtle1/color_sensor", lambda color: setattr(self, "color", color), 1
        )
        self.twists = self.create_publisher(Twist, "turtle1/cmd_vel", 1)

    def call(self, type, service, /, **fields):
        """Call a service and return what it answers."""
        client = self.create_client(type, service)
        client.wait_for_service()
        future = client.call_async(type.Request(**fields))
        rclpy.spin_until_future_complete(self, future)
        return future.result()

    def until(self, condition):
        """Wait until what is known of the turtle is as it should be."""
        self.pose = self.color = None
        while not (self.pose and self.color and condition()):
            rclpy.spin_once(self)

    def where(self):
        """Wait for news, and return them: place, heading, and the color below."""
        for _ in range(2):
            self.until(lambda: True)
        pose, color = self.pose, self.color
        return f"{pose.x:.2f} {pose.y:.2f} {pose.theta:.2f} on {color.r} {color.g} {color.b}"


def main():
    """Try everything once."""
    rclpy.init()
    visitor = Visitor()
    names = ("friend", "friend", "")
    print("spawned", [visitor.call(Spawn, "spawn", x=1.0, y=2.0, name=name).name for name in names])
    visitor.call(Kill, "kill", name="friend")
    visitor.call(Kill, "kill", name="nobody")
    print("left", [n for n, _ in visitor.get_topic_names_and_types() if n.endswith("pose")])

    visitor.call(SetPen, "turtle1/set_pen", r=250, g=10, b=20, width=7)
    visitor.call(TeleportRelative, "turtle1/teleport_relative", linear=2.0, angular=0.5)
    print("drew to", visitor.where())
    visitor.call(SetPen, "turtle1/set_pen", off=1)
    visitor.call(TeleportAbsolute, "turtle1/teleport_absolute", x=3.0, y=2.0, theta=-0.5)
    print("went to", visitor.where())
    visitor.call(TeleportAbsolute, "turtle1/teleport_absolute", x=20.0, y=2.0)
    print("stopped at", visitor.where())

    background = Parameter("background_r", value=33).to_parameter_msg()
    visitor.call(SetParameters, "turtlesim/set_parameters", parameters=[background])
    visitor.call(Empty, "clear")
    print("cleared", visitor.where())

    turn = ActionClient(visitor, RotateAbsolute, "turtle1/rotate_absolute")
    turn.wait_for_server()
    felt = []
    goal = turn.send_goal_async(
        RotateAbsolute.Goal(theta=0.5), lambda message: felt.append(message.feedback.remaining)
    )
    rclpy.spin_until_future_complete(visitor, goal)
    result = goal.result().get_result_async()
    rclpy.spin_until_future_complete(visitor, result)
    shrinks = felt == sorted(felt, reverse=True) and len(felt) > 10
    print(f"turned by {result.result().result.delta:.1f}, feedback shrinks: {shrinks}")

    twist = Twist()
    twist.linear.x = -1.0
    visitor.twists.publish(twist)
    visitor.until(lambda: visitor.pose.linear_velocity == -1.0)
    visitor.until(lambda: visitor.pose.linear_velocity == 0.0)
    print("drove back, and stopped by itself:", visitor.pose.x < 11)

    visitor.call(Empty, "reset")
    print("reset", visitor.where())
