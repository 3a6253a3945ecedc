#!/usr/bin/env python3
"""Drive with keys, as programs do that read a terminal: some look first, all read."""

import select
import sys
import termios
import threading
import tty

import rclpy
from geometry_msgs.msg import Twist


def key(settings):
    """Return the key that is pressed."""
    tty.setraw(sys.stdin.fileno())
    print("which key? ", end="", flush=True)
    pressed = sys.stdin.read(1)
    termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
    return pressed


def main():
    settings = termios.tcgetattr(sys.stdin)
    rclpy.init()
    node = rclpy.create_node("keys")
    publisher = node.create_publisher(Twist, "cmd_vel", 10)
    thread = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
    thread.start()
    node.create_timer(0.1, lambda: print("while it waits"))
    try:
        print("i: forward, k: stop")
        ready, _, _ = select.select([sys.stdin], [], [], 0.05)
        print("no key yet:", ready)
        while (pressed := key(settings)) != "\x03":
            message = Twist()
            message.linear.x = float(pressed == "i")
            publisher.publish(message)
    except KeyboardInterrupt:
        pass
    finally:
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
        print("and the terminal is as it was")


if __name__ == "__main__":
    main()
