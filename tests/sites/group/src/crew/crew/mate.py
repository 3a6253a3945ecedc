"""Says who it is and hears the others; a thread of its own speaks."""

import sys
import threading
import time

import rclpy
from rclpy.logging import get_logger
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String

CALLS = []


def main():
    """Speak and listen until it is stopped."""
    CALLS.append(len(CALLS))
    rclpy.init()
    node = rclpy.create_node("mate")
    print("calls", len(CALLS), "words", remove_ros_args(sys.argv)[1:])
    me = threading.current_thread()
    print("main", me is threading.main_thread(), me.name, sys.modules["crew.mate"].CALLS is CALLS)
    publisher = node.create_publisher(String, "/words", 10)
    seen = set()

    def speak():
        while rclpy.ok():
            publisher.publish(String(data=node.get_namespace()))
            time.sleep(0.02)

    def hear(message):
        if message.data not in seen and message.data != node.get_namespace():
            seen.add(message.data)
            get_logger("ear").info(f"heard {message.data}")
            # What is imported late is its own, too.
            from crew import mate

            print("same", mate.CALLS is CALLS)

    node.create_subscription(String, "/words", hear, 10)
    threading.Thread(target=speak, daemon=True).start()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        print("interrupted", rclpy.ok())
    raise RuntimeError("over")
