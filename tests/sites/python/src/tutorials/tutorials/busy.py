"""Computes and never waits, but cleans up."""

import rclpy


def main(args=None):
    """Compute until it is interrupted."""
    rclpy.init(args=args)
    print("ready")
    print("computing", flush=True)
    try:
        while True:
            pass
    except KeyboardInterrupt:
        print("interrupted, ok:", rclpy.ok())
    finally:
        print("finally")
