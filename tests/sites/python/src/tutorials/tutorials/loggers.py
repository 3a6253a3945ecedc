"""Levels of loggers by their services, and who matches whom, told by events."""

import argparse
import threading
from functools import partial

import rclpy
from rcl_interfaces.msg import LoggerLevel
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.impl.logging_severity import LoggingSeverity
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String


class Matching(Node):
    """Says how many it has found."""

    def __init__(self):
        super().__init__("matching")
        told = PublisherEventCallbacks(matched=lambda info: self.tell("subscriptions", info))
        self.ours = self.create_publisher(String, "out", 10, event_callbacks=told)
        told = SubscriptionEventCallbacks(matched=lambda info: self.tell("publishers", info))
        self.create_subscription(String, "in", print, 10, event_callbacks=told)
        self.future = Future()

    def tell(self, who, info):
        """Print an event, and end the wait for it."""
        print(who, info.current_count, info.current_count_change, info.total_count)
        self.future.set_result(True)


def match(executor, node, act):
    """Do something that matches, and wait for the event."""
    node.future = Future()
    made = act()
    executor.spin_until_future_complete(node.future, 10)
    return made


def matched():
    """Let endpoints come and go."""
    node, other = Matching(), rclpy.create_node("other")
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    executor.add_node(other)
    for make, destroy, topic in (
        (
            lambda t: other.create_subscription(String, t, print, 10),
            other.destroy_subscription,
            "out",
        ),
        (lambda t: other.create_publisher(String, t, 10), other.destroy_publisher, "in"),
    ):
        made = [match(executor, node, partial(make, topic)) for _ in range(2)]
        for each in made:
            match(executor, node, partial(destroy, each))
    executor.shutdown()


class Talkative(Node):
    """Logs at all levels, itself and a child of its logger."""

    def __init__(self):
        super().__init__("talkative", enable_logger_service=True)
        self.child = self.get_logger().get_child("child")

    def enabled(self):
        """Return at which levels both log."""
        return [
            [level.name for level in LoggingSeverity if level and logger.is_enabled_for(level)]
            for logger in (self.get_logger(), self.child)
        ]


def levels(talkative):
    """Set levels from another node."""
    node = rclpy.create_node("setter")
    get = node.create_client(GetLoggerLevels, "talkative/get_logger_levels")
    put = node.create_client(SetLoggerLevels, "talkative/set_logger_levels")
    print(get.wait_for_service(10), put.wait_for_service(10))
    names = ["talkative", "talkative.child"]
    for parent, child in ((0, 0), (10, 40), (30, 10), (40, 40)):
        wanted = [
            LoggerLevel(name=n, level=v) for n, v in zip(names, (parent, child), strict=True) if v
        ]
        future = put.call_async(SetLoggerLevels.Request(levels=wanted))
        rclpy.spin_until_future_complete(node, future)
        print([(each.successful, each.reason) for each in future.result().results])
        future = get.call_async(GetLoggerLevels.Request(names=names))
        rclpy.spin_until_future_complete(node, future)
        print([(each.name, each.level) for each in future.result().levels], talkative.enabled())


def main(args=None):
    """Do both."""
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--quiet", action="store_true")
    known, others = parser.parse_known_args(args)
    with rclpy.init(args=others) as context:
        print(known.quiet, context.context.ok())
        matched()
        talkative = Talkative()
        executor = SingleThreadedExecutor()
        executor.add_node(talkative)
        thread = threading.Thread(target=executor.spin)
        thread.start()
        levels(talkative)
        executor.shutdown()
        thread.join()
    print(rclpy.ok())
