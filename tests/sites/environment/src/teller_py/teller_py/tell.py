"""Prints environment variables, a line each, and one log message."""

import os

import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node("tell")
    for name in ("TEAM", "LANE", "DATA", "ROS_DISTRO", "ROS_VERSION"):
        print(name, os.environ.get(name, "(unset)"))
    node.get_logger().warning("hello")
    rclpy.shutdown()
