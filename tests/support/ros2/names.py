"""Try names in native ROS 2 and print what became of each; tests/sites/qos does the same in C++.

An argument is a letter for what it names (n: a node, s: a namespace, t: a topic, c: a client's
service), a colon, and the name.
"""

from __future__ import annotations

import sys

import rclpy
from rcl_interfaces.srv import ListParameters
from std_msgs.msg import String


def outcome(node: rclpy.node.Node, what: str, name: str) -> str:
    """Return the full name of what was made."""
    if what == "n":
        return str(rclpy.create_node(name).get_fully_qualified_name())
    if what == "s":
        return str(rclpy.create_node("node", namespace=name).get_fully_qualified_name())
    if what == "t":
        return str(node.create_publisher(String, name, 1).topic_name)
    return str(node.resolve_service_name(node.create_client(ListParameters, name).srv_name))


def main() -> None:
    """Try all arguments."""
    rclpy.init(args=[])
    node = rclpy.create_node("talker", namespace="space")
    for argument in sys.argv[1:]:
        what, _, name = argument.partition(":")
        try:
            print(outcome(node, what, name))
        except Exception as error:  # whatever it says is what is compared
            print(str(error).partition(", at ")[0])
        print("--")


if __name__ == "__main__":
    main()
