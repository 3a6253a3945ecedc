"""Quality of service: who meets whom, who is told, who is late."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import (
    DurabilityPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
    qos_check_compatible,
    qos_profile_sensor_data,
)
from std_msgs.msg import String, UInt8


def play():
    """Do all of it."""
    rclpy.init()
    node = rclpy.create_node("policies")
    told = []

    def turn(until):
        while not until():
            rclpy.spin_once(node, timeout_sec=0.05)
        lines = sorted(told)
        told.clear()
        return lines

    # Who comes late gets the last ones.
    heard = []
    kept = QoSProfile(depth=2, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    early = node.create_publisher(UInt8, "kept", kept)
    for value in (1, 2, 3):
        early.publish(UInt8(data=value))
    node.create_subscription(UInt8, "kept", lambda m: heard.append(m.data), kept)
    turn(lambda: len(heard) >= 2)
    print("kept", *heard)

    # What does not fit is told on both sides.
    reliable = QoSProfile(depth=1)
    weak = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    slow = QoSProfile(depth=1, deadline=Duration(seconds=2))
    fast = QoSProfile(depth=1, deadline=Duration(seconds=1))
    by_topic = QoSProfile(
        depth=1,
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
        liveliness_lease_duration=Duration(seconds=1),
    )
    automatic = QoSProfile(
        depth=1,
        liveliness=LivelinessPolicy.AUTOMATIC,
        liveliness_lease_duration=Duration(seconds=1),
    )
    pairs = (weak, reliable), (reliable, kept), (slow, fast), (automatic, by_topic)
    for number, (offered, requested) in enumerate(pairs):
        topic = f"strict{number}"
        publisher = node.create_publisher(
            String,
            topic,
            offered,
            event_callbacks=PublisherEventCallbacks(
                incompatible_qos=lambda e: told.append(
                    f"offered {e.total_count} {e.total_count_change} {int(e.last_policy_kind)}"
                )
            ),
        )
        subscription = node.create_subscription(
            String,
            topic,
            print,
            requested,
            event_callbacks=SubscriptionEventCallbacks(
                incompatible_qos=lambda e: told.append(
                    f"requested {e.total_count} {e.total_count_change} {int(e.last_policy_kind)}"
                )
            ),
        )
        print(*turn(lambda: len(told) >= 2), publisher.get_subscription_count())
        node.destroy_publisher(publisher)
        node.destroy_subscription(subscription)
    for one, two in ((qos_profile_sensor_data, kept), (kept, reliable), (slow, fast)):
        print("compatible", int(qos_check_compatible(one, two)[0]))

    # Matched, and parted.
    publisher = node.create_publisher(
        String,
        "meeting",
        1,
        event_callbacks=PublisherEventCallbacks(
            matched=lambda e: told.append(
                f"publisher {e.total_count} {e.total_count_change}"
                f" {e.current_count} {e.current_count_change}"
            )
        ),
    )
    first = node.create_subscription(String, "meeting", print, 1)
    print(*turn(lambda: told))
    second = node.create_subscription(String, "meeting", print, 1)
    print(*turn(lambda: told))
    node.destroy_subscription(first)
    print(*turn(lambda: told))
    node.destroy_subscription(second)
    print(*turn(lambda: told))

    # Too late, and not alive any more.
    late = QoSProfile(depth=1, deadline=Duration(seconds=0.1))
    publisher = node.create_publisher(
        String,
        "late",
        late,
        event_callbacks=PublisherEventCallbacks(deadline=lambda e: told.append("offered deadline")),
    )
    subscription = node.create_subscription(
        String,
        "late",
        lambda m: None,
        late,
        event_callbacks=SubscriptionEventCallbacks(
            deadline=lambda e: told.append("requested deadline")
        ),
    )
    publisher.publish(String())
    print(*sorted(set(turn(lambda: len(set(told)) == 2))))
    node.destroy_publisher(publisher)
    node.destroy_subscription(subscription)
    manual = QoSProfile(
        depth=1,
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
        liveliness_lease_duration=Duration(seconds=0.2),
    )
    publisher = node.create_publisher(
        String,
        "alive",
        manual,
        event_callbacks=PublisherEventCallbacks(
            liveliness=lambda e: told.append(f"lost {e.total_count} {e.total_count_change}")
        ),
    )
    node.create_subscription(
        String,
        "alive",
        lambda m: None,
        manual,
        event_callbacks=SubscriptionEventCallbacks(
            liveliness=lambda e: told.append(f"alive {e.alive_count} not {e.not_alive_count}")
        ),
    )
    publisher.publish(String())
    print(*turn(lambda: told))
    print(*turn(lambda: len(told) >= 2))
    publisher.assert_liveliness()
    print(*turn(lambda: told))
    rclpy.shutdown()
