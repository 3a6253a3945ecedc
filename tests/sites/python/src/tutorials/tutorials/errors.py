"""What goes wrong, in the words of rclpy."""

import rclpy
from rclpy.context import Context
from std_msgs.msg import String, UInt8


def attempt(what):
    """Print how `what` fails."""
    try:
        what()
        print("worked")
    except Exception as error:
        print(type(error).__name__, str(error).partition(", at ")[0])


def main():
    """Fail in many ways, at last with an exception."""
    attempt(lambda: rclpy.create_node("early"))
    attempt(lambda: rclpy.init(args=["--ros-args", "--unknown"]))
    rclpy.init()
    attempt(rclpy.init)
    node = rclpy.create_node("fails")
    attempt(lambda: node.create_publisher(String, "a b", 1))
    attempt(lambda: node.create_publisher(String, "{foo}", 1))
    attempt(lambda: node.create_publisher(str, "text", 1))
    publisher = node.create_publisher(String, "text", 1)
    attempt(lambda: publisher.publish(UInt8()))
    attempt(lambda: publisher.publish(5))
    node.destroy_publisher(publisher)
    attempt(lambda: publisher.publish(String()))
    attempt(lambda: node.get_parameter("unknown"))
    timer = node.create_timer(0.01, lambda: 1 / 0)
    attempt(lambda: rclpy.spin_once(node, timeout_sec=5))
    timer.cancel()
    attempt(lambda: node.create_timer("soon", print))
    rclpy.shutdown()
    attempt(rclpy.shutdown)
    context = Context()
    rclpy.init(context=context)
    rclpy.shutdown(context=context)
    attempt(lambda: rclpy.shutdown(context=context))
    raise ValueError("at the end")
