"""Says how it was started: its name, the topic it has, its arguments and its parameters."""

import sys

import rclpy
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String


def main():
    """Say it."""
    rclpy.init(args=sys.argv)
    node = rclpy.create_node("speaker", automatically_declare_parameters_from_overrides=True)
    publisher = node.create_publisher(String, "chatter", 10)
    print(node.get_fully_qualified_name(), publisher.topic_name, *remove_ros_args(sys.argv)[1:])
    for name, parameter in sorted(node.get_parameters_by_prefix("").items()):
        if name not in ("use_sim_time", "start_type_description_service"):
            print(name, repr(parameter.value))
    rclpy.shutdown()
