"""Computes within rclpy and never waits."""

import rclpy
from rclpy.serialization import serialize_message
from test_msgs.msg import UnboundedSequences


def main(args=None):
    """Serialize a message until it is interrupted."""
    rclpy.init(args=args)
    message = UnboundedSequences(string_values=["word"] * 5000)
    print("computing", flush=True)
    try:
        while True:
            serialize_message(message)
    except KeyboardInterrupt:
        print("interrupted, ok:", rclpy.ok())
    finally:
        print("finally")
