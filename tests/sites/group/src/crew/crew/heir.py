"""Waits until the elder has ended, and then computes within rclpy and never waits."""

import time

import rclpy
from rclpy.serialization import serialize_message
from std_msgs.msg import String


def main():
    """Compute until it is interrupted."""
    rclpy.init()
    node = rclpy.create_node("heir")
    print("waiting")
    while "elder" not in node.get_node_names():
        time.sleep(0.01)
    while "elder" in node.get_node_names():
        time.sleep(0.01)
    message = String(data="word")
    print("computing", flush=True)
    try:
        while True:
            serialize_message(message)
    except KeyboardInterrupt:
        print("interrupted")
