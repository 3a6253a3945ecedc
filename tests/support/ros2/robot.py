"""A native node for tests of the gateway: topics, services, an action and parameters."""

from __future__ import annotations

import contextlib
import time
from typing import Any

import rclpy
from geometry_msgs.msg import Twist
from rclpy.action import ActionClient, ActionServer, CancelResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger
from test_msgs.action import Fibonacci

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
LOSSY = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)


class Robot(Node):  # type: ignore[misc]
    """Does little, but all kinds of it; "/heard" tells of what it was told."""

    def __init__(self) -> None:
        super().__init__("robot")
        self.declare_parameter("speed", 1.5)
        self.declare_parameter("names", ["a", "b"])
        group = ReentrantCallbackGroup()
        self.heard = self.create_publisher(String, "/heard", 100)
        self.map = self.create_publisher(String, "/map", LATCHED)
        self.map.publish(String(data="the map"))
        self.lossy = self.create_publisher(String, "/lossy", LOSSY)
        self.image = self.create_publisher(Image, "/image", 10)
        self.scan = self.create_publisher(LaserScan, "/scan", 10)
        self.secret = self.create_publisher(String, "/protected_door", LATCHED)
        self.secret.publish(String(data="secret"))
        self.flood = self.create_publisher(String, "/flood", 10)
        self.create_timer(0.1, self._tick)
        self.create_timer(0.005, lambda: self.flood.publish(String(data="x" * 100_000)))
        self.create_subscription(Twist, "/cmd_vel", self._drive, 10)
        self.create_subscription(String, "/tell", self._told, 100)
        self.create_service(SetBool, "/set", self._set)
        self.create_service(Trigger, "/call_back", self._call_back, callback_group=group)
        self.create_service(SetBool, "/protected/set", self._set)
        self.trigger = self.create_client(Trigger, "/of_client", callback_group=group)
        self.action = ActionServer(
            self,
            Fibonacci,
            "/fibonacci",
            self._fibonacci,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            callback_group=group,
        )
        self.client = ActionClient(self, Fibonacci, "/count", callback_group=group)
        self.create_service(Trigger, "/send_goal", self._send_goal, callback_group=group)

    def _tick(self) -> None:
        self.lossy.publish(String(data="lossy"))
        self.image.publish(Image(height=1, width=3, step=9, encoding="rgb8", data=bytes(range(9))))
        self.scan.publish(LaserScan(ranges=[1.0, float("nan"), float("inf"), 2.5]))

    def _told(self, message: Any) -> None:
        self.heard.publish(message)

    def _drive(self, twist: Any) -> None:
        self.heard.publish(String(data=f"drive {twist.linear.x:g} {twist.angular.z:g}"))

    def _set(self, request: Any, response: Any) -> Any:
        response.success, response.message = request.data, "from the robot"
        return response

    def _call_back(self, _: Any, response: Any) -> Any:
        if not self.trigger.wait_for_service(5):
            response.message = "no service"
            return response
        found = self.trigger.call(Trigger.Request())
        response.success, response.message = found.success, found.message
        return response

    def _send_goal(self, _: Any, response: Any) -> Any:
        if not self.client.wait_for_server(5):
            response.message = "no action"
            return response
        heard: list[Any] = []
        accepted = _wait(
            self.client.send_goal_async(
                Fibonacci.Goal(order=3),
                feedback_callback=lambda m: heard.append(list(m.feedback.sequence)),
            )
        )
        result = _wait(accepted.get_result_async())
        response.success = result.status == 4
        response.message = f"{list(result.result.sequence)} after {heard}"
        return response

    def _fibonacci(self, goal: Any) -> Any:
        sequence = [0, 1]
        for _ in range(goal.request.order):
            if goal.is_cancel_requested:
                goal.canceled()
                self.heard.publish(String(data="goal canceled"))
                return Fibonacci.Result(sequence=sequence)
            sequence.append(sequence[-1] + sequence[-2])
            goal.publish_feedback(Fibonacci.Feedback(sequence=sequence))
            time.sleep(0.05)
        goal.succeed()
        return Fibonacci.Result(sequence=sequence)


def _wait(future: Any) -> Any:
    end = time.monotonic() + 10
    while not future.done():
        assert time.monotonic() < end, "timed out"
        time.sleep(0.01)
    return future.result()


def main() -> None:
    rclpy.init()
    node = Robot()
    executor = MultiThreadedExecutor(8)
    executor.add_node(node)
    print("ready", flush=True)
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        executor.spin()


main()
