"""Quality of service and events."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.qos import (
    DurabilityPolicy,
    QoSProfile,
    ReliabilityPolicy,
    qos_check_compatible,
    qos_profile_sensor_data,
)
from rclpy.time import Time
from std_msgs.msg import String, UInt8


def main():
    """Meet, miss, and be late."""
    rclpy.init()
    node = rclpy.create_node("policies")
    heard = []
    kept = QoSProfile(depth=2, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    early = node.create_publisher(UInt8, "kept", kept)
    for value in (1, 2, 3):
        early.publish(UInt8(data=value))
    node.create_subscription(UInt8, "kept", lambda m: heard.append(m.data), kept)
    while len(heard) < 2:
        rclpy.spin_once(node)
    print("late joiner heard", heard)

    weak = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    told = []
    events = SubscriptionEventCallbacks(
        incompatible_qos=lambda event: told.append(
            (event.total_count, event.last_policy_kind.name)
        ),
        matched=lambda event: told.append(("matched", event.current_count)),
    )
    node.create_publisher(String, "strict", weak)
    node.create_subscription(String, "strict", print, 1, event_callbacks=events)
    while not told:
        rclpy.spin_once(node)
    print(told)

    deadline = QoSProfile(depth=1, deadline=Duration(seconds=0.1))
    missed = []
    events = SubscriptionEventCallbacks(deadline=lambda event: missed.append(event.total_count))
    slow = node.create_publisher(String, "slow", deadline)
    node.create_subscription(String, "slow", lambda m: None, deadline, event_callbacks=events)
    slow.publish(String())
    while not missed:
        rclpy.spin_once(node)
    print("missed a deadline", missed[0] >= 1)
    print(qos_check_compatible(qos_profile_sensor_data, kept))
    print(QoSProfile(depth=3))
    clock = node.get_clock()
    print(Time(seconds=3) - Time(seconds=1), clock.now() > Time(clock_type=clock.clock_type))
    rclpy.shutdown()
