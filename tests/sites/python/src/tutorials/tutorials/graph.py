"""Who is in the graph, as its nodes see it."""

import time

import rclpy
from rclpy.node import NodeNameNonExistentError
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Int32, String
from std_srvs.srv import Trigger


def attempt(question, *arguments):
    """Print the answer to a question, or why there is none."""
    name = getattr(question, "__name__", "question")
    try:
        answer = question(*arguments)
    except (NodeNameNonExistentError, ValueError, RuntimeError) as error:
        answer = f"{type(error).__name__}: {str(error).split(', at ')[0]}"
    if isinstance(answer, list):
        print(name, arguments)
        for each in sorted(answer):
            print("   ", each)
    else:
        print(name, arguments, answer)


def describe(infos):
    """Print what is known of endpoints."""
    for info in sorted(infos, key=lambda info: info.node_name):
        qos = info.qos_profile
        print(info.node_name, info.node_namespace, info.topic_type, info.endpoint_type.name)
        print(len(info.endpoint_gid), qos.reliability.name, qos.durability.name, qos.history.name)
        print(qos.deadline, qos.lifespan, qos.liveliness.name, qos.liveliness_lease_duration)


def main():
    """Ask all questions."""
    rclpy.init()
    one = rclpy.create_node("one", namespace="/space")
    two = rclpy.create_node("two")
    kept = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    kept.lifespan = rclpy.duration.Duration(seconds=2)
    loose = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    loose.deadline = rclpy.duration.Duration(seconds=5)
    one.create_publisher(String, "chatter", kept)
    gone = two.create_publisher(String, "/space/chatter", 10)
    two.create_publisher(Int32, "number", 10)
    two.create_subscription(String, "/space/chatter", print, loose)
    two.create_subscription(Int32, "number", print, 10)
    one.create_service(Trigger, "~/go", print)
    two.create_client(Trigger, "/space/one/go")
    while two.count_publishers("/space/chatter") < 2 or one.count_clients("~/go") < 1:
        time.sleep(0.1)

    attempt(one.get_topic_names_and_types)
    attempt(two.get_service_names_and_types)
    attempt(two.get_node_names_and_namespaces)
    attempt(two.get_node_names_and_namespaces_with_enclaves)
    attempt(two.get_fully_qualified_node_names)
    for node in [("one", "/space"), ("two", "/"), ("three", "/"), ("two", "space"), ("t w", "/")]:
        attempt(one.get_publisher_names_and_types_by_node, *node)
        attempt(one.get_subscriber_names_and_types_by_node, *node)
        attempt(one.get_service_names_and_types_by_node, *node)
        attempt(one.get_client_names_and_types_by_node, *node)
    for topic in ["chatter", "/space/chatter", "/number", "/nothing", "~", "a b"]:
        attempt(one.count_publishers, topic)
        attempt(one.count_subscribers, topic)
        attempt(one.count_services, topic)
    attempt(two.count_services, "/space/one/go")
    attempt(two.count_clients, "/space/one/go")
    describe(one.get_publishers_info_by_topic("chatter"))
    describe(one.get_subscriptions_info_by_topic("chatter"))
    raw = one.get_topic_names_and_types(no_demangle=True)
    print([each for each in raw if "space" in each[0] and "param" not in each[0]])
    print(len(one.get_publishers_info_by_topic("rt/number", no_mangle=True)))
    two.destroy_publisher(gone)
    while one.count_publishers("chatter") > 1:
        time.sleep(0.1)
    print("one left:", one.wait_for_node("/two", 10.0), one.wait_for_node("/nobody", 0.2))
    rclpy.shutdown()
