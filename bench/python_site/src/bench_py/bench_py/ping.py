"""Sends a message on /ping, waits for its echo on /pong, and so on; prints the time of each (ms).

Arguments: bytes in a message, rounds.
"""

import sys
import time

import rclpy
from std_msgs.msg import UInt8MultiArray


def main() -> None:
    size, rounds = map(int, sys.argv[1:3])
    rclpy.init()
    node = rclpy.create_node("ping")
    publisher = node.create_publisher(UInt8MultiArray, "ping", 10)
    message = UInt8MultiArray(data=bytes(size))
    times: list[float] = []
    sent = 0.0

    def send() -> None:
        nonlocal sent
        sent = time.perf_counter()
        publisher.publish(message)

    def heard(echo: UInt8MultiArray) -> None:
        times.append((time.perf_counter() - sent) * 1000)
        if len(echo.data) != size:
            raise RuntimeError("an echo of another size")
        if len(times) < rounds:
            send()
        else:
            rclpy.shutdown()

    node.create_subscription(UInt8MultiArray, "pong", heard, 10)
    while not publisher.get_subscription_count() or not node.count_publishers("pong"):
        time.sleep(0.01)
    time.sleep(0.05)  # the other side hears of this one at its own time
    send()
    rclpy.spin(node)
    for each in times:
        print(f"{each:.4f}")
