#!/usr/bin/env python3
"""Reads what is typed in all the ways that programs do: by lines, as a password, key by key."""

import getpass
import os
import select
import sys
import termios
import threading
import tty

import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node("interpreted")

    def tell():
        print("meanwhile")
        timer.cancel()

    timer = node.create_timer(0.02, tell)
    threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()

    print(f"hello {input('name? ')}")
    print("number? ", end="", flush=True)
    print(f"twice {2 * int(sys.stdin.readline())}")
    print(f"a secret of {len(getpass.getpass('secret? '))}")

    before = termios.tcgetattr(sys.stdin)
    tty.setcbreak(sys.stdin.fileno())
    ready, _, _ = select.select([sys.stdin], [], [], 0.02)
    print(len(ready), "before any key")
    pressed = b""
    while pressed != b"q":
        ready, _, _ = select.select([sys.stdin], [], [])
        pressed = os.read(sys.stdin.fileno(), 8)
        print(len(ready), "key", *pressed)
    termios.tcsetattr(sys.stdin, termios.TCSADRAIN, before)

    for line in sys.stdin:
        print("line", line.rstrip())
    print("the end")
    rclpy.shutdown()


if __name__ == "__main__":
    main()
