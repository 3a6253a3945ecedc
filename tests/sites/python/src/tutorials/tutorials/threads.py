"""Waiting: a rate and a thread that spins, sleep, executors with threads, guard conditions."""

import queue
import threading
import time

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from std_msgs.msg import UInt8


def main():
    """Wait in all ways."""
    rclpy.init()
    node = rclpy.create_node("waits")
    thread = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
    thread.start()
    rate = node.create_rate(20)
    begin = time.monotonic()
    for turn in range(3):
        rate.sleep()
        print("turn", turn)
    print("took long enough", time.monotonic() - begin > 0.1)
    begin = time.monotonic()
    time.sleep(0.05)
    print("slept", time.monotonic() - begin >= 0.05)
    print(node.get_clock().sleep_for(rclpy.duration.Duration(seconds=0.05)))

    words = queue.Queue()
    worker = threading.Thread(target=lambda: [words.put(n) for n in range(3)], name="worker")
    worker.start()
    print([words.get(timeout=5) for _ in range(3)])
    worker.join()
    print("alive", worker.is_alive(), threading.current_thread().name)
    rclpy.shutdown()
    thread.join()

    rclpy.init()
    node = rclpy.create_node("many")
    group = ReentrantCallbackGroup()
    done = []
    publisher = node.create_publisher(UInt8, "numbers", 10)
    node.create_subscription(
        UInt8, "numbers", lambda m: done.append(m.data), 10, callback_group=group
    )
    guard = node.create_guard_condition(lambda: done.append("guard"))
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(node)
    guard.trigger()
    publisher.publish(UInt8(data=7))
    while len(done) < 2:
        executor.spin_once(timeout_sec=1)
    print(sorted(map(str, done)))
    executor.shutdown()
    rclpy.shutdown()
