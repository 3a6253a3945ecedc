"""Play scenes of a publisher and a subscription, and print what each saw, in native ROS 2.

Scenes come as a JSON list on standard input, and what came of each is printed as a line of JSON;
tests/test_qos.py says what a scene is.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import rclpy
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
)
from std_msgs.msg import UInt8

SIDES = ("publisher", "subscription")
# How long anything may take (s).
LIMIT = 20


class Side:
    """A context with one node: two of them find each other as two programs would."""

    def __init__(self, name: str) -> None:
        self.context = Context()
        rclpy.init(context=self.context)
        self.node = rclpy.create_node(name, context=self.context)
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)


def profile(qos: dict[str, Any]) -> QoSProfile:
    """Return what `qos`, in the words of the page's protocol with times in ms, is to rclpy."""
    chosen: dict[str, Any] = {"depth": qos.get("depth", 10)}
    if qos.get("keepAll"):
        chosen["history"] = HistoryPolicy.KEEP_ALL
    reliable = qos.get("reliable", True)
    chosen["reliability"] = (
        ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT
    )
    if qos.get("transientLocal"):
        chosen["durability"] = DurabilityPolicy.TRANSIENT_LOCAL
    manual = qos.get("manual", False)
    chosen["liveliness"] = (
        LivelinessPolicy.MANUAL_BY_TOPIC if manual else LivelinessPolicy.AUTOMATIC
    )
    for key, name in (
        ("deadline", "deadline"),
        ("lifespan", "lifespan"),
        ("lease", "liveliness_lease_duration"),
    ):
        if key in qos:
            chosen[name] = Duration(seconds=qos[key] / 1000)
    return QoSProfile(**chosen)


def policy(status: Any) -> str:
    """Return the name of the last incompatible policy."""
    return str(status.last_policy_kind.name).removeprefix("RMW_QOS_POLICY_")


def met(seen: dict[str, Any]) -> bool:
    """Whether both sides have found each other, matching or not."""
    return all(f"{side} matched" in seen or f"{side} incompatible" in seen for side in SIDES)


def enough(heard: list[int], count: int) -> bool:
    """Whether so many were heard."""
    return len(heard) >= count


def until(done: Callable[[], bool], look: Callable[[], None]) -> None:
    """Look until it is done."""
    end = time.monotonic() + LIMIT
    while not done() and time.monotonic() < end:
        look()


def play(sides: tuple[Side, Side], topic: str, scene: dict[str, Any]) -> dict[str, Any]:
    """Play a scene and return what was heard and what events told last."""
    one, two = sides
    heard: list[int] = []
    seen: dict[str, list[Any]] = {}

    def note(name: str, *fields: str) -> Any:
        def callback(status: Any) -> None:
            seen[name] = [getattr(status, field) for field in fields]
            if name.endswith("incompatible"):
                seen[name].append(policy(status))

        return callback

    total = "total_count"
    matched = (total, "current_count")
    publisher_events = PublisherEventCallbacks(
        deadline=note("publisher deadline", total),
        liveliness=note("publisher liveliness", total),
        incompatible_qos=note("publisher incompatible", total),
        matched=note("publisher matched", *matched),
        use_default_callbacks=False,
    )
    subscription_events = SubscriptionEventCallbacks(
        deadline=note("subscription deadline", total),
        liveliness=note("subscription liveliness", "not_alive_count", "alive_count"),
        incompatible_qos=note("subscription incompatible", total),
        matched=note("subscription matched", *matched),
        message_lost=note("subscription lost", total),
        use_default_callbacks=False,
    )

    def look() -> None:
        one.executor.spin_once(0.002)
        two.executor.spin_once(0.002)

    publisher: Any = None
    subscription: Any = None
    for step, *values in scene["steps"]:
        if step == "advertise":
            publisher = one.node.create_publisher(
                UInt8, topic, profile(scene["offered"]), event_callbacks=publisher_events
            )
        elif step == "subscribe":
            subscription = two.node.create_subscription(
                UInt8,
                topic,
                lambda message: heard.append(message.data),
                profile(scene["requested"]),
                event_callbacks=subscription_events,
            )
        elif step == "publish":
            for value in values:
                publisher.publish(UInt8(data=value))
        elif step == "assert":
            publisher.assert_liveliness()
        elif step == "sleep":
            time.sleep(values[0] / 1000)
        elif step == "spin":
            end = time.monotonic() + values[0] / 1000
            while time.monotonic() < end:
                look()
        elif step == "meet":
            until(lambda: met(seen), look)
        elif step == "part":
            until(lambda: any(seen.get(f"{side} matched") == [1, 0] for side in SIDES), look)
        elif step == "hear":
            until(partial(enough, heard, values[0]), look)
        elif step == "unadvertise":
            one.node.destroy_publisher(publisher)
            publisher = None
        elif step == "unsubscribe":
            two.node.destroy_subscription(subscription)
            subscription = None
    if publisher:
        one.node.destroy_publisher(publisher)
    if subscription:
        two.node.destroy_subscription(subscription)
    return {"heard": heard, "events": seen}


def main() -> None:
    """Play all scenes of standard input."""
    sides = Side("one"), Side("two")
    for number, scene in enumerate(json.load(sys.stdin)):
        print(json.dumps(play(sides, f"/scene_{number}", scene)))


if __name__ == "__main__":
    main()
