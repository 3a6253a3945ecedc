"""A native node that uses what the robot of robot.py has, and prints what comes of it as JSON."""

from __future__ import annotations

import contextlib
import json
import time
from collections.abc import Callable
from typing import Any

import rclpy
from rcl_interfaces.srv import GetParameters
from rclpy.action import ActionClient
from rclpy.executors import ExternalShutdownException
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String
from std_srvs.srv import SetBool
from test_msgs.action import Fibonacci

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
COUNT = 300
WINDOW = 50


def main() -> None:
    rclpy.init()
    node = rclpy.create_node("visitor")

    def until(check: Callable[[], object]) -> None:
        end = time.monotonic() + 30
        while not check():
            assert time.monotonic() < end, "timed out"
            rclpy.spin_once(node, timeout_sec=0.02)

    def done(future: Any) -> Any:
        until(future.done)
        return future.result()

    heard: list[str] = []
    maps: list[str] = []
    node.create_subscription(String, "/heard", lambda m: heard.append(m.data), 1000)
    node.create_subscription(String, "/map", lambda m: maps.append(m.data), LATCHED)
    tell = node.create_publisher(String, "/tell", 1000)
    setting = node.create_client(SetBool, "/set")
    reading = node.create_client(GetParameters, "/robot/get_parameters")
    counting = ActionClient(node, Fibonacci, "/fibonacci")
    until(lambda: maps)
    for ready in (setting.service_is_ready, reading.service_is_ready, counting.server_is_ready):
        until(ready)

    def echo() -> bool:
        tell.publish(String(data="settled"))
        rclpy.spin_once(node, timeout_sec=0.1)
        return bool(heard)

    until(echo)
    # The robot keeps no more than a hundred, natively as well.
    for number in range(COUNT):
        if number >= WINDOW:
            until(lambda: str(number - WINDOW) in heard)  # noqa: B023
        tell.publish(String(data=str(number)))
    until(lambda: heard[-1] == str(COUNT - 1))
    feedback: list[list[int]] = []
    goal = done(
        counting.send_goal_async(
            Fibonacci.Goal(order=3),
            feedback_callback=lambda m: feedback.append(list(m.feedback.sequence)),
        )
    )
    result = done(goal.get_result_async())
    speed = done(reading.call_async(GetParameters.Request(names=["speed"]))).values[0]
    told = {
        "nodes": sorted(node.get_node_names()),
        "publishers": {t: node.count_publishers(t) for t in ("/heard", "/map", "/protected_door")},
        "maps": maps,
        "heard": [text for text in heard if text != "settled"],
        "set": done(setting.call_async(SetBool.Request(data=True))).message,
        "result": list(result.result.sequence),
        "feedback": feedback,
        "speed": speed.double_value,
    }
    print(json.dumps(told), flush=True)
    # It stays in the graph until it is stopped.
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(node)


main()
