"""Executors and callback groups of one's own, and a thread that hears beside a loop."""

import os
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import rclpy
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from rclpy.executors import Executor, ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Header, String

# How many callbacks are enough.
ENOUGH = 6


class Talker(Node):
    """Says something again and again."""

    def __init__(self, group=None, period=0.03):
        super().__init__("talker")
        self.count = 0
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.timer = self.create_timer(period, self.say, callback_group=group)

    def say(self):
        """Say the next."""
        self.publisher.publish(String(data=f"hello {self.count}"))
        self.count += 1


class Listener(Node):
    """Notes what it hears."""

    def __init__(self):
        super().__init__("listener")
        self.heard = []
        self.create_subscription(String, "chatter", lambda m: self.heard.append(m.data), 10)


class TwoPools(Executor):
    """Has a pool for the nodes that matter, and one thread for the others."""

    def __init__(self):
        super().__init__()
        self.important = set()
        self.many = ThreadPoolExecutor(max_workers=os.cpu_count() or 4)
        self.single = ThreadPoolExecutor(max_workers=1)

    def add_important(self, node):
        """Run its callbacks in the pool."""
        self.important.add(node)
        self.add_node(node)

    def spin_once(self, timeout_sec=None):
        """Run one callback."""
        try:
            handler, _, node = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
        except StopIteration:
            return
        (self.many if node in self.important else self.single).submit(handler)

    def finish(self):
        """Let what runs end."""
        self.many.shutdown()
        self.single.shutdown()


class Sparing(CallbackGroup):
    """Has as many callbacks as it is granted, of which two are given back every now and then."""

    def __init__(self, node):
        super().__init__()
        self.granted = 2
        self.lock = threading.Lock()
        self.begun = self.ended = 0
        self.timer = node.create_timer(
            0.1, self.grant, callback_group=MutuallyExclusiveCallbackGroup()
        )

    def grant(self):
        """Allow two more."""
        with self.lock:
            self.granted = 2

    def can_execute(self, entity):
        """Return whether one more may run."""
        with self.lock:
            return self.granted > 0

    def beginning_execution(self, entity):
        """Count it."""
        with self.lock:
            if self.granted < 1:
                return False
            self.granted -= 1
            self.begun += 1
            return True

    def ending_execution(self, entity):
        """Count it."""
        with self.lock:
            self.ended += 1


def own_executor():
    """Run nodes in pools."""
    with rclpy.init():
        executor = TwoPools()
        listener, talker = Listener(), Talker()
        executor.add_important(listener)
        executor.add_node(talker)
        try:
            while len(listener.heard) < ENOUGH:
                executor.spin_once(timeout_sec=1.0)
        finally:
            executor.finish()
        print("by pools:", listener.heard[:ENOUGH])


def own_group():
    """Let a timer go slower than it would."""
    with rclpy.init():
        node = rclpy.create_node("sparing")
        group = Sparing(node)
        calls = []
        node.create_timer(0.005, lambda: calls.append(time.monotonic()), callback_group=group)
        executor = MultiThreadedExecutor(num_threads=3)
        executor.add_node(node)
        end = time.monotonic() + 0.35
        while time.monotonic() < end:
            executor.spin_once(timeout_sec=0.05)
        print("slower:", 4 <= len(calls) <= 8, 0 <= group.begun - group.ended <= 1)
        executor.shutdown()


class Receiver(threading.Thread):
    """Looks for topics and hears them, while the main thread does something else."""

    def __init__(self, values):
        super().__init__()
        self.values = values
        self.node = rclpy.create_node("receiver")
        self.known = set()

    def run(self):
        """Spin until the end."""
        try:
            while rclpy.ok():
                for name, types in self.node.get_topic_names_and_types():
                    if name not in self.known and types == ["std_msgs/msg/Header"]:
                        self.known.add(name)
                        self.node.create_subscription(Header, name, self.hear, 10)
                rclpy.spin_once(self.node, timeout_sec=0.05)
        except ExternalShutdownException:
            pass

    def hear(self, message):
        """Note it."""
        self.values.append(int(message.frame_id.partition("_")[0]))


def monitor():
    """A thread that spins, beside a loop that works and publishes."""
    rclpy.init()
    node = rclpy.create_node("source")
    publisher = node.create_publisher(Header, "some_data", 10)
    values = []
    thread = Receiver(values)
    thread.start()
    while thread.is_alive() and publisher.get_subscription_count() == 0:
        pass  # some programs do not sleep here either
    for number in range(ENOUGH):
        publisher.publish(Header(frame_id=f"{number}_data"))
        time.sleep(0.01)
    while len(values) < ENOUGH:
        time.sleep(0.01)
    print("beside:", values, thread.is_alive())
    node.destroy_node()
    rclpy.shutdown()
    thread.join()
    print("alive:", thread.is_alive())


def main():
    """Run all."""
    own_executor()
    own_group()
    monitor()
