#!/usr/bin/env python3
"""A program that uses a module of its package, and a file that is installed beside it."""

import sys
from pathlib import Path

import rclpy
from ament_index_python.packages import get_package_share_directory
from mixed.words import GREETING
from std_msgs.msg import String


def main():
    """Greet whom the file names."""
    rclpy.init()
    node = rclpy.create_node("greeter")
    publisher = node.create_publisher(String, "greetings", 10)
    share = Path(get_package_share_directory("mixed"))
    name = (share / "config" / "name.txt").read_text().strip()
    publisher.publish(String(data=f"{GREETING}, {name}"))
    print(f"{GREETING}, {name}", Path(sys.argv[0]).name, (share / "copy" / "package.xml").exists())
    rclpy.shutdown()


if __name__ == "__main__":
    main()
